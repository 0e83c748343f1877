// Closing: corner masses follow prescribed paths around the target until the mouth is shut, then
// they are released.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/phase_action.hpp"

namespace retiarius {

namespace {

// A cubic from a place with a velocity to another (Hermite).
struct Leg {
  double duration = 0.0;  // s
  Vec3 from, to;          // m
  Vec3 start, end;        // velocities, m/s

  Vec3 place(double t) const {
    const double s = t / duration;
    const double r = 1.0 - s;
    return (1.0 + 2.0 * s) * r * r * from + s * r * r * duration * start +
           s * s * (3.0 - 2.0 * s) * to - s * s * r * duration * end;
  }
  Vec3 velocity(double t) const {
    const double s = t / duration;
    return 6.0 * s * (1.0 - s) / duration * (to - from) + (1.0 - s) * (1.0 - 3.0 * s) * start +
           s * (3.0 * s - 2.0) * end;
  }
};

class Close final : public PhaseAction {
 public:
  Close(const PhaseSpec& phase, const Network& network, const MissionFrame& frame)
      : phase_(phase), bullets_(network.bullets), frame_(frame) {
    if (frame.target == kNone)
      throw InputError(phase.place,
                       fmt::format("phase \"{}\": closing needs a [target] to close around",
                                   phase.name));
    delay_ = phase.delay.empty() ? 0.0 : phase.delay.front();
  }

  void begin(Simulation& sim) override {
    start_ = sim.state().time + delay_;
    if (delay_ <= 0.0) plan(sim);
  }

  std::optional<double> next_event(double now) const override {
    if (paths_.empty() && !released_) return start_;
    for (double t : {start_ + longest_}) {
      if (!released_ && t > now) return t;
    }
    return std::nullopt;
  }

  void act(Simulation& sim) override {
    const double now = sim.state().time;
    if (paths_.empty() && !released_ && now >= start_ - 1e-12) plan(sim);
    if (!paths_.empty() && now >= start_ + longest_ - 1e-12) {
      paths_.clear();
      released_ = true;
    }
  }

  bool moves() const override { return !paths_.empty(); }

  // Paths are relative to the target's mass centre, taken to go on as it does now.
  void prescribe(const Simulation& sim, double time, std::vector<Prescribed>& out) const override {
    const BodyState& target = sim.state().bodies[frame_.target];
    const Vec3 centre = target.position + (time - sim.state().time) * target.velocity;
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      double t = time - start_;
      std::size_t leg = 0;
      while (leg + 1 < paths_[k].size() && t > paths_[k][leg].duration)
        t -= paths_[k][leg++].duration;
      const Leg& path = paths_[k][leg];
      t = std::min(t, path.duration);
      out.push_back({bullets_[k], centre + path.place(t), target.velocity + path.velocity(t)});
    }
  }

  Measures measures(const Simulation& sim) const override {
    double widest = 0.0;
    for (Index a : bullets_) {
      for (Index b : bullets_) widest = std::max(widest, (sim.state().x[a] - sim.state().x[b]).norm());
    }
    return {{"corners_apart", "m", widest}, {"released", "", released_}};
  }

 private:
  void plan(const Simulation& sim) {
    const BodyState& target = sim.state().bodies[frame_.target];
    longest_ = 0.0;
    for (Index bullet : bullets_) {
      const Vec3 from = sim.state().x[bullet] - target.position;
      const Vec3 velocity = sim.state().v[bullet] - target.velocity;
      paths_.push_back(phase_.path == ClosePath::behind ? behind(from, velocity)
                                                        : straight(from, velocity));
      double total = 0.0;
      for (const Leg& leg : paths_.back()) total += leg.duration;
      longest_ = std::max(longest_, total);
    }
  }

  // The time for a leg: at the closing speed, but never slower than the corner comes in, so that
  // the cubic does not swing out beyond its end.
  double leg_time(const Vec3& from, const Vec3& to, const Vec3& velocity) const {
    const double length = std::max((to - from).norm(), 1e-6);
    return length / std::max(phase_.close_speed, velocity.norm() / 2.5);
  }

  // Past the target at the corner's present distance from the axis, then inward.
  std::vector<Leg> behind(const Vec3& from, const Vec3& velocity) const {
    const Vec3& axis = frame_.axis;
    const Vec3 lateral = from - axis * axis.dot(from);
    const double distance = lateral.norm();
    const Vec3 outward = distance > 0.0 ? Vec3(lateral / distance) : axis.unitOrthogonal();
    const Vec3 end = phase_.distance * axis + std::min(phase_.radius, distance) * outward;
    std::vector<Leg> legs;
    const Vec3 turn = std::max(phase_.distance, axis.dot(from)) * axis + lateral;
    Vec3 turning = velocity;
    if ((turn - from).norm() > 1e-3) {
      turning = -0.5 * phase_.close_speed * outward;
      legs.push_back({leg_time(from, turn, velocity), from, turn, velocity, turning});
    }
    legs.push_back({1.5 * leg_time(turn, end, turning), turn, end, turning, Vec3::Zero()});
    return legs;
  }

  // Straight to the target's mass centre, up to `radius` from it.
  std::vector<Leg> straight(const Vec3& from, const Vec3& velocity) const {
    const Vec3 end = from.norm() > phase_.radius ? Vec3(phase_.radius * from.normalized()) : from;
    const Vec3 along = (end - from).norm() > 0.0
                           ? Vec3(phase_.close_speed * (end - from).normalized())
                           : Vec3(Vec3::Zero());
    (void)velocity;
    const double time = std::max((end - from).norm(), 1e-6) / phase_.close_speed;
    return {{time, from, end, along, along}};
  }

  PhaseSpec phase_;
  std::vector<Index> bullets_;
  MissionFrame frame_;
  double delay_ = 0.0;
  double start_ = 0.0;    // s, when the paths begin
  double longest_ = 0.0;  // s, of the paths
  bool released_ = false;
  std::vector<std::vector<Leg>> paths_;
};

}  // namespace

std::unique_ptr<PhaseAction> make_close(const PhaseSpec& phase, const Network& network,
                                        const MissionFrame& frame) {
  return std::make_unique<Close>(phase, network, frame);
}

}  // namespace retiarius
