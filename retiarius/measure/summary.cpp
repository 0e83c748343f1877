// The measures of a run as names, units and values.
#include "retiarius/measure/run_measures.hpp"

namespace retiarius {

namespace {

Measure measure(const char* name, const char* unit, double value) { return {name, unit, value}; }

template <typename Value>
Measure measure(const char* name, const char* unit, const std::optional<Value>& value) {
  if (!value) return {name, unit, std::monostate{}};
  return {name, unit, *value};
}

Measure first_touched(const char* name, const Peaks& peaks, Index index) {
  if (!peaks.first_contact || index == kNone) return {name, "", std::monostate{}};
  return {name, "", std::int64_t{index}};
}

Measure first_touched(const char* name, const Peaks& peaks, double place) {
  if (!peaks.first_contact) return {name, "m", std::monostate{}};
  return {name, "m", place};
}

}  // namespace

Measures RunMeasures::summary() const {
  const auto [capture, quality] = wrapping(nodes_, poses_);
  const bool closed = closure_.closed();
  std::optional<double> share;
  std::optional<bool> success;
  if (capture) {
    share = capture->share;
    success = capture->share > 0.9 && capture->center_inside && closed;
  }
  std::optional<double> settling_time;
  if (const auto settled = quality_.time()) settling_time = *settled - *whole_.first_contact;
  std::optional<double> widest_travel;
  if (!shot_corners_.empty()) widest_travel = whole_.mouth_area_travel;
  return {
      measure("mouth_area_flat", "m2", flat_area_),
      measure("mouth_width_flat", "m", flat_width_),
      measure("mouth_area_max", "m2", whole_.mouth_area),
      measure("mouth_area_max_time", "s", whole_.mouth_area_time),
      measure("mouth_area_max_travel", "m", widest_travel),
      measure("mouth_area_final", "m2", readings_.mouth_area),
      measure("mouth_vector_area_final", "m2", readings_.mouth_vector_area),
      measure("mouth_width_final", "m", readings_.mouth_width),
      measure("peak_tension", "N", whole_.tension),
      measure("peak_tension_20ms", "N", window_.largest()),
      measure("peak_strain", "", whole_.strain),
      measure("first_contact_time", "s", whole_.first_contact),
      first_touched("first_contact_thread", whole_, whole_.first_touch.thread),
      first_touched("first_contact_body", whole_, whole_.first_touch.body),
      first_touched("first_contact_x", whole_, whole_.first_touch.place.x()),
      first_touched("first_contact_y", whole_, whole_.first_touch.place.y()),
      first_touched("first_contact_z", whole_, whole_.first_touch.place.z()),
      measure("smallest_distance", "m", whole_.smallest_distance),
      measure("captured_share", "", share),
      measure("capture_quality_final", "", quality),
      measure("capture_quality_settled", "", quality_.value()),
      measure("capture_quality_settling_time", "s", settling_time),
      {"closed", "", closed},
      measure("success", "", success),
      measure("linear_momentum_drift", "", linear_.value()),
      measure("angular_momentum_drift", "", angular_.value()),
      {"steps", "", steps_},
      {"newton_iterations", "", iterations_},
      {"substeps", "", substeps_},
      {"unconverged_steps", "", unconverged_},
  };
}

Measures RunMeasures::phase_summary() const {
  return {
      measure("mouth_area_max", "m2", phase_.mouth_area),
      measure("mouth_area_max_time", "s", phase_.mouth_area_time),
      measure("mouth_area_final", "m2", readings_.mouth_area),
      measure("mouth_width_final", "m", readings_.mouth_width),
      measure("peak_tension", "N", phase_.tension),
      measure("peak_strain", "", phase_.strain),
      measure("first_contact_time", "s", phase_.first_contact),
      measure("smallest_distance", "m", phase_.smallest_distance),
      {"steps", "", phase_.steps},
      {"newton_iterations", "", phase_.iterations},
  };
}

}  // namespace retiarius
