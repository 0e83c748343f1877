#include "retiarius/contact/thread_pairs.hpp"

#include <algorithm>
#include <iterator>

#include "retiarius/contact/swept_box.hpp"

namespace retiarius {
namespace {

// The share of all segments that may have left their boxes; where more have, all pairs are looked
// for anew, each of them once.
constexpr double kMostLeft = 0.5;

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

Vec3 mean(const std::vector<Vec3>& vectors) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : vectors) sum += v;
  return sum / std::max<double>(1.0, static_cast<double>(vectors.size()));
}

}  // namespace

ThreadPairs::ThreadPairs(const CollisionMesh& net, const ThreadNeighbours* neighbours, double slack)
    : net_(&net), neighbours_(neighbours), slack_(slack) {}

const PairParts::List& ThreadPairs::find(const std::vector<Vec3>& x, const std::vector<Vec3>& dx,
                                         double margin) {
  const bool holds = slack_ > 0.0 && !held_.empty();
  if (!holds) origin_ = mean(x);
  sweep(x, dx, margin);
  if (holds) find_left();
  if (holds && left_.empty()) return pairs_;
  if (holds && static_cast<double>(left_.size()) <= kMostLeft * static_cast<double>(held_.size()))
    find_those_left();
  else
    find_all();
  return pairs_;
}

void ThreadPairs::sweep(const std::vector<Vec3>& x, const std::vector<Vec3>& dx, double margin) {
  const Vec3 place = mean(x) - origin_, drift = mean(dx);
  swept_.resize(net_->edges.size());
  parts_.clear();
  parts_.each(swept_.size(), [&](Index s, PairParts::List&) {
    Box box;
    for (const Index n : net_->edges[at(s)]) {
      const Vec3 start = x[at(n)] - place;
      box.extend(start).extend(start + (dx[at(n)] - drift));
    }
    swept_[at(s)] = widened(box, net_->edge_radius[at(s)] + 0.5 * margin);
  });
}

void ThreadPairs::find_left() {
  has_left_.assign(held_.size(), 0);
  left_.clear();
  for (std::size_t s = 0; s < held_.size(); ++s) {
    if (held_[s].contains(swept_[s])) continue;
    has_left_[s] = 1;
    left_.push_back(static_cast<Index>(s));
  }
}

void ThreadPairs::hold(Index segment) { held_[at(segment)] = widened(swept_[at(segment)], slack_); }

void ThreadPairs::add(Index s, Index t, PairParts::List& found) const {
  if (neighbours_ == nullptr || !neighbours_->are_neighbours(s, t))
    found.push_back({PairKind::edge_edge, kNet, s, kNet, t});
}

void ThreadPairs::find_all() {
  held_.resize(swept_.size());
  for (std::size_t s = 0; s < held_.size(); ++s) hold(static_cast<Index>(s));
  tree_.build(held_);
  parts_.clear();
  parts_.each(tree_.size(), [&](Index leaf, PairParts::List& found) {
    tree_.visit_pairs(at(leaf), at(leaf) + 1, [&](Index s, Index t) { add(s, t, found); });
  });
  pairs_.clear();
  parts_.append_to(pairs_);
  std::sort(pairs_.begin(), pairs_.end());
}

// Pairs of two segments that both have left are found by each of them and taken from the first.
void ThreadPairs::find_those_left() {
  for (const Index s : left_) hold(s);
  tree_.build(held_);
  parts_.clear();
  parts_.each(left_.size(), [&](Index k, PairParts::List& found) {
    const Index s = left_[at(k)];
    tree_.visit(held_[at(s)], [&](Index t) {
      if (t == s || (has_left_[at(t)] != 0 && t < s)) return;
      add(std::min(s, t), std::max(s, t), found);
    });
  });
  found_.clear();
  parts_.append_to(found_);
  std::sort(found_.begin(), found_.end());
  standing_.clear();
  std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(standing_),
               [&](const ContactPair& pair) {
                 return has_left_[at(pair.first)] == 0 && has_left_[at(pair.second)] == 0;
               });
  pairs_.clear();
  std::merge(standing_.begin(), standing_.end(), found_.begin(), found_.end(),
             std::back_inserter(pairs_));
}

}  // namespace retiarius
