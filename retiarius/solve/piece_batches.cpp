#include "retiarius/solve/piece_batches.hpp"

#include <algorithm>
#include <set>

namespace retiarius {

namespace {

constexpr int kLanes = kernels::kPieceLanes;

bool coupled(const Graph& graph, Index v, Index w) {
  const auto begin = graph.neighbours.begin() + graph.starts[v];
  const auto end = graph.neighbours.begin() + graph.starts[v + 1];
  return std::binary_search(begin, end, w);
}

std::vector<Index> numbers_of(const EliminatedPiece& piece) {
  std::vector<Index> all = piece.columns;
  all.insert(all.end(), piece.border.begin(), piece.border.end());
  return all;
}

// Which blocks of a piece's columns the matrix has, in the piece's own numbers: pieces with equal
// lists are of one shape.
using Key = std::pair<Index, std::vector<std::pair<Index, Index>>>;

Key key_of(const Graph& graph, const EliminatedPiece& piece) {
  const std::vector<Index> all = numbers_of(piece);
  Key key{static_cast<Index>(piece.columns.size()), {}};
  for (Index c = 0; c < key.first; ++c) {
    for (Index r = c; r < static_cast<Index>(all.size()); ++r)
      if (r == c || coupled(graph, all[c], all[r])) key.second.emplace_back(r, c);
  }
  return key;
}

// Rows below the diagonal of each column of the factor.
std::vector<std::set<Index>> filled(const Key& key) {
  std::vector<std::set<Index>> rows(static_cast<std::size_t>(key.first));
  for (const auto& [r, c] : key.second)
    if (r > c) rows[c].insert(r);
  for (Index c = 0; c < key.first; ++c) {
    if (rows[c].empty()) continue;
    const Index parent = *rows[c].begin();
    if (parent >= key.first) continue;
    rows[parent].insert(std::next(rows[c].begin()), rows[c].end());
  }
  return rows;
}

PieceShape make_shape(const Key& key, Index border) {
  PieceShape s;
  s.columns = key.first;
  s.border = border;
  const std::vector<std::set<Index>> rows = filled(key);
  s.starts.push_back(0);
  for (const auto& below : rows) {
    s.at.push_back(s.size);
    s.rows.insert(s.rows.end(), below.begin(), below.end());
    s.starts.push_back(static_cast<int>(s.rows.size()));
    s.size += 6 + 9 * static_cast<int>(below.size());
  }
  for (Index p = 0; p < border; ++p) {
    for (Index q = 0; q <= p; ++q) {
      s.border_at.push_back(s.size);
      s.size += p == q ? 6 : 9;
    }
  }
  const auto place = [&](Index r, Index c) {
    if (c >= s.columns) {
      const Index p = r - s.columns, q = c - s.columns;
      return s.border_at[p * (p + 1) / 2 + q];
    }
    if (r == c) return s.at[c];
    const auto at = std::distance(rows[c].begin(), rows[c].find(r));
    return s.at[c] + 6 + 9 * static_cast<int>(at);
  };
  for (Index c = 0; c < s.columns; ++c) {
    for (int p = s.starts[c]; p < s.starts[c + 1]; ++p)
      for (int q = s.starts[c]; q <= p; ++q) s.targets.push_back(place(s.rows[p], s.rows[q]));
  }
  s.blocks = key.second;
  for (const auto& [r, c] : s.blocks) {
    s.places.push_back(place(r, c));
    s.whole.push_back(r != c);
  }
  return s;
}

bool fits(const PieceShape& shape) {
  for (Index c = 0; c < shape.columns; ++c)
    if (shape.starts[c + 1] - shape.starts[c] > kernels::kMostPieceRows) return false;
  return true;
}

class Maker {
 public:
  Maker(const BlockPattern& pattern, const Graph& graph, const std::vector<EliminatedPiece>& pieces)
      : pattern_(pattern), graph_(graph), pieces_(pieces) {}

  PieceBatches make() {
    std::map<Key, std::vector<const EliminatedPiece*>> groups;
    for (const EliminatedPiece& p : pieces_) groups[key_of(graph_, p)].push_back(&p);
    place_.assign(static_cast<std::size_t>(pattern_.blocks()), 0);
    for (auto group = groups.begin(); group != groups.end();) {
      const EliminatedPiece& first = *group->second.front();
      PieceShape shape = make_shape(group->first, static_cast<Index>(first.border.size()));
      if (2 * group->second.size() < kLanes || !fits(shape)) {
        group = groups.erase(group);
        continue;
      }
      out_.shapes.push_back(std::move(shape));
      for (const EliminatedPiece* p : group->second)
        for (const Index v : p->columns) place_[v] = kNone;
      ++group;
    }
    number_rest(groups);
    Index shape = 0;
    for (const auto& [key, members] : groups) {
      for (std::size_t k = 0; k < members.size(); k += kLanes)
        add_batch(shape, members.data() + k, std::min<std::size_t>(kLanes, members.size() - k));
      ++shape;
    }
    count_work();
    out_.place = std::move(place_);
    return std::move(out_);
  }

