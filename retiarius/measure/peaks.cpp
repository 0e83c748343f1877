#include "retiarius/measure/peaks.hpp"

#include <algorithm>

namespace retiarius {

void Peaks::see_shape(double time, const Readings& readings, double travel) {
  if (readings.mouth_area > mouth_area) {
    mouth_area = readings.mouth_area;
    mouth_area_time = time;
    mouth_area_travel = travel;
  }
  strain = std::max(strain, readings.peak_strain);
  if (readings.smallest_distance)
    smallest_distance =
        std::min(smallest_distance.value_or(kInfinity), *readings.smallest_distance);
}

void Peaks::see_step(int newton_iterations, double peak_tension) {
  ++steps;
  iterations += newton_iterations;
  tension = std::max(tension.value_or(-kInfinity), peak_tension);
}

void Peaks::see_touch(double time, const FirstTouch& touch) {
  if (first_contact) return;
  first_contact = time;
  first_touch = touch;
}

}  // namespace retiarius
