// Where the time of a simulation went.
#pragma once

namespace retiarius {

// Wall time spent in parts of the work since the start, s.
struct WorkTimes {
  double assembly = 0.0;  // potential, gradient and Hessian, contact included
  double factor = 0.0;    // borders and constraints included
  double solve = 0.0;
  double contact = 0.0;  // all of barrier contact
  double search = 0.0;   // of this, for what may touch
};

}  // namespace retiarius
