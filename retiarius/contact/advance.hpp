// Continuous collision detection by conservative advancement.
#pragma once

#include "retiarius/contact/point_motion.hpp"

namespace retiarius {

// How far a pair may move: the largest t in [0, 1] found such that on all of [0, t] its distance
// stays at or above separation + share (d(0) - separation). 1 where the whole motion is free; 0
// where d(0) <= separation. Never beyond the first time at which the distance falls to that bound,
// rounding included; where it falls, at most about a hundredth of the initial gap short of it,
// except for motions that need more than 256 advances (each is safe, the last is returned).
//
// From each t the motion goes on while a bound says that nothing can come too near: for any unit
// vector n the distance is at least min n.a_i - max n.b_j over the points of the two primitives,
// and each of these moves by its velocity at t and at most its largest acceleration. The second
// bound is the additive one (Li et al. 2021): the gap over the sum of both sides' largest speeds,
// the mean velocity of all points taken away. Neither supposes anything about the accuracy of
// closest points, so nearly parallel edges are as safe as others.
//
// separation: least distance, m (a share of the sum of radii); share in (0, 1).
double advance(const PairMotion& motion, double separation, double share = 0.1);

}  // namespace retiarius
