#include "retiarius/solve/pieces.hpp"

#include <algorithm>

namespace retiarius {

namespace {

constexpr Index kMostNeighbours = 4;  // of an inner node: two on each side, with bending
constexpr std::size_t kMostColumns = 40;
constexpr std::size_t kMostBorder = 4;

class Finder {
 public:
  Finder(const Graph& graph, Index most)
      : graph_(graph), inner_(graph.size()), taken_(graph.size()) {
    for (Index v = 0; v < graph.size(); ++v) inner_[v] = degree(v) <= most && degree(v) > 0;
    const std::vector<char> low = inner_;
    for (Index v = 0; v < graph.size(); ++v)
      if (low[v] && crosses(v, low)) inner_[v] = 0;
  }

  std::vector<EliminatedPiece> pieces() {
    std::vector<EliminatedPiece> result;
    for (Index v = 0; v < graph_.size(); ++v) {
      if (!inner_[v] || taken_[v]) continue;
      EliminatedPiece piece = piece_from(v);
      if (piece.columns.size() <= kMostColumns && piece.border.size() <= kMostBorder)
        result.push_back(std::move(piece));
    }
    return result;
  }

 private:
  Index degree(Index v) const { return graph_.starts[v + 1] - graph_.starts[v]; }

  bool neighbours(Index v, Index w) const {
    const auto begin = graph_.neighbours.begin() + graph_.starts[v];
    return std::binary_search(begin, begin + degree(v), w);
  }

  // Whether v is coupled to an earlier low vertex with which it shares a neighbour, but no low one:
  // the two are the last of their pieces, on both sides of a knot.
  bool crosses(Index v, const std::vector<char>& low) const {
    for (Index k = graph_.starts[v]; k < graph_.starts[v + 1]; ++k) {
      const Index w = graph_.neighbours[k];
      if (w > v || !low[w]) continue;
      bool shared_low = false, shared_high = false;
      for (Index m = graph_.starts[v]; m < graph_.starts[v + 1]; ++m) {
        const Index u = graph_.neighbours[m];
        if (u == w || !neighbours(w, u)) continue;
        (low[u] ? shared_low : shared_high) = true;
      }
      if (shared_high && !shared_low) return true;
    }
    return false;
  }

  Index inner_degree(Index v) const {
    Index count = 0;
    for (Index k = graph_.starts[v]; k < graph_.starts[v + 1]; ++k)
      count += inner_[graph_.neighbours[k]];
    return count;
  }

  // Vertices connected to v, level by level, within a level those of few inner neighbours first
  // (Cuthill and McKee 1969): from the end of a path that is the path's order.
  std::vector<Index> levels_from(Index v) {
    std::vector<Index> order{v};
    taken_[v] = 1;
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::size_t old = order.size();
      for (Index k = graph_.starts[order[at]]; k < graph_.starts[order[at] + 1]; ++k) {
        const Index w = graph_.neighbours[k];
        if (!inner_[w] || taken_[w]) continue;
        taken_[w] = 1;
        order.push_back(w);
      }
      std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(old), order.end(),
                       [this](Index a, Index b) { return inner_degree(a) < inner_degree(b); });
    }
    return order;
  }

  EliminatedPiece piece_from(Index v) {
    EliminatedPiece piece;
    const std::vector<Index> all = levels_from(v);
    for (const Index w : all) taken_[w] = 0;
    const Index end = *std::min_element(all.begin(), all.end(), [this](Index a, Index b) {
      return std::pair(inner_degree(a), a) < std::pair(inner_degree(b), b);
    });
    piece.columns = levels_from(end);
    for (const Index w : piece.columns) {
      for (Index k = graph_.starts[w]; k < graph_.starts[w + 1]; ++k) {
        const Index b = graph_.neighbours[k];
        if (inner_[b]) continue;
        if (std::find(piece.border.begin(), piece.border.end(), b) == piece.border.end())
          piece.border.push_back(b);
      }
    }
    return piece;
  }

  const Graph& graph_;
  std::vector<char> inner_, taken_;
};

std::size_t columns_of(const std::vector<EliminatedPiece>& pieces) {
  std::size_t sum = 0;
  for (const EliminatedPiece& p : pieces) sum += p.columns.size();
  return sum;
}

}  // namespace

std::vector<EliminatedPiece> find_pieces(const Graph& graph) {
  std::vector<EliminatedPiece> best;
  for (Index most = 1; most <= kMostNeighbours; ++most) {
    std::vector<EliminatedPiece> found = Finder(graph, most).pieces();
    if (columns_of(found) > columns_of(best)) best = std::move(found);
  }
  return best;
}

}  // namespace retiarius
