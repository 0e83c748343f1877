#include "retiarius/check/threads_on_body.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/parallel.hpp"
#include "retiarius/check/least_over_time.hpp"
#include "retiarius/check/plain_distance.hpp"

namespace retiarius::check {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

// A body's motion from one state to the next by constant twist.
struct Twist {
  Vec3 start, move, axis;
  Mat3 attitude;
  double angle = 0.0;

  Twist(const BodyState& from, const BodyState& to)
      : start(from.position),
        move(to.position - from.position),
        attitude(from.attitude.toRotationMatrix()) {
    const Eigen::AngleAxisd turn(Mat3(to.attitude.toRotationMatrix() * attitude.transpose()));
    axis = turn.axis();
    angle = turn.angle();
  }

  Vec3 to_body(const Vec3& world, double t) const {
    const Mat3 turned = Eigen::AngleAxisd(t * angle, axis).toRotationMatrix() * attitude;
    return turned.transpose() * (world - start - t * move);
  }
};

// One segment's way, as the body sees it.
struct SeenSegment {
  const Twist* twist;
  Vec3 a, b, da, db;  // in world axes

  Vec3 first(double t) const { return twist->to_body(a + t * da, t); }
  Vec3 second(double t) const { return twist->to_body(b + t * db, t); }

  // Bound of the speed of either end and so of all places between, m.
  double speed() const {
    const double reach = std::max({(a - twist->start).norm(), (b - twist->start).norm()});
    const double straight = std::max((da - twist->move).norm(), (db - twist->move).norm());
    return straight + twist->angle * (reach + straight);
  }

  // How far a path may leave the straight line between its ends, m.
  double bow() const {
    const double reach = std::max((a - twist->start).norm(), (b - twist->start).norm());
    const double straight = std::max((da - twist->move).norm(), (db - twist->move).norm());
    const double w = twist->angle;
    return (2.0 * w * straight + w * w * (reach + straight)) / 8.0;
  }
};

void check_segment(const CheckedRun& run, const SeenSegment& seen, ContactViolation what,
                   double start, double length, const ContactCheckOptions& options, Tally& tally) {
  const CheckedSolid& solid = *run.solids[at(what.body)];
  const double radius = run.radius[at(what.segment)];
  const double enough = options.share * radius, speed = seen.speed();
  const Vec3 a = seen.first(0.0), b = seen.second(0.0);
  if (point_segment(Vec3::Zero(), a, b) - speed > solid.radius() + enough) return;
  const Vec3 a1 = seen.first(1.0), b1 = seen.second(1.0);
  const double around = seen.bow() + radius;
  const Vec3 low = a.cwiseMin(b).cwiseMin(a1).cwiseMin(b1).array() - around;
  const Vec3 high = a.cwiseMax(b).cwiseMax(a1).cwiseMax(b1).array() + around;
  const CheckedSolid::Near near = solid.near(low, high);
  if (near.nothing) return;
  ++tally.looked_at;
  const Least least = least_over_time(
      [&](double t) { return solid.distance(near, seen.first(t), seen.second(t), enough); }, speed,
      enough, kResolution * radius);
  if (!least.resolved) ++tally.unresolved;
  if (least.value >= enough) return;
  what.fault = fault_of_motion(least.value, kResolution * radius);
  what.time = start + least.time * length;
  what.distance = least.value;
  what.depth = radius - least.value;
  tally.add(what);
}

}  // namespace

ContactFault fault_of_motion(double least, double resolution) {
  return least <= resolution ? ContactFault::crossing : ContactFault::approach;
}

void add_in_parts(std::size_t count, Tally& sum,
                  const std::function<void(std::size_t, Tally&)>& part) {
  constexpr std::size_t kGrain = 64;
  std::vector<Tally> tallies((count + kGrain - 1) / kGrain);
  parallel_for(count, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) part(k, tallies[begin / kGrain]);
  });
  for (const Tally& tally : tallies) sum.merge(tally);
}

void check_state_on_body(const CheckedRun& run, const FrameData& now, Index body,
                         const ContactCheckOptions& options, Tally& sum) {
  const CheckedSolid& solid = *run.solids[at(body)];
  const Twist still(now.bodies[at(body)], now.bodies[at(body)]);
  add_in_parts(run.segments.size(), sum, [&](std::size_t s, Tally& tally) {
    const double radius = run.radius[s], enough = (1.0 - options.slack) * radius;
    const Vec3 a = still.to_body(now.x[at(run.segments[s][0])], 0.0);
    const Vec3 b = still.to_body(now.x[at(run.segments[s][1])], 0.0);
    if (point_segment(Vec3::Zero(), a, b) > solid.radius() + radius) return;
    ++tally.looked_at;
    const double distance = solid.distance(a, b, enough);
    if (distance >= enough) return;
    tally.add({ContactFault::penetration, now.time, static_cast<Index>(s), body, kNone, distance,
               radius - distance});
  });
}

void check_motion_on_body(const CheckedRun& run, const FrameData& now, const FrameData& next,
                          Index body, const ContactCheckOptions& options, Tally& sum) {
  const Twist twist(now.bodies[at(body)], next.bodies[at(body)]);
  add_in_parts(run.segments.size(), sum, [&](std::size_t s, Tally& tally) {
    const auto [i, j] = run.segments[s];
    const SeenSegment seen{&twist, now.x[at(i)], now.x[at(j)], next.x[at(i)] - now.x[at(i)],
                           next.x[at(j)] - now.x[at(j)]};
    ContactViolation what;
    what.segment = static_cast<Index>(s);
    what.body = body;
    check_segment(run, seen, what, now.time, next.time - now.time, options, tally);
  });
}

}  // namespace retiarius::check
