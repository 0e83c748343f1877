#include "retiarius/check/threads_on_threads.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "retiarius/check/least_over_time.hpp"
#include "retiarius/check/plain_distance.hpp"
#include "retiarius/check/threads_on_body.hpp"

namespace retiarius::check {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

}  // namespace

ThreadsOnThreads::ThreadsOnThreads(const CheckedRun& run) : run_(run) {
  std::vector<std::vector<Index>> meeting;  // the segments at each node
  for (std::size_t s = 0; s < run.segments.size(); ++s) {
    for (const Index node : run.segments[s]) {
      if (meeting.size() <= at(node)) meeting.resize(at(node) + 1);
      meeting[at(node)].push_back(static_cast<Index>(s));
    }
  }
  const double thickest =
      run.radius.empty() ? 0.0 : *std::max_element(run.radius.begin(), run.radius.end());
  // Walks on from a node, `way` from the segment it began with, along all paths that are short.
  std::function<void(Index, Index, double)> walk = [&](Index from, Index node, double way) {
    for (const Index s : meeting[at(node)]) {
      const double sum = run.radius[at(from)] + run.radius[at(s)];
      if (s > from && (way == 0.0 || way < kNeighbourMultiple * sum))
        neighbours_.emplace_back(from, s);
      const double farther = way + run.rest_length[at(s)];
      if (s == from || farther >= kNeighbourMultiple * (run.radius[at(from)] + thickest)) continue;
      const auto [a, b] = run.segments[at(s)];
      walk(from, a == node ? b : a, farther);
    }
  };
  for (std::size_t s = 0; s < run.segments.size(); ++s)
    for (const Index node : run.segments[s]) walk(static_cast<Index>(s), node, 0.0);
  std::sort(neighbours_.begin(), neighbours_.end());
}

bool ThreadsOnThreads::are_neighbours(Index s, Index t) const {
  return std::binary_search(neighbours_.begin(), neighbours_.end(),
                            std::pair(std::min(s, t), std::max(s, t)));
}

void ThreadsOnThreads::check(const FrameData& now, const FrameData* next,
                             const ContactCheckOptions& options, Tally& sum) {
  const std::size_t count = run_.segments.size();
  const std::vector<Vec3>& end = next ? next->x : now.x;
  low_.resize(count);
  high_.resize(count);
  for (std::size_t s = 0; s < count; ++s) {
    const auto [i, j] = run_.segments[s];
    const Vec3 &a = now.x[at(i)], &b = now.x[at(j)], &c = end[at(i)], &d = end[at(j)];
    low_[s] = a.cwiseMin(b).cwiseMin(c).cwiseMin(d).array() - run_.radius[s];
    high_[s] = a.cwiseMax(b).cwiseMax(c).cwiseMax(d).array() + run_.radius[s];
  }
  by_x_.resize(count);
  std::iota(by_x_.begin(), by_x_.end(), 0);
  std::sort(by_x_.begin(), by_x_.end(), [&](Index s, Index t) {
    return std::pair(low_[at(s)].x(), s) < std::pair(low_[at(t)].x(), t);
  });
  add_in_parts(count, sum, [&](std::size_t k, Tally& tally) {
    const Index s = by_x_[k];
    for (std::size_t m = k + 1; m < count; ++m) {
      const Index t = by_x_[m];
      if (low_[at(t)].x() > high_[at(s)].x()) break;
      const bool apart = (low_[at(t)].array() > high_[at(s)].array()).any() ||
                         (high_[at(t)].array() < low_[at(s)].array()).any();
      if (!apart && !are_neighbours(s, t))
        check_pair(std::min(s, t), std::max(s, t), now, next, options, tally);
    }
  });
}

void ThreadsOnThreads::check_pair(Index s, Index t, const FrameData& now, const FrameData* next,
                                  const ContactCheckOptions& options, Tally& tally) const {
  const auto [a, b] = run_.segments[at(s)];
  const auto [c, d] = run_.segments[at(t)];
  const double radii = run_.radius[at(s)] + run_.radius[at(t)];
  ++tally.looked_at;
  const double distance = segment_segment(now.x[at(a)], now.x[at(b)], now.x[at(c)], now.x[at(d)]);
  if (distance < (1.0 - options.slack) * radii)
    tally.add({ContactFault::penetration, now.time, s, kNone, t, distance, radii - distance});
  if (next == nullptr) return;

  const std::array<Index, 4> nodes{a, b, c, d};
  std::array<Vec3, 4> x, v;
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    x[k] = now.x[at(nodes[k])];
    v[k] = next->x[at(nodes[k])] - x[k];
    mean += 0.25 * v[k];
  }
  const auto faster = [&](std::size_t i, std::size_t j) {
    return std::max((v[i] - mean).norm(), (v[j] - mean).norm());
  };
  const double enough = options.share * radii;
  const Least least = least_over_time(
      [&](double time) {
        return segment_segment(x[0] + time * v[0], x[1] + time * v[1], x[2] + time * v[2],
                               x[3] + time * v[3]);
      },
      faster(0, 1) + faster(2, 3), enough, kResolution * radii);
  if (!least.resolved) ++tally.unresolved;
  if (least.value >= enough) return;
  tally.add({fault_of_motion(least.value, kResolution * radii),
             now.time + least.time * (next->time - now.time), s, kNone, t, least.value,
             radii - least.value});
}

}  // namespace retiarius::check
