#include "retiarius/contact/thread_neighbours.hpp"

#include <algorithm>
#include <queue>

namespace retiarius {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

// The segments at each node.
std::vector<std::vector<Index>> segments_of_nodes(const Network& network) {
  std::vector<std::vector<Index>> list(network.design.size());
  for (Index s = 0; s < network.segment_count(); ++s) {
    list[at(network.segments[at(s)].a)].push_back(s);
    list[at(network.segments[at(s)].b)].push_back(s);
  }
  return list;
}

// Finds how far nodes are from a segment along the net (Dijkstra), up to a reach.
class Walk {
 public:
  explicit Walk(const Network& network)
      : network_(network),
        at_node_(segments_of_nodes(network)),
        way_(network.design.size(), kInfinity) {}

  // Calls visit(other, way) for the segments within `reach` of `segment`; repeatedly, perhaps.
  template <class Visit>
  void from(Index segment, double reach, Visit&& visit) {
    for (const Index node : {network_.segments[at(segment)].a, network_.segments[at(segment)].b})
      add(node, 0.0);
    while (!open_.empty()) {
      const auto [way, node] = open_.top();
      open_.pop();
      if (way > way_[at(node)]) continue;
      for (const Index s : at_node_[at(node)]) {
        visit(s, way);
        const Segment& next = network_.segments[at(s)];
        const double farther = way + next.rest_length;
        if (farther < reach) add(next.a == node ? next.b : next.a, farther);
      }
    }
    for (const Index node : reached_) way_[at(node)] = kInfinity;
    reached_.clear();
  }

 private:
  void add(Index node, double way) {
    if (way >= way_[at(node)]) return;
    way_[at(node)] = way;
    reached_.push_back(node);
    open_.emplace(way, node);
  }

  const Network& network_;
  std::vector<std::vector<Index>> at_node_;
  std::vector<double> way_;
  std::vector<Index> reached_;
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                      std::greater<>>
      open_;
};

}  // namespace

ThreadNeighbours::ThreadNeighbours(const Network& network, double multiple) {
  const auto radius = [&](Index s) {
    return network.materials[at(network.segments[at(s)].material)].radius;
  };
  double thickest = 0.0;
  for (Index s = 0; s < network.segment_count(); ++s) thickest = std::max(thickest, radius(s));
  Walk walk(network);
  std::vector<Index> found;
  start_.push_back(0);
  for (Index s = 0; s < network.segment_count(); ++s) {
    found.clear();
    walk.from(s, multiple * (radius(s) + thickest), [&](Index other, double way) {
      if (other != s && (way == 0.0 || way < multiple * (radius(s) + radius(other))))
        found.push_back(other);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    others_.insert(others_.end(), found.begin(), found.end());
    start_.push_back(static_cast<Index>(others_.size()));
  }
}

bool ThreadNeighbours::are_neighbours(Index first, Index second) const {
  return std::binary_search(others_.begin() + start_[at(first)],
                            others_.begin() + start_[at(first) + 1], second);
}

}  // namespace retiarius
