#include "retiarius/measure/history.hpp"

#include <limits>

namespace retiarius {

namespace {

using Row = HistoryRow;

double or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

const std::vector<HistoryColumn>& history_columns() {
  static const std::vector<HistoryColumn> columns = {
      {"time", "s", "time since the mission's start", [](const Row& r) { return r.time; }},
      {"step", "1", "accepted steps since the mission's start",
       [](const Row& r) { return static_cast<double>(r.step); }},
      {"phase", "1", "index of the phase, from 0",
       [](const Row& r) { return static_cast<double>(r.phase); }},
      {"mouth_area", "m2",
       "area of the mouth polygon projected on the plane normal to the shot axis",
       [](const Row& r) { return r.mouth_area; }},
      {"mouth_vector_area", "m2", "size of the mouth polygon's vector area",
       [](const Row& r) { return r.mouth_vector_area; }},
      {"mouth_width", "m", "largest distance between two corners",
       [](const Row& r) { return r.mouth_width; }},
      {"perimeter_area", "m2", "as mouth_area, for the polygon of all perimeter nodes",
       [](const Row& r) { return r.perimeter_area; }},
      {"kinetic_energy", "J", "of net and bodies", [](const Row& r) { return r.kinetic_energy; }},
      {"stretching_energy", "J", "elastic energy of stretched or compressed segments",
       [](const Row& r) { return r.stretching_energy; }},
      {"bending_energy", "J", "elastic energy of bent joints",
       [](const Row& r) { return r.bending_energy; }},
      {"gravity_energy", "J", "potential energy in the gravity field, 0 at the origin",
       [](const Row& r) { return r.gravity_energy; }},
      {"material_loss", "J", "lost to the threads' material damping since the start",
       [](const Row& r) { return r.material_loss; }},
      {"environment_loss", "J", "lost to environmental damping since the start",
       [](const Row& r) { return r.environment_loss; }},
      {"friction_loss", "J", "lost to friction since the start",
       [](const Row& r) { return r.friction_loss; }},
      {"impact_loss", "J", "lost to plastic impact of nodes on bodies since the start",
       [](const Row& r) { return r.impact_loss; }},
      {"integrator_loss", "J", "what remains of the energy account: lost to the time integrator",
       [](const Row& r) { return r.integrator_loss; }},
      {"prescribed_work", "J", "done on the net by supports, grips and shots since the start",
       [](const Row& r) { return r.prescribed_work; }},
      {"momentum_x", "kg m/s", "linear momentum of net and bodies",
       [](const Row& r) { return r.momentum.x(); }},
      {"momentum_y", "kg m/s", "the same along y", [](const Row& r) { return r.momentum.y(); }},
      {"momentum_z", "kg m/s", "the same along z", [](const Row& r) { return r.momentum.z(); }},
      {"angular_momentum_x", "kg m2/s", "angular momentum of net and bodies about the origin",
       [](const Row& r) { return r.angular_momentum.x(); }},
      {"angular_momentum_y", "kg m2/s", "the same about y",
       [](const Row& r) { return r.angular_momentum.y(); }},
      {"angular_momentum_z", "kg m2/s", "the same about z",
       [](const Row& r) { return r.angular_momentum.z(); }},
      {"peak_tension", "N", "largest tension of a segment, viscous part included",
       [](const Row& r) { return r.peak_tension; }},
      {"peak_strain", "1", "largest axial strain of a segment",
       [](const Row& r) { return r.peak_strain; }},
      {"contacts", "1", "nodes in contact with a body",
       [](const Row& r) { return static_cast<double>(r.contacts); }},
      {"smallest_distance", "m",
       "smallest distance from thread surface to body surface, negative inside; empty without body",
       [](const Row& r) { return or_nan(r.smallest_distance); }},
      {"newton_iterations", "1", "Newton iterations since the mission's start",
       [](const Row& r) { return static_cast<double>(r.newton_iterations); }},
      {"captured_share", "1",
       "share of the first target's surface inside the convex hull of the nodes; empty without one",
       [](const Row& r) { return or_nan(r.captured_share); }},
      {"capture_quality", "1",
       "capture quality index of the first target, smaller is better; empty without one",
       [](const Row& r) { return or_nan(r.capture_quality); }},
      {"step_size", "s", "length of the last step; 0 before the first",
       [](const Row& r) { return r.step_size; }},
      {"contact_energy", "J", "energy of the barriers between surfaces in contact",
       [](const Row& r) { return r.contact_energy; }},
      {"contacts_face", "1", "barrier contacts of nodes with faces and planes",
       [](const Row& r) { return static_cast<double>(r.contacts_face); }},
      {"contacts_edge", "1", "barrier contacts of segments with edges, corners and balls",
       [](const Row& r) { return static_cast<double>(r.contacts_edge); }},
      {"contacts_thread", "1", "barrier contacts of threads with threads",
       [](const Row& r) { return static_cast<double>(r.contacts_thread); }},
      {"contacts_body", "1", "barrier contacts of bodies with bodies",
       [](const Row& r) { return static_cast<double>(r.contacts_body); }},
  };
  return columns;
}

}  // namespace retiarius
