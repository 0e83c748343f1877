// The smallest value over time of something that changes no faster than a known rate.
#pragma once

#include <functional>

namespace retiarius::check {

struct Least {
  double value = 0.0;  // the smallest that was seen, or `enough`
  double time = 0.0;   // where
  bool resolved = true;
};

// Searches t in [0, 1] for the smallest value of f, |df/dt| <= rate, where it is below `enough`: no
// value is missed that lies more than `resolution` below what is returned. Gives up, unresolved,
// after 100,000 values.
Least least_over_time(const std::function<double(double)>& f, double rate, double enough,
                      double resolution);

}  // namespace retiarius::check
