// The standard normal distribution; its quantile is in statistics.hpp.
#pragma once

namespace retiarius {

// Share of all values below x.
double normal_share(double x);

}  // namespace retiarius
