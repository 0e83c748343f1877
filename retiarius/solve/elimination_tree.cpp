#include "retiarius/solve/elimination_tree.hpp"

#include <algorithm>
#include <numeric>

namespace retiarius {

namespace {

std::vector<Index> inverse(const std::vector<Index>& order) {
  std::vector<Index> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<Index>(k);
  return position;
}

// Parents by Liu's algorithm with path compression.
std::vector<Index> parents(const Graph& graph, const std::vector<Index>& order) {
  const std::vector<Index> position = inverse(order);
  std::vector<Index> parent(order.size(), kNone), ancestor(order.size(), kNone);
  for (Index i = 0; i < graph.size(); ++i) {
    const Index v = order[i];
    for (Index k = graph.starts[v]; k < graph.starts[v + 1]; ++k) {
      Index j = position[graph.neighbours[k]];
      while (j != kNone && j < i) {
        const Index next = ancestor[j];
        ancestor[j] = i;
        if (next == kNone) parent[j] = i;
        j = next;
      }
    }
  }
  return parent;
}

// Row i of the factor is the part of the tree below i that its entries reach upwards.
std::vector<Index> column_counts(const Graph& graph, const EliminationTree& tree) {
  const std::vector<Index> position = inverse(tree.order);
  std::vector<Index> counts(tree.order.size(), 1), mark(tree.order.size(), kNone);
  for (Index i = 0; i < graph.size(); ++i) {
    mark[i] = i;
    const Index v = tree.order[i];
    for (Index k = graph.starts[v]; k < graph.starts[v + 1]; ++k) {
      for (Index j = position[graph.neighbours[k]]; j < i && mark[j] != i; j = tree.parent[j]) {
        mark[j] = i;
        ++counts[j];
      }
    }
  }
  return counts;
}

}  // namespace

std::vector<Index> postorder(const std::vector<Index>& parent, const std::vector<double>& weight) {
  const auto size = static_cast<Index>(parent.size());
  std::vector<Index> by_weight(parent.size());
  std::iota(by_weight.begin(), by_weight.end(), 0);
  std::stable_sort(by_weight.begin(), by_weight.end(),
                   [&weight](Index a, Index b) { return weight[a] > weight[b]; });
  // Lists built by pushing to the front, heaviest first, are ascending.
  std::vector<Index> child(parent.size(), kNone), sibling(parent.size(), kNone);
  Index root = kNone;
  for (Index k = 0; k < size; ++k) {
    const Index v = by_weight[k];
    Index& head = parent[v] == kNone ? root : child[parent[v]];
    sibling[v] = head;
    head = v;
  }
  std::vector<Index> finished, stack;
  finished.reserve(parent.size());
  for (; root != kNone; root = sibling[root]) {
    stack.push_back(root);
    while (!stack.empty()) {
      const Index v = stack.back();
      if (child[v] != kNone) {
        stack.push_back(child[v]);
        child[v] = sibling[child[v]];
      } else {
        finished.push_back(v);
        stack.pop_back();
      }
    }
  }
  return finished;
}

EliminationTree elimination_tree(const Graph& graph, const std::vector<Index>& order) {
  const std::vector<Index> parent = parents(graph, order);
  const std::vector<Index> finished = postorder(parent, std::vector<double>(order.size(), 0.0));
  const std::vector<Index> number = inverse(finished);
  EliminationTree tree;
  tree.order.resize(order.size());
  tree.parent.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index old = finished[k];
    tree.order[k] = order[old];
    tree.parent[k] = parent[old] == kNone ? kNone : number[parent[old]];
  }
  tree.counts = column_counts(graph, tree);
  return tree;
}

}  // namespace retiarius
