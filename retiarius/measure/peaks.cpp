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

void Peaks::see_step(double time, int newton_iterations, double peak_tension, bool touching) {
  ++steps;
  iterations += newton_iterations;
  tension = std::max(tension.value_or(-kInfinity), peak_tension);
  if (touching && !first_contact) first_contact = time;
}

}  // namespace retiarius
