// The inextensible hanging thread: what guides folding.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// A thread of length L hangs between two points of one height at distance `span` < L. With
// u = span / 2a, a = H / w (horizontal tension over weight per length):
//   L = 2 a sinh u,  span = 2 a u,  sag = a (cosh u - 1),
// hence span / L = u / sinh u and sag / L = tanh(u / 2) / 2.
struct Catenary {
  double span_ratio = 1.0;   // span / L
  double sag_ratio = 0.0;    // sag / L
  double parameter = 0.0;    // u
  double horizontal = 0.0;   // H / (w L); infinite where the thread is straight
  double end_tension = 0.0;  // T / (w L) at the supports
};

// Throws Error unless 0 < span_ratio <= 1.
Catenary catenary_from_span(double span_ratio);
// Throws Error unless 0 <= sag_ratio < 1/2.
Catenary catenary_from_sag(double sag_ratio);

// The point at arc length s L (0 <= s <= 1) of the thread, from its first support: along the span
// and down, both over L.
struct CatenaryPoint {
  double along = 0.0, down = 0.0;
};
CatenaryPoint catenary_point(const Catenary& c, double s);

}  // namespace retiarius
