// The scalar functions of barrier contact: the barrier over the gap, friction over the slip.
#pragma once

#include "retiarius/base/vec.hpp"

namespace retiarius {

// A function's value with its first and second derivative.
struct Jet {
  double value = 0.0, first = 0.0, second = 0.0;
};

// The barrier of Li et al. (2020, Eq. 6) over the gap g between surfaces, of range r:
//   b = -(g - r)^2 ln(g / r) for 0 < g < r, 0 beyond; infinite where g <= 0. In m2.
// It begins smoothly (b, b', b'' are 0 at g = r) and times a stiffness in N/m is an energy.
Jet barrier(double gap, double range);

// The gap at which the barrier's force -b' is `force` >= 0, in m: `range` where that is 0.
double gap_of_force(double force, double range);

// The barrier as Newton's matrix is to take it at `gap`, where `force`, in m, is foretold for the
// place that the step leads to: its value, minus that force, and the slope of b' from here to the
// gap that belongs to it, instead of b' and b''. The force counts as no less than a fiftieth and no
// more than fiftyfold the one here.
//
// The barrier is so bent that Newton's step from a gap that is much too small only doubles it, and
// that from one that is too wide leads through the surface. With the slope to the gap wanted a
// single step gets there. For -ln(g) this is the primal-dual iteration of interior point methods
// (Wright 1997), with the foretold force as the dual variable.
Jet foretold_barrier(double gap, double range, double force);

// Coulomb's friction made smooth (Li et al. 2020, Eq. 13): the integral over the slip u >= 0 of
//   f1(u) = 2 u/s - (u/s)^2 for u < s, 1 beyond,
// in m; times the normal force and the coefficient it is a potential. `first` is f1(u); `over` is
// f1(u) / u, finite at u = 0.
struct SlipJet {
  double value = 0.0, first = 0.0, second = 0.0, over = 0.0;
};
SlipJet smooth_slip(double slip, double smallest);

// How much of the curvature by which friction's potential lacks that of a quadratic Newton's matrix
// is to count, from 0 to 1: all where the slip goes on as `before`, where the last direction began.
//
// Beyond the smallest slip friction no longer grows, so that Newton's step for a point that comes
// to rest leads past the place of rest by as much as the point is away from it, and back, for ever.
// Where the slip has turned back it therefore counts as if friction grew with it (the quadratic of
// the same force that lies above the potential), and in between by the cosine of the turn: so do
// primal-dual iterations for the norm, with the direction of the force as the dual (Chan, Golub and
// Mulet 1999).
double share_of_newton(const Vec3& before, const Vec3& slip);

}  // namespace retiarius
