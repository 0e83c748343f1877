// A tree of boxes: which of many boxes overlap a given one.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

using Box = Eigen::AlignedBox3d;

// A binary tree over boxes sorted along a Morton curve through their centres. Boxes at which
// something is not finite, or which are empty, overlap nothing.
class BoxTree {
 public:
  // Replaces what was there; memory is used again.
  void build(const std::vector<Box>& boxes);

  bool empty() const { return order_.empty(); }
  Box bounds() const { return empty() ? Box() : nodes_[1]; }

  // Calls visit(index) for every box that overlaps `box` (touching counts), in no certain order
  // that matters: it depends on the boxes alone.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    if (!empty()) visit_below(1, box, std::forward<Visit>(visit));
  }

  // Calls visit(i, j) with i < j for all overlapping boxes of the tree, those whose first leaf in
  // the tree's order lies in [begin, end).
  template <class Visit>
  void visit_pairs(std::size_t begin, std::size_t end, Visit&& visit) const;

  std::size_t size() const { return order_.size(); }

 private:
  // Only leaves below this node.
  template <class Visit>
  void visit_below(std::size_t root, const Box& box, Visit&& visit) const;

  // Node k has the children 2k and 2k + 1; leaves are nodes leaves_ .. leaves_ + size() - 1.
  std::vector<Box> nodes_;
  std::vector<Index> order_;  // the box at each leaf
  std::vector<std::pair<std::uint64_t, Index>> keys_;
  std::size_t leaves_ = 0;  // a power of two
};

template <class Visit>
void BoxTree::visit_below(std::size_t root, const Box& box, Visit&& visit) const {
  std::size_t stack[128];
  int depth = 0;
  stack[depth++] = root;
  while (depth > 0) {
    const std::size_t node = stack[--depth];
    if (!nodes_[node].intersects(box)) continue;
    if (node >= leaves_) {
      visit(order_[node - leaves_]);
      continue;
    }
    stack[depth++] = 2 * node + 1;
    stack[depth++] = 2 * node;
  }
}

// What comes after a leaf is below the right siblings of the nodes on its way up.
template <class Visit>
void BoxTree::visit_pairs(std::size_t begin, std::size_t end, Visit&& visit) const {
  for (std::size_t leaf = begin; leaf < end; ++leaf) {
    const Index i = order_[leaf];
    const Box& box = nodes_[leaves_ + leaf];
    for (std::size_t node = leaves_ + leaf; node > 1; node /= 2) {
      if (node % 2 == 0)
        visit_below(node + 1, box, [&](Index j) { i < j ? visit(i, j) : visit(j, i); });
    }
  }
}

}  // namespace retiarius
