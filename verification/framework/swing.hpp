// Frequency of one mode from the samples of a simulation.
#pragma once

#include <vector>

namespace retiarius::verification {

// Square of the angular frequency (rad2/s2; negative: it grows) of a single mode sampled at every
// step h of the trapezoid (Newmark), whose own shift of frequency is taken out exactly: it turns
// by 2 atan(omega h / 2) a step, so that u(k+1) + u(k-1) = 2 (1 - q) / (1 + q) u(k) with
// q = (omega h / 2)^2. Fitted by least squares.
double squared_frequency(const std::vector<double>& samples, double h);

}  // namespace retiarius::verification
