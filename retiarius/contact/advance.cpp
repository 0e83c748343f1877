#include "retiarius/contact/advance.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/contact/distance.hpp"

namespace retiarius {
namespace {

constexpr int kMostAdvances = 256;
constexpr double kShortfall = 0.01;  // of the initial gap, at which a pair counts as arrived

// What is known of the points at one instant.
struct Instant {
  PairPositions position;
  std::array<Vec3, 4> velocity;
  std::array<double, 4> acceleration;  // bounds
  int first = 1, count = 0;            // points of the first primitive, and of both

  Instant(const PairMotion& motion, double t) {
    first = first_count(motion.kind);
    count = motion.kind == PairKind::point_plane ? 2 : point_count(motion.kind);
    for (std::size_t i = 0; i < 4; ++i) position[i] = motion.points[i].at(t);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      velocity[i] = motion.points[i].velocity(t);
      acceleration[i] = motion.points[i].largest_acceleration();
    }
  }

  // Rounding of any length that is computed from these positions, with room to spare.
  double rounding() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      largest = std::max(largest, position[i].cwiseAbs().maxCoeff());
    return 32.0 * std::numeric_limits<double>::epsilon() * largest;
  }

  // Calls call(i, j) for all points i of the first and j of the second primitive.
  template <class Call>
  void each_pair(Call&& call) const {
    for (int i = 0; i < first; ++i) {
      for (int j = first; j < count; ++j) {
        call(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      }
    }
  }

  // A lower bound of the distance: how far the unit vector n separates the two.
  double separation(const Vec3& n) const {
    double least = kInfinity;
    each_pair([&](std::size_t i, std::size_t j) {
      least = std::min(least, n.dot(position[i] - position[j]));
    });
    return least;
  }
};

// The first time s from now at which h + c s + q s^2 has fallen below 0.
double time_to_fall(double h, double c, double q) {
  if (h < 0.0) return 0.0;
  if (q >= 0.0) {
    const double square = c * c - 4.0 * q * h;
    if (c >= 0.0 || square < 0.0) return kInfinity;
    return 2.0 * h / (std::sqrt(square) - c);
  }
  // Of the two forms of the positive root the one without cancellation.
  const double root = std::sqrt(c * c - 4.0 * q * h);
  return c > 0.0 ? (c + root) / (-2.0 * q) : 2.0 * h / (root - c);
}

// How long the direction n + s m, across n at first, goes on to separate the two by `bound`; 0
// where it does not even now. Its length is at most 1 + (s m)^2 / 2.
double separated_time(const Instant& now, const Vec3& n, const Vec3& m, double bound) {
  double time = kInfinity;
  now.each_pair([&](std::size_t i, std::size_t j) {
    const Vec3 apart = now.position[i] - now.position[j];
    const Vec3 rate = now.velocity[i] - now.velocity[j];
    const double bend = now.acceleration[i] + now.acceleration[j];
    // A length of at most sqrt(2) is seen to below.
    const double turn = m.dot(rate) - 0.5 * bound * m.squaredNorm() - std::sqrt(0.5) * bend;
    time = std::min(time, time_to_fall(n.dot(apart) - bound, n.dot(rate) + m.dot(apart), turn));
    if (bend > 0.0) time = std::min(time, 1.0 / m.norm());
  });
  return time;
}

// How long a gap lasts at the largest speeds of both sides, the mean velocity taken away.
double additive_time(const Instant& now, double gap) {
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < now.count; ++i) mean += now.velocity[static_cast<std::size_t>(i)];
  mean /= now.count;
  double speed[2] = {0.0, 0.0}, acceleration[2] = {0.0, 0.0};
  for (int i = 0; i < now.count; ++i) {
    const int side = i < now.first ? 0 : 1;
    const auto k = static_cast<std::size_t>(i);
    speed[side] = std::max(speed[side], (now.velocity[k] - mean).norm());
    acceleration[side] = std::max(acceleration[side], now.acceleration[k]);
  }
  return time_to_fall(gap, -(speed[0] + speed[1]), -0.5 * (acceleration[0] + acceleration[1]));
}

}  // namespace

double advance(const PairMotion& motion, double separation, double share) {
  double t = 0.0, bound = separation, gap = 0.0;
  for (int k = 0; k < kMostAdvances; ++k) {
    const Instant now(motion, t);
    const Distance at = distance(motion.kind, now.position);
    const Vec3& n = at.normal;
    const double known = now.separation(n) - now.rounding();
    if (k == 0) {
      gap = known - separation;
      if (!(gap > 0.0)) return 0.0;
      bound = separation + share * gap;
    }
    if (known - bound <= kShortfall * gap) return t;
    const double limit = bound + 0.5 * now.rounding();
    double time = separated_time(now, n, Vec3::Zero(), limit);
    // A plane is a half space: only its own normal tells the distance to it.
    if (motion.kind != PairKind::point_plane) {
      const Vec3 rate = normal_rate(at, now.position, now.velocity);
      if (rate.allFinite()) time = std::max(time, separated_time(now, n, rate, limit));
      time = std::max(time, additive_time(now, known - bound));
    }
    // The product keeps t on the safe side of the rounding of the sum.
    const double next = t + time * (1.0 - 1e-12);
    if (next >= 1.0) return 1.0;
    t = next;
  }
  return t;
}

}  // namespace retiarius
