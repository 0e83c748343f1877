#include "retiarius/campaign/normal.hpp"

#include <cmath>

namespace retiarius {

double normal_share(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace retiarius
