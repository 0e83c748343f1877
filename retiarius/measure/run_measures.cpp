#include "retiarius/measure/run_measures.hpp"

#include <algorithm>

#include "retiarius/measure/contact_load.hpp"
#include "retiarius/measure/energy.hpp"
#include "retiarius/measure/mouth.hpp"
#include "retiarius/state/transfer.hpp"

namespace retiarius {

namespace {

double peak(const std::vector<double>& tension) {
  return *std::max_element(tension.begin(), tension.end());
}

// The first contact of a thread with a body, in the order of contacts.
FirstTouch first_touch(const Simulation& simulation) {
  for (const ContactMark& mark : contact_marks(simulation)) {
    if (mark.body == kNone || mark.thread == kNone) continue;
    const BodyState& body = simulation.state().bodies[static_cast<std::size_t>(mark.body)];
    return {mark.thread, mark.body, to_body(body, mark.point)};
  }
  return {};
}

}  // namespace

RunMeasures::RunMeasures(const Network& network, const std::vector<Body>& bodies,
                         std::vector<Index> probe_nodes)
    : network_(&network),
      bodies_(&bodies),
      probe_nodes_(std::move(probe_nodes)),
      flat_area_(projected_area(polygon(network.design, network.corners), network.normal)),
      flat_width_(width(polygon(network.design, network.corners))),
      quality_scale_(bodies.empty() ? std::nullopt : quality_scale(bodies.front())),
      clearance_(network, bodies),
      closure_(flat_area_, flat_width_),
      axis_(network.normal) {}

void RunMeasures::begin(const Simulation& simulation) {
  balance_.begin(simulation);
  center_ = mass_center(*network_, *bodies_, simulation.state());
  closure_.set_prescribed(simulation.state().time, false);
  rebase_drift(simulation.state());
  look(simulation);
}

void RunMeasures::begin_phase(const Simulation& simulation, bool prescribed) {
  const State& state = simulation.state();
  balance_.see(simulation);
  set_prescribed(simulation, prescribed);
  rebase_drift(state);
  phase_ = {};
  phase_.see_shape(state.time, readings_, travel_);
}

void RunMeasures::set_prescribed(const Simulation& simulation, bool prescribed) {
  closure_.set_prescribed(simulation.state().time, prescribed);
  if (prescribed_ && !prescribed) rebase_drift(simulation.state());
  prescribed_ = prescribed;
}

void RunMeasures::shot(const Simulation& simulation, const Vec3& axis) {
  if (!shot_corners_.empty()) return;
  axis_ = axis.normalized();
  shot_corners_ = polygon(simulation.state().x, network_->corners);
  whole_ = {};
  phase_ = {};
  quality_ = {};
  window_.clear();
  look(simulation);
}

void RunMeasures::step(const Simulation& simulation, const StepReport& report) {
  const State& state = simulation.state();
  balance_.see(simulation);
  look(simulation);
  const double tension = peak(simulation.tensions());
  whole_.see_step(report.iterations, tension);
  phase_.see_step(report.iterations, tension);
  if (!state.touches.empty() && !phase_.first_contact) {
    const FirstTouch touch = first_touch(simulation);
    whole_.see_touch(state.time, touch);
    phase_.see_touch(state.time, touch);
  }
  ++steps_;
  iterations_ += report.iterations;
  substeps_ += report.substeps;
  if (report.single) ++unconverged_;
  step_size_ = report.h;
  window_.add(report.h, simulation.tensions());
  if (!prescribed_) add_drift(state);
}

void RunMeasures::look(const Simulation& simulation) {
  const State& state = simulation.state();
  time_ = state.time;
  nodes_ = state.x;
  poses_ = state.bodies;
  readings_ = read_net(*network_, state.x, axis_);
  readings_.smallest_distance = clearance_.measure(state);
  travel_ = mean_travel(state.x);
  closure_.see(time_, readings_);
  whole_.see_shape(time_, readings_, travel_);
  phase_.see_shape(time_, readings_, travel_);
}

double RunMeasures::mean_travel(const std::vector<Vec3>& x) const {
  if (shot_corners_.empty()) return 0.0;
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < shot_corners_.size(); ++k)
    sum += x[network_->corners[k]] - shot_corners_[k];
  return sum.dot(axis_) / static_cast<double>(shot_corners_.size());
}

