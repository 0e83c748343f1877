// Closing: corner masses follow prescribed paths around the target until the mouth is shut, then
// they are released.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/phase_action.hpp"
#include "retiarius/mission/step_grid.hpp"

namespace retiarius {

namespace {

// A corner's path about the target's mass centre, in the plane of its start and the shot axis:
//   place = axis (from + rise sin q) + outward (inner + (outer - inner) cos q),  q from 0 to pi/2,
// a quarter of an ellipse ("behind"), or with q as the share of a straight line ("straight").
// q(t) is a cubic that starts at the corner's own pace and ends at rest.
struct Path {
  bool arc = true;
  Vec3 from, to;       // arc: to the ellipse's centre and its two half axes; straight: the ends
  Vec3 across, along;  // half axes of the arc, m
  double duration = 0.0;
  double pace = 0.0;  // of the share at the start, 1/s

  void transfer(Archive& archive) { archive(arc, from, to, across, along, duration, pace); }

  double share(double t) const {
    const double s = t / duration;
    return s * s * (3.0 - 2.0 * s) + pace * duration * s * (1.0 - s) * (1.0 - s);
  }
  double share_rate(double t) const {
    const double s = t / duration;
    return 6.0 * s * (1.0 - s) / duration + pace * (1.0 - s) * (1.0 - 3.0 * s);
  }
  Vec3 place(double t) const {
    const double p = share(t);
    if (!arc) return from + p * (to - from);
    return from + std::cos(0.5 * kPi * p) * across + std::sin(0.5 * kPi * p) * along;
  }
  Vec3 velocity(double t) const {
    const double p = share(t);
    const double rate = share_rate(t);
    if (!arc) return rate * (to - from);
    const double turn = 0.5 * kPi * rate;
    return turn * (std::cos(0.5 * kPi * p) * along - std::sin(0.5 * kPi * p) * across);
  }
};

class Close final : public PhaseAction {
 public:
  Close(const PhaseSpec& phase, const Network& network, const MissionFrame& frame)
      : phase_(phase), bullets_(network.bullets), frame_(frame) {
    if (frame.target == kNone)
      throw InputError(
          phase.place,
          fmt::format("phase \"{}\": closing needs a [target] to close around", phase.name));
    delay_ = phase.delay.empty() ? 0.0 : phase.delay.front();
  }

  void begin(Simulation& sim) override {
    start_ = sim.state().time + delay_;
    if (delay_ <= 0.0) plan(sim);
  }

  std::optional<double> next_event(double now) const override {
    if (paths_.empty() && !released_) return start_;
    const double end = start_ + longest_;
    return !released_ && end > now ? std::optional(end) : std::nullopt;
  }

  void act(Simulation& sim) override {
    const double now = sim.state().time;
    if (paths_.empty() && !released_ && now >= start_ - kSameTime) plan(sim);
    if (!paths_.empty() && now >= start_ + longest_ - kSameTime) {
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
      const Path& path = paths_[k];
      const double t = std::min(time - start_, path.duration);
      out.push_back({bullets_[k], centre + path.place(t), target.velocity + path.velocity(t)});
    }
  }

  void transfer(Archive& archive) override { archive(start_, longest_, released_, paths_); }

  Measures measures(const Simulation& sim) const override {
    double widest = 0.0;
    for (Index a : bullets_) {
      for (Index b : bullets_)
        widest = std::max(widest, (sim.state().x[a] - sim.state().x[b]).norm());
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
      longest_ = std::max(longest_, paths_.back().duration);
    }
  }

  // At most three times the mean pace: a faster start would carry the cubic beyond its end.
  double start_pace(double speed, double length, double duration) const {
    return std::clamp(speed / length, 0.0, 3.0 / duration);
  }

  // Past the target and inward, on an arc that never takes a corner farther from the target than
  // it is: a net that is spread has no thread to spare.
  Path behind(const Vec3& from, const Vec3& velocity) const {
    const Vec3& axis = frame_.axis;
    const Vec3 lateral = from - axis * axis.dot(from);
    const double outer = lateral.norm();
    const Vec3 outward = outer > 0.0 ? Vec3(lateral / outer) : axis.unitOrthogonal();
    const double inner = std::min(phase_.radius, outer);
    const double rise = phase_.distance - axis.dot(from);
    Path path;
    path.from = axis.dot(from) * axis + inner * outward;
    path.across = (outer - inner) * outward;
    path.along = rise * axis;
    const double length = std::max(0.25 * kPi * (outer - inner + std::abs(rise)), 1e-6);
    path.duration = length / phase_.close_speed;
    const double reach = std::max(0.5 * kPi * std::abs(rise), 1e-6);
    path.pace = start_pace(std::copysign(1.0, rise) * axis.dot(velocity), reach, path.duration);
    return path;
  }

  // Straight to the target's mass centre, up to `radius` from it.
  Path straight(const Vec3& from, const Vec3& velocity) const {
    Path path;
    path.arc = false;
    path.from = from;
    path.to = from.norm() > phase_.radius ? Vec3(phase_.radius * from.normalized()) : from;
    const Vec3 way = path.to - path.from;
    const double length = std::max(way.norm(), 1e-6);
    path.duration = length / phase_.close_speed;
    path.pace = start_pace(velocity.dot(way) / length, length, path.duration);
    return path;
  }

  PhaseSpec phase_;
  std::vector<Index> bullets_;
  MissionFrame frame_;
  double delay_ = 0.0;
  double start_ = 0.0;    // s, when the paths begin
  double longest_ = 0.0;  // s, of the paths
  bool released_ = false;
  std::vector<Path> paths_;
};

}  // namespace

std::unique_ptr<PhaseAction> make_close(const PhaseSpec& phase, const Network& network,
                                        const MissionFrame& frame) {
  return std::make_unique<Close>(phase, network, frame);
}

}  // namespace retiarius
