// Shooting: corner masses get their velocities at the phase's first instant, or after a delay each.
#include <algorithm>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/phase_action.hpp"
#include "retiarius/mission/step_grid.hpp"

namespace retiarius {

namespace {

// One value for all corners, or one each.
std::vector<double> per_corner(const std::vector<double>& values, double fallback,
                               const PhaseSpec& phase, const char* key, std::size_t corners) {
  if (values.empty()) return std::vector<double>(corners, fallback);
  if (values.size() == 1) return std::vector<double>(corners, values.front());
  if (values.size() == corners) return values;
  throw InputError(
      phase.place,
      fmt::format("phase \"{}\", {}: {} values for {} corners; give one for all or one "
                  "for each",
                  phase.name, key, values.size(), corners));
}

class Shoot final : public PhaseAction {
 public:
  Shoot(const PhaseSpec& phase, const Network& network)
      : bullets_(network.bullets),
        velocities_(shot_velocities(phase, network)),
        delays_(per_corner(phase.delay, 0.0, phase, "delay", bullets_.size())),
        fired_(bullets_.size(), false) {}

  void begin(Simulation& sim) override {
    start_ = sim.state().time;
    for (Index n : bullets_) places_.push_back(sim.state().x[n]);
    act(sim);
  }

  std::optional<double> next_event(double now) const override {
    std::optional<double> next;
    for (std::size_t k = 0; k < delays_.size(); ++k) {
      const double t = start_ + delays_[k];
      if (!fired_[k] && t > now && (!next || t < *next)) next = t;
    }
    return next;
  }

  void act(Simulation& sim) override {
    for (std::size_t k = 0; k < delays_.size(); ++k) {
      if (fired_[k] || sim.state().time < start_ + delays_[k] - kSameTime) continue;
      sim.kick(bullets_[k], velocities_[k]);
      fired_[k] = true;
    }
  }

  // A corner mass that waits is held in its barrel.
  void prescribe(const Simulation&, double, std::vector<Prescribed>& out) const override {
    for (std::size_t k = 0; k < bullets_.size(); ++k) {
      if (!fired_[k]) out.push_back({bullets_[k], places_[k], Vec3::Zero()});
    }
  }

  void transfer(Archive& archive) override { archive(fired_, places_, start_); }

 private:
  std::vector<Index> bullets_;
  std::vector<Vec3> velocities_;
  std::vector<double> delays_;
  std::vector<bool> fired_;
  std::vector<Vec3> places_;
  double start_ = 0.0;
};

}  // namespace

std::vector<Vec3> shot_velocities(const PhaseSpec& phase, const Network& network) {
  const std::size_t corners = network.corners.size();
  if (corners == 0)
    throw InputError(phase.place, fmt::format("phase \"{}\": the net has no corners to shoot it by",
                                              phase.name));
  const auto speed = per_corner(phase.speed, 0.0, phase, "speed", corners);
  const auto angle = per_corner(phase.half_angle_deg, 45.0, phase, "half_angle_deg", corners);
  const Vec3 axis = phase.axis.normalized();
  const Vec3 facing = network.normal.dot(axis) < 0.0 ? Vec3(-network.normal) : network.normal;
  const Quat turn = Quat::FromTwoVectors(facing, axis);
  std::vector<Vec3> result;
  for (std::size_t k = 0; k < corners; ++k) {
    Vec3 lateral = network.design[network.corners[k]];
    lateral = (lateral - facing * facing.dot(lateral)).normalized();
    const double a = radians(angle[k]);
    result.push_back(speed[k] * (std::cos(a) * axis + std::sin(a) * (turn * lateral)));
  }
  return result;
}

std::unique_ptr<PhaseAction> make_shoot(const PhaseSpec& phase, const Network& network) {
  return std::make_unique<Shoot>(phase, network);
}

}  // namespace retiarius