double RunMeasures::mouth_ratio() const {
  return flat_area_ > 0.0 ? readings_.mouth_area / flat_area_ : 0.0;
}

// The account is about the origin, the drift about the mass centre at the start.
Vec3 RunMeasures::angular_impulse(const Account& account) const {
  return account.outside_angular_impulse - center_.cross(account.outside_impulse);
}

void RunMeasures::rebase_drift(const State& state) {
  linear_.rebase(linear_momentum(*network_, *bodies_, state), state.account.outside_impulse);
  angular_.rebase(angular_momentum(*network_, *bodies_, state, center_),
                  angular_impulse(state.account));
}

void RunMeasures::add_drift(const State& state) {
  linear_.add(linear_momentum(*network_, *bodies_, state), state.account.outside_impulse,
              linear_scale(*network_, *bodies_, state));
  angular_.add(angular_momentum(*network_, *bodies_, state, center_),
               angular_impulse(state.account), angular_scale(*network_, *bodies_, state));
}

RunMeasures::Wrapping RunMeasures::wrapping(const std::vector<Vec3>& nodes,
                                            const std::vector<BodyState>& poses) const {
  // A run that fails before its first step has seen no pose.
  if (poses.empty() || bodies_->front().kind == ShapeKind::plane) return {};
  const std::optional<ConvexHull> hull = convex_hull(nodes);
  Wrapping held{measure_capture(bodies_->front(), poses.front(), nodes, hull), {}};
  if (quality_scale_)
    held.quality =
        capture_quality(*quality_scale_, poses.front().position, nodes, network_->mass, hull);
  return held;
}

void RunMeasures::keep(const HistoryRow& row) {
  if (row.capture_quality && touched()) quality_.see(row.time, *row.capture_quality);
}

// What the network and the bodies give is not among them.
void RunMeasures::transfer(Archive& archive) {
  archive(clearance_, quality_, closure_, balance_, window_, axis_, shot_corners_, prescribed_,
          readings_, travel_, time_, nodes_, poses_, whole_, phase_, steps_, iterations_, substeps_,
          step_size_, center_, linear_, angular_);
}

HistoryRow RunMeasures::row(const Simulation& simulation, Index phase) const {
  const State& state = simulation.state();
  const Account& account = state.account;
  const Energies now = energies(simulation, balance_.gravity());
  HistoryRow r;
  r.time = state.time;
  r.step = state.step;
  r.phase = phase;
  r.mouth_area = readings_.mouth_area;
  r.mouth_vector_area = readings_.mouth_vector_area;
  r.mouth_width = readings_.mouth_width;
  r.perimeter_area = readings_.perimeter_area;
  r.kinetic_energy = now.kinetic;
  r.stretching_energy = now.stretching;
  r.bending_energy = now.bending;
  r.gravity_energy = now.gravity;
  r.material_loss = account.material_loss;
  r.environment_loss = account.environment_loss;
  r.friction_loss = account.friction_loss;
  r.impact_loss = account.impact_loss;
  r.integrator_loss = balance_.integrator_loss(now, account);
  r.prescribed_work = account.prescribed_work;
  r.momentum = linear_momentum(*network_, *bodies_, state);
  r.angular_momentum = angular_momentum(*network_, *bodies_, state, Vec3::Zero());
  r.peak_tension = peak(simulation.tensions());
  r.peak_strain = readings_.peak_strain;
  r.contacts = static_cast<Index>(state.touches.size());
  r.smallest_distance = readings_.smallest_distance;
  r.newton_iterations = iterations_;
  const Wrapping held = wrapping(state.x, state.bodies);
  if (held.capture) r.captured_share = held.capture->share;
  r.capture_quality = held.quality;
  r.step_size = step_size_;
  ContactLoad load = contact_load(simulation);
  r.contact_energy = load.energy;
  r.contacts_face = load.faces;
  r.contacts_edge = load.edges;
  r.contacts_thread = load.threads;
  r.contacts_body = load.bodies;
  r.loads = std::move(load.loads);
  for (const Index node : probe_nodes_) r.probes.push_back({state.x[node], state.support[node]});
  return r;
}

}  // namespace retiarius
