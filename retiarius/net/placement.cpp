#include "retiarius/net/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {
namespace {

constexpr double kLengthTolerance = 1e-9;  // relative to the rest length

[[noreturn]] void refuse(const std::string& reason) {
  throw InputError("net.zigzag = true: " + reason);
}

// Neighbours of each node in compressed rows.
struct Graph {
  std::vector<std::size_t> start;
  std::vector<Index> neighbour;
};

Graph graph_of(const Network& network) {
  Graph graph;
  graph.start.assign(network.design.size() + 1, 0);
  for (const Segment& s : network.segments) {
    ++graph.start[s.a + 1];
    ++graph.start[s.b + 1];
  }
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbour.resize(graph.start.back());
  std::vector<std::size_t> next(graph.start.begin(), graph.start.end() - 1);
  for (const Segment& s : network.segments) {
    graph.neighbour[next[s.a]++] = s.b;
    graph.neighbour[next[s.b]++] = s.a;
  }
  return graph;
}

// Parity of the graph distance from corner 0.
std::vector<char> parities(const Network& network) {
  if (network.corners.empty()) refuse("the net has no corner to count distances from");
  const Graph graph = graph_of(network);
  constexpr char kUnknown = 2;
  std::vector<char> parity(network.design.size(), kUnknown);
  std::vector<Index> queue{network.corners.front()};
  parity[queue.front()] = 0;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index node = queue[head];
    for (std::size_t k = graph.start[node]; k < graph.start[node + 1]; ++k) {
      const Index next = graph.neighbour[k];
      if (parity[next] == parity[node]) {
        refuse(fmt::format(
            "nodes {} and {} of one segment lie equally far from corner0 (the graph is not "
            "bipartite); an even net.segments makes it so",
            node, next));
      }
      if (parity[next] != kUnknown) continue;
      parity[next] = static_cast<char>(1 - parity[node]);
      queue.push_back(next);
    }
  }
  const auto lost = std::find(parity.begin(), parity.end(), kUnknown);
  if (lost != parity.end()) {
    refuse(fmt::format("node {} is not connected to corner0", lost - parity.begin()));
  }
  return parity;
}

void check_flat(const Network& network) {
  double size = 0.0, height = 0.0;
  for (const Vec3& x : network.design) {
    size = std::max(size, x.norm());
    height = std::max(height, std::abs(x.z()));
  }
  if (height > kLengthTolerance * size) refuse("the net as designed must be flat");
}

void lift(Network& network, double scale) {
  check_flat(network);
  const std::vector<char> parity = parities(network);
  // The square of the lift is compared, because its root magnifies rounding near zero.
  std::vector<double> height2(network.design.size(), -1.0);
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& s = network.segments[i];
    const Index odd = parity[s.a] ? s.a : s.b;
    const double l0 = s.rest_length;
    const double flat2 = (scale * (network.design[s.a] - network.design[s.b])).squaredNorm();
    const double slack = 2.0 * kLengthTolerance * l0 * l0;
    double needed = l0 * l0 - flat2;
    if (needed < -slack) {
      refuse(fmt::format("segment {} is stretched already in the plane (rest length {:.6g} m)", i,
                         l0));
    }
    needed = std::max(0.0, needed);
    if (height2[odd] >= 0.0 && std::abs(height2[odd] - needed) > slack) {
      refuse(fmt::format(
          "node {} cannot keep the lengths of its segments: lifts of {:.6g} m and {:.6g} m are "
          "needed; an even net.segments keeps them",
          odd, std::sqrt(height2[odd]), std::sqrt(needed)));
    }
    if (height2[odd] < 0.0) height2[odd] = needed;
  }
  for (std::size_t i = 0; i < height2.size(); ++i) {
    if (parity[i]) network.initial[i].z() += std::sqrt(height2[i]);
  }
}

}  // namespace

void place_nodes(Network& network, const NetSpec& spec) {
  network.initial = network.design;
  network.velocity.assign(network.design.size(), Vec3::Zero());
  for (Vec3& x : network.initial) x.head<2>() *= spec.scale;
  if (spec.zigzag) lift(network, spec.scale);
  for (Vec3& x : network.initial) x += spec.position;
}

}  // namespace retiarius
