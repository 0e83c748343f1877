#include "retiarius/mission/phase_action.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

std::vector<Index> select_all(const std::vector<std::string>& names, const Network& network,
                              const PhaseSpec& phase, const char* key) {
  std::vector<Index> nodes;
  for (const std::string& name : names) {
    try {
      const std::vector<Index> some = select_nodes(network, name);
      nodes.insert(nodes.end(), some.begin(), some.end());
    } catch (const InputError& e) {
      throw InputError(phase.place, fmt::format("phase \"{}\", {}: {}", phase.name, key, e.what()));
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Nodes held where they were at the phase's start.
class Fix final : public PhaseAction {
 public:
  explicit Fix(std::vector<Index> nodes) : nodes_(std::move(nodes)) {}

  void begin(Simulation& sim) override {
    for (Index n : nodes_) places_.push_back(sim.state().x[n]);
  }
  void prescribe(const Simulation&, double, std::vector<Prescribed>& out) const override {
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      out.push_back({nodes_[k], places_[k], Vec3::Zero()});
  }
  void transfer(Archive& archive) override { archive(places_); }

 private:
  std::vector<Index> nodes_;
  std::vector<Vec3> places_;
};

// Nodes moved by a displacement, smoothly, or at a constant velocity; then held.
class Move final : public PhaseAction {
 public:
  Move(std::vector<Index> nodes, const MoveSpec& spec) : nodes_(std::move(nodes)), spec_(spec) {}

  void begin(Simulation& sim) override {
    start_ = sim.state().time;
    for (Index n : nodes_) places_.push_back(sim.state().x[n]);
  }
  std::optional<double> next_event(double now) const override {
    const double end = start_ + spec_.duration;
    return std::isfinite(end) && end > now ? std::optional(end) : std::nullopt;
  }
  bool moves() const override { return true; }
  void prescribe(const Simulation&, double time, std::vector<Prescribed>& out) const override {
    const double t = std::min(time - start_, spec_.duration);
    Vec3 shift = t * spec_.velocity;
    Vec3 velocity = time - start_ < spec_.duration ? spec_.velocity : Vec3(Vec3::Zero());
    if (!spec_.displacement.isZero(0.0)) {
      const double s = t / spec_.duration;
      shift += s * s * (3.0 - 2.0 * s) * spec_.displacement;
      velocity += 6.0 * s * (1.0 - s) / spec_.duration * spec_.displacement;
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      out.push_back({nodes_[k], places_[k] + shift, velocity});
  }
  void transfer(Archive& archive) override { archive(start_, places_); }

 private:
  std::vector<Index> nodes_;
  MoveSpec spec_;
  double start_ = 0.0;
  std::vector<Vec3> places_;
};

}  // namespace

std::unique_ptr<PhaseAction> make_fix(const PhaseSpec& phase, const Network& network) {
  return std::make_unique<Fix>(select_all(phase.fix, network, phase, "fix"));
}

std::unique_ptr<PhaseAction> make_move(const MoveSpec& move, const PhaseSpec& phase,
                                       const Network& network) {
  return std::make_unique<Move>(select_all(move.nodes, network, phase, "move.nodes"), move);
}

std::vector<std::unique_ptr<PhaseAction>> make_actions(const PhaseSpec& phase,
                                                       const Network& network,
                                                       const MissionFrame& frame) {
  std::vector<std::unique_ptr<PhaseAction>> actions;
  if (!phase.fix.empty()) actions.push_back(make_fix(phase, network));
  for (const MoveSpec& move : phase.move) actions.push_back(make_move(move, phase, network));
  switch (phase.kind) {
    case PhaseKind::fold:
      actions.push_back(make_fold(phase, network, frame));
      break;
    case PhaseKind::shoot:
      actions.push_back(make_shoot(phase, network));
      break;
    case PhaseKind::close:
      actions.push_back(make_close(phase, network, frame));
      break;
    case PhaseKind::free:
    case PhaseKind::spread:
    case PhaseKind::contact:
      break;
  }
  return actions;
}

}  // namespace retiarius
