#include "retiarius/solve/symbolic.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/front_memory.hpp"

namespace retiarius {

namespace {

int padded(int rows) {
  return (rows + kernels::kPadding - 1) / kernels::kPadding * kernels::kPadding;
}

void count_work(const EliminationTree& tree, Symbolic& symbolic) {
  for (const Index count : tree.counts) {
    const double below = 3.0 * (count - 1);
    symbolic.entries += 6.0 + 3.0 * below;
    for (int pivot = 0; pivot < 3; ++pivot) {
      const double column = below + 3.0 - pivot;
      symbolic.flops += column * column;
    }
  }
}

void make_fronts(const Supernodes& groups, Symbolic& symbolic) {
  std::vector<Front>& fronts = symbolic.fronts;
  fronts.resize(static_cast<std::size_t>(groups.size()));
  std::vector<std::size_t> next(fronts.size() + 1, 0);
  for (Index f = 0; f < groups.size(); ++f) {
    Front& front = fronts[f];
    front.parent = groups.parent[f];
    front.first = groups.starts[f];
    front.columns = groups.starts[f + 1] - groups.starts[f];
    front.below = groups.below[f];
    front.pivot_rows = padded(front.pivots());
    front.update_ld = padded(front.rows_below());
    front.ld = front.pivot_rows + front.update_ld;
    front.panel = symbolic.factor_size;
    symbolic.factor_size +=
        static_cast<std::size_t>(front.ld) * static_cast<std::size_t>(front.pivots());
    symbolic.largest_ld = std::max(symbolic.largest_ld, front.ld);
    if (front.parent != kNone) ++next[front.parent + 1];
  }
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    next[f + 1] += next[f];
    fronts[f].child_begin = fronts[f].child_end = next[f];
  }
  symbolic.children.resize(next.back());
  for (Index f = 0; f < groups.size(); ++f) {
    if (fronts[f].parent == kNone) continue;
    symbolic.children[fronts[fronts[f].parent].child_end++] = f;
  }
}

// Rows of a front: what its columns and its children reach beyond its own columns.
void find_rows(const Graph& graph, const std::vector<Index>& position, Symbolic& symbolic) {
  std::vector<Index> mark(position.size(), kNone);
  for (Index f = 0; f < static_cast<Index>(symbolic.fronts.size()); ++f) {
    Front& front = symbolic.fronts[f];
    const Index end = front.first + front.columns;
    std::vector<Index>& rows = symbolic.rows;
    front.rows = rows.size();
    const auto reach = [&](Index row) {
      if (row < end || mark[row] == f) return;
      mark[row] = f;
      rows.push_back(row);
    };
    for (Index k = front.first; k < end; ++k) {
      const Index v = symbolic.order[k];
      for (Index e = graph.starts[v]; e < graph.starts[v + 1]; ++e) {
        reach(position[graph.neighbours[e]]);
      }
    }
    for (std::size_t c = front.child_begin; c < front.child_end; ++c) {
      const Front& child = symbolic.fronts[symbolic.children[c]];
      for (Index b = 0; b < child.below; ++b) reach(rows[child.rows + b]);
    }
    std::sort(rows.begin() + static_cast<std::ptrdiff_t>(front.rows), rows.end());
    if (rows.size() - front.rows != static_cast<std::size_t>(front.below)) {
      throw Error(fmt::format("front {} has {} rows below its pivots where {} were expected", f,
                              rows.size() - front.rows, front.below));
    }
  }
}

// Block position of a block in a front, pivots first.
int block_position(const Symbolic& symbolic, const Front& front, Index number) {
  if (number < front.first + front.columns) return number - front.first;
  const auto begin = symbolic.rows.begin() + static_cast<std::ptrdiff_t>(front.rows);
  const auto found = std::lower_bound(begin, begin + front.below, number);
  return front.columns + static_cast<int>(found - begin);
}

int scalar_row(const Front& front, int position) {
  return position < front.columns ? 3 * position
                                  : front.pivot_rows + 3 * (position - front.columns);
}

void make_runs(Symbolic& symbolic) {
  symbolic.targets.resize(symbolic.rows.size());
  for (Front& front : symbolic.fronts) {
    front.run_begin = symbolic.runs.size();
    for (Index b = 0; b < front.below; ++b) {
      const Front& parent = symbolic.fronts[front.parent];
      const int target = block_position(symbolic, parent, symbolic.rows[front.rows + b]);
      symbolic.targets[front.rows + b] = target;
      if (target < parent.columns) ++front.into_panel;
      const int row = scalar_row(parent, target);
      if (b > 0 && symbolic.runs.back().to + symbolic.runs.back().length == row) {
        symbolic.runs.back().length += 3;
      } else {
        symbolic.runs.push_back({3 * b, row, 3});
      }
    }
    front.run_end = symbolic.runs.size();
  }
}

void make_copies(const BlockPattern& pattern, const std::vector<Index>& position,
                 Symbolic& symbolic) {
  std::vector<Index> owner(position.size());
  for (std::size_t f = 0; f < symbolic.fronts.size(); ++f) {
    const Front& front = symbolic.fronts[f];
    for (Index k = 0; k < front.columns; ++k) owner[front.first + k] = static_cast<Index>(f);
  }
  std::vector<std::vector<BlockCopy>> straight(symbolic.fronts.size()),
      transposed(symbolic.fronts.size());
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index slot = pattern.starts()[c]; slot < pattern.starts()[c + 1]; ++slot) {
      const Index a = position[c], b = position[pattern.rows()[slot]];
      const Index column = std::min(a, b), row = std::max(a, b);
      const Front& front = symbolic.fronts[owner[column]];
      const Index offset = 3 * (column - front.first) * front.ld +
                           scalar_row(front, block_position(symbolic, front, row));
      (b > a ? straight : transposed)[owner[column]].push_back({slot, offset});
    }
  }
  for (std::size_t f = 0; f < symbolic.fronts.size(); ++f) {
    Front& front = symbolic.fronts[f];
    std::vector<BlockCopy>& copies = symbolic.copies;
    front.straight = copies.size();
    copies.insert(copies.end(), straight[f].begin(), straight[f].end());
    front.transposed = copies.size();
    copies.insert(copies.end(), transposed[f].begin(), transposed[f].end());
    front.copies_end = copies.size();
  }
}

