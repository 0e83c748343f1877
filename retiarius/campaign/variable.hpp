// From uniform shares to the values of a variable, and to what it sets in the mission.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "retiarius/campaign/spec.hpp"

namespace retiarius {

// The inputs of a variable for shares in the open unit interval, as many as it has dimensions:
// - a variable of one number: the quantile;
// - uniform-attitude: yaw, pitch, roll in degrees, the attitude being Rz(yaw) Ry(pitch) Rx(roll);
//   all rotations are alike where yaw and roll are uniform and pitch has a uniform sine;
// - cone: angle from the axis and azimuth about it in degrees; the cosine of the angle is uniform.
//   Azimuth 0 is towards the coordinate axis that is farthest from the cone's, x before y before z.
std::vector<double> variable_inputs(const VariableSpec& variable, std::span<const double> shares);

// The TOML value that the mission gets for these inputs: a number or a list of three.
std::string variable_value(const VariableSpec& variable, std::span<const double> inputs);

}  // namespace retiarius
