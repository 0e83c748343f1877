#include "retiarius/measure/readings.hpp"

#include <algorithm>

#include "retiarius/forces/stretching.hpp"
#include "retiarius/measure/mouth.hpp"

namespace retiarius {

Readings read_net(const Network& network, const std::vector<Vec3>& x, const Vec3& axis) {
  Readings r;
  const std::vector<Vec3> mouth = polygon(x, network.corners);
  r.mouth_area = projected_area(mouth, axis);
  r.mouth_vector_area = area_vector(mouth).norm();
  r.mouth_width = width(mouth);
  r.perimeter_area = projected_area(polygon(x, network.perimeter), axis);
  r.peak_strain = -1.0;  // of a segment without length, the least there is
  for (const Segment& s : network.segments)
    r.peak_strain = std::max(r.peak_strain, axial_strain(x[s.a], x[s.b], s.rest_length));
  return r;
}

}  // namespace retiarius
