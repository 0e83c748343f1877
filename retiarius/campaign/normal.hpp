// The standard normal distribution.
#pragma once

namespace retiarius {

// Share of all values below x.
double normal_share(double x);

// The value that a share of all values, strictly between 0 and 1, lies below; the inverse of
// normal_share() within a few units of the last digit.
double normal_quantile(double share);

}  // namespace retiarius