Symbolic analyse_tree(const BlockPattern& pattern, const Graph& graph,
                      const EliminationTree& tree) {
  Symbolic symbolic;
  count_work(tree, symbolic);
  const Supernodes groups = supernodes(tree);
  symbolic.order = groups.order;
  symbolic.cost = groups.cost;
  std::vector<Index> position(symbolic.order.size());
  for (std::size_t k = 0; k < position.size(); ++k) {
    position[symbolic.order[k]] = static_cast<Index>(k);
  }
  make_fronts(groups, symbolic);
  find_rows(graph, position, symbolic);
  make_runs(symbolic);
  make_copies(pattern, position, symbolic);
  assign_tasks(symbolic);
  place_updates(symbolic);
  return symbolic;
}

}  // namespace

Symbolic analyse_fronts(const BlockPattern& pattern, const std::vector<Index>& order) {
  const Graph graph = block_graph(pattern);
  return analyse_tree(pattern, graph, elimination_tree(graph, order));
}

Symbolic analyse_fronts(const BlockPattern& pattern, int trials) {
  constexpr Index kSmall = 1500;  // blocks up to which minimum degree may win
  const Graph graph = block_graph(pattern);
  EliminationTree best;
  double lowest = std::numeric_limits<double>::infinity();
  const auto compare = [&](const std::vector<Index>& order) {
    EliminationTree tree = elimination_tree(graph, order);
    const double cost = supernodes(tree).cost;
    if (cost < lowest || best.order.empty()) {
      lowest = cost;
      best = std::move(tree);
    }
  };
  if (graph.size() <= kSmall) compare(minimum_degree(graph));
  for (int seed = 1; seed <= trials; ++seed) compare(nested_dissection(graph, seed));
  return analyse_tree(pattern, graph, best);
}

}  // namespace retiarius
