// One row of the history and one frame: what the mission loop measures and observers write.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/measure/contact_load.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

struct ProbeValue {
  Vec3 position = Vec3::Zero();  // m
  Vec3 force = Vec3::Zero();     // support force where the node is held, else 0, N
};

// Names and units of the columns are those of history_columns().
struct HistoryRow {
  double time = 0.0;
  std::int64_t step = 0;
  Index phase = 0;
  double mouth_area = 0.0, mouth_vector_area = 0.0, mouth_width = 0.0, perimeter_area = 0.0;
  double kinetic_energy = 0.0, stretching_energy = 0.0, bending_energy = 0.0, gravity_energy = 0.0;
  double material_loss = 0.0, environment_loss = 0.0, friction_loss = 0.0, impact_loss = 0.0;
  double integrator_loss = 0.0, prescribed_work = 0.0;
  Vec3 momentum = Vec3::Zero();
  Vec3 angular_momentum = Vec3::Zero();  // about the origin
  double peak_tension = 0.0, peak_strain = 0.0;
  Index contacts = 0;
  std::optional<double> smallest_distance;  // absent without body
  std::int64_t newton_iterations = 0;       // since the mission's start
  std::optional<double> captured_share;     // of the first target; absent without one
  std::optional<double> capture_quality;    // index of the first target; absent without one
  double step_size = 0.0;                   // of the last step, s; 0 before the first
  double contact_energy = 0.0;              // of barriers, J
  Index contacts_face = 0, contacts_edge = 0, contacts_thread = 0, contacts_body = 0;
  std::vector<ProbeValue> probes;  // in the mission's order
  std::vector<BodyLoad> loads;     // of the targets
};

// A column of the history without the probes': name as in the file, unit, meaning, value.
struct HistoryColumn {
  std::string name;
  std::string unit;
  std::string meaning;
  double (*value)(const HistoryRow&);  // NaN where absent
};
const std::vector<HistoryColumn>& history_columns();

// What is drawn: the state and what the threads carry. Refers to data that lives during the call.
struct Frame {
  Index phase = 0;
  const State* state = nullptr;
  std::vector<double> tension;    // of each segment, N, viscous part included
  std::vector<double> strain;     // of each segment
  std::vector<double> curvature;  // at each node, the largest of its joints, 1/m
  std::vector<ContactMark> contacts;
};

}  // namespace retiarius
