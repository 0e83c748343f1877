#include "retiarius/contact/barrier_function.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/vec.hpp"

namespace retiarius {

namespace {

constexpr double kMostChange = 50.0;    // of a force that is foretold, over the present one
constexpr double kGapAccuracy = 1e-12;  // of gaps and their forces
constexpr double kSameGap = 1e-6;       // apart; nearer ones have a slope of round-off
constexpr int kMostTrials = 200;

}  // namespace

Jet barrier(double gap, double range) {
  if (gap >= range) return {};
  if (!(gap > 0.0)) return {kInfinity, -kInfinity, kInfinity};
  const double off = gap - range;
  const double log = std::log(gap / range);
  const double ratio = off / gap;
  return {-off * off * log, -2.0 * off * log - off * ratio,
          -2.0 * log - 4.0 * ratio + ratio * ratio};
}

double gap_of_force(double force, double range) {
  if (!(force > 0.0)) return range;
  // The force is convex and falls: Newton's steps from its left side stay there.
  double low = 0.0, high = range, gap = 0.5 * range;
  for (int i = 0; i < kMostTrials && high - low > kGapAccuracy * high; ++i) {
    const Jet b = barrier(gap, range);
    const double excess = -b.first - force;
    if (std::abs(excess) <= kGapAccuracy * force) break;
    (excess > 0.0 ? low : high) = gap;
    gap += excess / b.second;
    if (!(gap > low && gap < high)) gap = 0.5 * (low + high);
  }
  return gap;
}

Jet foretold_barrier(double gap, double range, double force) {
  const Jet here = barrier(gap, range);
  const double bounded = std::clamp(force, -here.first / kMostChange, -here.first * kMostChange);
  const double there = gap_of_force(bounded, range);
  if (std::abs(there - gap) <= kSameGap * gap) return here;
  return {here.value, -bounded, (here.first + bounded) / (gap - there)};
}

SlipJet smooth_slip(double slip, double smallest) {
  if (slip >= smallest) return {slip - smallest / 3.0, 1.0, 0.0, 1.0 / slip};
  const double u = slip / smallest;
  return {smallest * (u * u - u * u * u / 3.0), u * (2.0 - u), 2.0 * (1.0 - u) / smallest,
          (2.0 - u) / smallest};
}

double share_of_newton(const Vec3& before, const Vec3& slip) {
  const double sizes = before.norm() * slip.norm();
  return sizes > 0.0 ? std::max(0.0, before.dot(slip) / sizes) : 1.0;
}

}  // namespace retiarius