 private:
  void number_rest(const std::map<Key, std::vector<const EliminatedPiece*>>& groups) {
    for (Index v = 0; v < pattern_.blocks(); ++v) {
      if (place_[v] == kNone) continue;
      place_[v] = static_cast<Index>(out_.kept.size());
      out_.kept.push_back(v);
    }
    out_.columns = pattern_.blocks() - static_cast<Index>(out_.kept.size());
    out_.rest = BlockPattern(static_cast<Index>(out_.kept.size()));
    for (const Index v : out_.kept) {
      for (Index k = pattern_.starts()[v]; k < pattern_.starts()[v + 1]; ++k) {
        const Index w = pattern_.rows()[k];
        if (place_[w] != kNone) out_.rest.couple(place_[v], place_[w]);
      }
    }
    for (const auto& group : groups) {
      for (const EliminatedPiece* p : group.second)
        for (const Index a : p->border)
          for (const Index b : p->border) out_.rest.couple(place_[a], place_[b]);
    }
    out_.rest.finish();
    for (Index c = 0; c < out_.rest.blocks(); ++c) {
      for (Index k = out_.rest.starts()[c]; k < out_.rest.starts()[c + 1]; ++k) {
        const Index a = out_.kept[c], b = out_.kept[out_.rest.rows()[k]];
        out_.kept_slots.push_back(coupled(graph_, a, b) ? pattern_.slot(a, b) : kNone);
      }
    }
  }

  void add_batch(Index shape_number, const EliminatedPiece* const* members, std::size_t count) {
    const PieceShape& shape = out_.shapes[shape_number];
    PieceBatch batch;
    batch.shape = shape_number;
    batch.lanes = static_cast<int>(count);
    batch.sources = out_.sources.size();
    batch.nodes = out_.nodes.size();
    batch.slots = out_.border_slots.size();
    batch.values = out_.values_size;
    batch.vector = out_.vector_size;
    const Index all = shape.columns + shape.border;
    out_.values_size += static_cast<std::size_t>(shape.size * kLanes);
    out_.vector_size += static_cast<std::size_t>(3 * all * kLanes);
    out_.sources.resize(batch.sources + shape.blocks.size() * kLanes, 0);
    out_.nodes.resize(batch.nodes + static_cast<std::size_t>(all * kLanes), kNone);
    out_.border_slots.resize(batch.slots + shape.border_at.size() * kLanes, kNone);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::vector<Index> own = numbers_of(*members[lane]);
      for (std::size_t b = 0; b < shape.blocks.size(); ++b) {
        const Index row = own[shape.blocks[b].first], column = own[shape.blocks[b].second];
        out_.sources[batch.sources + b * kLanes + lane] = row == column ? row
                                                          : row > column
                                                              ? pattern_.slot(row, column)
                                                              : ~pattern_.slot(row, column);
      }
      for (std::size_t k = 0; k < own.size(); ++k)
        out_.nodes[batch.nodes + k * kLanes + lane] =
            k < static_cast<std::size_t>(shape.columns) ? own[k] : place_[own[k]];
      std::size_t pair = batch.slots + lane;
      for (Index p = 0; p < shape.border; ++p) {
        for (Index q = 0; q <= p; ++q, pair += kLanes) {
          const Index row = place_[own[shape.columns + p]], column = place_[own[shape.columns + q]];
          out_.border_slots[pair] = row == column  ? row
                                    : row > column ? out_.rest.slot(row, column)
                                                   : ~out_.rest.slot(row, column);
        }
      }
    }
    out_.batches.push_back(batch);
  }

  void count_work() {
    for (const PieceBatch& batch : out_.batches) {
      const PieceShape& shape = out_.shapes[batch.shape];
      for (Index c = 0; c < shape.columns; ++c) {
        const double below = 3.0 * (shape.starts[c + 1] - shape.starts[c]);
        out_.entries += batch.lanes * (6.0 + 3.0 * below);
        for (int pivot = 0; pivot < 3; ++pivot)
          out_.flops += batch.lanes * (below + 3.0 - pivot) * (below + 3.0 - pivot);
      }
    }
  }

  const BlockPattern& pattern_;
  const Graph& graph_;
  const std::vector<EliminatedPiece>& pieces_;
  std::vector<Index> place_;
  PieceBatches out_;
};

}  // namespace

kernels::PiecePlan PieceShape::plan() const {
  return {columns,
          border,
          at.data(),
          starts.data(),
          rows.data(),
          targets.data(),
          static_cast<int>(blocks.size()),
          places.data(),
          whole.data(),
          size};
}

PieceBatches make_batches(const BlockPattern& pattern, const Graph& graph,
                          const std::vector<EliminatedPiece>& pieces) {
  return Maker(pattern, graph, pieces).make();
}

}  // namespace retiarius
