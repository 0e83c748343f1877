// Threads that wind at random.
#pragma once

#include <vector>

#include "retiarius/net/network.hpp"
#include "tests/contact/pair_samples.hpp"

namespace retiarius::testing {

// Adds a thread of segments of 0.1 m that begins within `size` of the origin along each axis.
inline void add_thread(Network& net, std::vector<Vec3>& x, Stream& random, double size,
                       int segments) {
  Vec3 place = random.vector(size), way = random.direction();
  for (int k = 0; k <= segments; ++k) {
    x.push_back(place);
    const auto node = static_cast<Index>(x.size()) - 1;
    if (k > 0) net.segments.push_back({node - 1, node, 0.1, 0, 0});
    way = (way + 0.5 * random.direction()).normalized();
    place += 0.1 * way;
  }
  net.design = x;
}

}  // namespace retiarius::testing
