#include "tests/contact/distance_oracle.hpp"

namespace retiarius {
namespace {

TEST(DistanceMillions, OfRandomAndDegeneratePairs) {
  for (std::uint64_t seed = 100; seed < 110; ++seed) testing::check_random_distances(seed, 100000);
}

}  // namespace
}  // namespace retiarius
