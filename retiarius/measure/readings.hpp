// What can be read off the net's present shape.
#pragma once

#include <optional>

#include "retiarius/base/archive.hpp"
#include "retiarius/base/vec.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

struct Readings {
  double mouth_area = 0.0;         // projected along the axis, m2
  double mouth_vector_area = 0.0;  // m2
  double mouth_width = 0.0;        // m
  double perimeter_area = 0.0;     // of all perimeter nodes, projected along the axis, m2
  double peak_strain = 0.0;
  std::optional<double> smallest_distance;  // m, absent without bodies

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) {
    archive(mouth_area, mouth_vector_area, mouth_width, perimeter_area, peak_strain,
            smallest_distance);
  }
};

// All but the distance, which Clearance measures. axis: unit.
Readings read_net(const Network& network, const std::vector<Vec3>& x, const Vec3& axis);

}  // namespace retiarius
