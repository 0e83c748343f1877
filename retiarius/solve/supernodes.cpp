#include "retiarius/solve/supernodes.hpp"

#include <algorithm>

namespace retiarius {

namespace {

// A supernode while merging goes on: groups of columns in order of elimination.
struct Group {
  Index parent = kNone;
  Index columns = 0, below = 0;
  std::vector<Index> children;
  std::vector<Index> merged;  // runs of the original columns, by their first one
};

// Runs [starts[s], starts[s + 1]) in which each column's structure is its child's without it.
std::vector<Index> equal_structure(const EliminationTree& tree) {
  const auto size = static_cast<Index>(tree.parent.size());
  std::vector<Index> starts;
  for (Index k = 0; k < size; ++k) {
    const bool same = k > 0 && tree.parent[k - 1] == k && tree.counts[k - 1] == tree.counts[k] + 1;
    if (!same) starts.push_back(k);
  }
  starts.push_back(size);
  return starts;
}

double gain(const Group& child, const Group& parent) {
  return front_cost(child.columns, child.below) + front_cost(parent.columns, parent.below) -
         front_cost(child.columns + parent.columns, parent.below);
}

// Merges children into group p while that pays, the best first.
void absorb(std::vector<Group>& groups, Index p) {
  Group& parent = groups[p];
  while (true) {
    auto best = parent.children.end();
    double largest = 0.0;
    for (auto it = parent.children.begin(); it != parent.children.end(); ++it) {
      const double g = gain(groups[*it], parent);
      if (g > largest) {
        largest = g;
        best = it;
      }
    }
    if (best == parent.children.end()) return;
    Group& child = groups[*best];
    parent.children.erase(best);
    parent.columns += child.columns;
    parent.merged.insert(parent.merged.end(), child.merged.begin(), child.merged.end());
    parent.children.insert(parent.children.end(), child.children.begin(), child.children.end());
    for (const Index c : child.children) groups[c].parent = p;
    child.columns = 0;
  }
}

std::vector<Group> fundamental(const EliminationTree& tree, const std::vector<Index>& starts) {
  std::vector<Group> groups(starts.size() - 1);
  std::vector<Index> owner(tree.parent.size());
  for (std::size_t s = 0; s < groups.size(); ++s) {
    for (Index k = starts[s]; k < starts[s + 1]; ++k) owner[k] = static_cast<Index>(s);
    groups[s].columns = starts[s + 1] - starts[s];
    groups[s].below = tree.counts[starts[s + 1] - 1] - 1;
    groups[s].merged.push_back(static_cast<Index>(s));
  }
  for (std::size_t s = 0; s < groups.size(); ++s) {
    const Index next = tree.parent[starts[s + 1] - 1];
    if (next == kNone) continue;
    groups[s].parent = owner[next];
    groups[owner[next]].children.push_back(static_cast<Index>(s));
  }
  return groups;
}

}  // namespace

// The constants are fitted to measurements on nets; optima are flat in them.
double front_cost(Index columns, Index below) {
  const double k = 3.0 * columns, u = 3.0 * below;
  const double flops = k * k * k / 3.0 + k * k * u + k * u * u;
  const double traffic = 0.15 * k * (k + u) + 0.25 * u * u;
  return 80.0 + 8.0 * k + flops / 32.0 + traffic;
}

Supernodes supernodes(const EliminationTree& tree) {
  const std::vector<Index> starts = equal_structure(tree);
  std::vector<Group> groups = fundamental(tree, starts);
  for (std::size_t s = 0; s < groups.size(); ++s) absorb(groups, static_cast<Index>(s));

  std::vector<Index> kept, number(groups.size(), kNone);
  for (std::size_t s = 0; s < groups.size(); ++s) {
    if (groups[s].columns == 0) continue;
    number[s] = static_cast<Index>(kept.size());
    kept.push_back(static_cast<Index>(s));
  }
  std::vector<Index> parent;
  std::vector<double> weight;
  for (const Index s : kept) {
    parent.push_back(groups[s].parent == kNone ? kNone : number[groups[s].parent]);
    weight.push_back(-groups[s].below);
  }
  const std::vector<Index> finished = postorder(parent, weight);
  std::vector<Index> place(finished.size());
  for (std::size_t k = 0; k < finished.size(); ++k) place[finished[k]] = static_cast<Index>(k);

  Supernodes result;
  result.order.reserve(tree.order.size());
  result.starts.push_back(0);
  for (const Index f : finished) {
    Group& group = groups[kept[f]];
    // Merged runs are eliminated in their original order, which respects the tree.
    std::sort(group.merged.begin(), group.merged.end());
    for (const Index s : group.merged) {
      for (Index k = starts[s]; k < starts[s + 1]; ++k) result.order.push_back(tree.order[k]);
    }
    result.starts.push_back(static_cast<Index>(result.order.size()));
    result.parent.push_back(parent[f] == kNone ? kNone : place[parent[f]]);
    result.below.push_back(group.below);
    result.cost += front_cost(group.columns, group.below);
  }
  return result;
}

}  // namespace retiarius
