// Cholesky factorisation of nets: the inner nodes of pieces are eliminated first, eight pieces at
// once in the lanes of vectors, and what is left, mostly knots, by the multifrontal method.
//
// A = [A11 A21^T; A21 A22] with A11 block diagonal, a piece a block: A11 = L D L^T, and the rest is
// A22 - A21 A11^-1 A21^T. Every sum has a fixed order, so that results do not depend on the number
// of threads.
#include <algorithm>
#include <atomic>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/aligned_array.hpp"
#include "retiarius/solve/flush_denormals.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "retiarius/solve/piece_batches.hpp"

namespace retiarius {

namespace {

constexpr long kLanes = kernels::kPieceLanes;
constexpr std::size_t kGrain = 8;      // batches that a thread takes at once
constexpr std::size_t kBlocks = 2048;  // ... and blocks

class PieceSolver : public LinearSolver {
 public:
  explicit PieceSolver(bool always) : always_(always), rest_(make_multifrontal_solver()) {}

  std::string_view name() const override {
    return always_ || with_pieces_ ? "pieces" : rest_->name();
  }
  void analyse(const BlockPattern& pattern) override;
  bool analyse_again(const BlockPattern& pattern) override;
  void expect_changes(bool soon) override { rest_->expect_changes(soon); }
  bool factor(const BlockMatrix& matrix) override { return factor(matrix, nullptr); }
  void keep_parts(bool keep) override;
  bool refactor(const BlockMatrix& matrix, const std::vector<Index>& changed) override {
    return factor(matrix, &changed);
  }
  void solve(std::vector<Vec3>& x) const override;
  void begin_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                      Eigen::MatrixXd& products) const override {
    if (with_pieces_) return LinearSolver::begin_bordered(border, r, products);
    rest_->begin_bordered(border, r, products);
  }
  void repeat_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                       Eigen::MatrixXd& products) const override {
    if (with_pieces_) return LinearSolver::repeat_bordered(border, r, products);
    rest_->repeat_bordered(border, r, products);
  }
  void end_bordered(const Eigen::VectorXd& c, std::vector<Vec3>& x) const override {
    if (with_pieces_) return LinearSolver::end_bordered(c, x);
    rest_->end_bordered(c, x);
  }
  double factor_entries() const override { return rest_->factor_entries() + batches_.entries; }
  double factor_flops() const override { return rest_->factor_flops() + batches_.flops; }

 private:
  bool factor(const BlockMatrix& matrix, const std::vector<Index>* changed);
  bool make_pieces(const BlockPattern& pattern);
  void number_batches();
  void mark_changes(const std::vector<Index>& changed);
  bool eliminate(const BlockMatrix& matrix);
  void assemble_rest(const BlockMatrix& matrix);
  void forward(const PieceBatch& batch, const Vec3* x) const;
  void backward(const PieceBatch& batch, Vec3* x) const;
  template <class Body>
  void each_batch(const Body& body) const {
    const auto range = [&](std::size_t begin, std::size_t end) {
      const FlushDenormals flush;
      for (std::size_t b = begin; b < end; ++b) body(b);
    };
    parallel_for(batches_.batches.size(), kGrain, range);
  }
  kernels::PiecePlan plan(const PieceBatch& batch) const {
    return batches_.shapes[batch.shape].plan();
  }

  bool always_, with_pieces_ = false, analysed_ = false, factored_ = false;
  std::unique_ptr<LinearSolver> rest_;
  PieceBatches batches_;
  Index blocks_ = 0, pairs_ = 0;
  AlignedArray values_;
  BlockMatrix rest_matrix_;
  bool keeps_parts_ = false, has_parts_ = false;
  std::vector<Index> batch_of_;   // of each block, or kNone
  std::vector<char> is_changed_;  // whether each batch depends on a block that changed
  std::vector<Index> rest_changed_;
  std::atomic<bool> failed_ = false;
  mutable AlignedArray vectors_;
  mutable std::vector<Vec3> rest_vector_;
};

// Whether eliminating pieces first is quicker: measured on nets, see docs/theory.md.
bool pays(const PieceBatches& batches, Index blocks) {
  return 2 * batches.columns >= blocks && batches.columns >= 200;
}

void PieceSolver::analyse(const BlockPattern& pattern) {
  analysed_ = factored_ = has_parts_ = false;
  blocks_ = pattern.blocks();
  pairs_ = pattern.pairs();
  with_pieces_ = make_pieces(pattern);
  if (!with_pieces_) {
    rest_->analyse(pattern);
  } else {
    rest_->analyse(batches_.rest);
    values_.resize(batches_.values_size);
    vectors_.resize(batches_.vector_size);
    rest_matrix_.reset(batches_.rest);
    rest_vector_.assign(batches_.kept.size(), Vec3::Zero());
    number_batches();
  }
  analysed_ = true;
}

// Whether it pays to eliminate them first; there are none where it does not.
bool PieceSolver::make_pieces(const BlockPattern& pattern) {
  const Graph graph = block_graph(pattern);
  batches_ = make_batches(pattern, graph, find_pieces(graph));
  const bool serve = batches_.columns > 0 && (always_ || pays(batches_, blocks_));
  if (!serve) batches_ = PieceBatches();
  return serve;
}

// Where pieces do not pay they hardly do with a few more pairs, which make them shorter.
bool PieceSolver::analyse_again(const BlockPattern& pattern) {
  if (!analysed_ || with_pieces_ || pattern.blocks() != blocks_) {
    analyse(pattern);
    return false;
  }
  factored_ = has_parts_ = false;
  pairs_ = pattern.pairs();
  if (rest_->analyse_again(pattern)) return true;
  if (make_pieces(pattern)) analyse(pattern);
  return false;
}

void PieceSolver::number_batches() {
  batch_of_.assign(static_cast<std::size_t>(blocks_), kNone);
  for (std::size_t b = 0; b < batches_.batches.size(); ++b) {
    const PieceBatch& batch = batches_.batches[b];
    const Index* node = batches_.nodes.data() + batch.nodes;
    for (Index c = 0; c < batches_.shapes[batch.shape].columns; ++c, node += kLanes)
      for (int lane = 0; lane < batch.lanes; ++lane) batch_of_[node[lane]] = static_cast<Index>(b);
  }
}

void PieceSolver::keep_parts(bool keep) {
  keeps_parts_ = keep;
  has_parts_ = has_parts_ && keep;
  rest_->keep_parts(keep);
}

// All of it, or what depends on blocks that changed.
bool PieceSolver::factor(const BlockMatrix& matrix, const std::vector<Index>* changed) {
  if (!analysed_) throw Error("factor() needs analyse() before it");
  if (!with_pieces_) return changed ? rest_->refactor(matrix, *changed) : rest_->factor(matrix);
  if (matrix.diagonal.size() != static_cast<std::size_t>(blocks_) ||
      matrix.below.size() != static_cast<std::size_t>(pairs_)) {
    throw Error(
        fmt::format("the matrix has {} blocks and {} pairs, the pattern that was analysed "
                    "{} and {}; analyse its pattern first",
                    matrix.diagonal.size(), matrix.below.size(), blocks_, pairs_));
  }
  const bool again = changed && has_parts_;
  if (again)
    mark_changes(*changed);
  else
    is_changed_.assign(batches_.batches.size(), 1);
  has_parts_ = false;
  factored_ = eliminate(matrix);
  if (!factored_) return false;
  assemble_rest(matrix);
  factored_ = again ? rest_->refactor(rest_matrix_, rest_changed_) : rest_->factor(rest_matrix_);
  has_parts_ = keeps_parts_ && factored_;
  return factored_;
}

// Batches that depend on the blocks given, and blocks of the rest that depend on either.
void PieceSolver::mark_changes(const std::vector<Index>& changed) {
  is_changed_.assign(batches_.batches.size(), 0);
  rest_changed_.clear();
  for (const Index block : changed) {
    if (batches_.place[block] != kNone)
      rest_changed_.push_back(batches_.place[block]);
    else
      is_changed_[batch_of_[block]] = 1;
  }
  for (std::size_t b = 0; b < batches_.batches.size(); ++b) {
    if (!is_changed_[b]) continue;
    const PieceBatch& batch = batches_.batches[b];
    const PieceShape& shape = batches_.shapes[batch.shape];
    const Index* node = batches_.nodes.data() + batch.nodes + shape.columns * kLanes;
    for (Index p = 0; p < shape.border; ++p, node += kLanes)
      rest_changed_.insert(rest_changed_.end(), node, node + batch.lanes);
  }
}

bool PieceSolver::eliminate(const BlockMatrix& matrix) {
  failed_ = false;
  const kernels::PieceTable& kernel = kernels::pieces();
  const double* const diagonal = matrix.diagonal.front().data();
  const double* const below = matrix.below.empty() ? nullptr : matrix.below.front().data();
  each_batch([&](std::size_t b) {
    if (failed_ || !is_changed_[b]) return;
    const PieceBatch& batch = batches_.batches[b];
    double* const values = values_.data() + batch.values;
    kernel.gather(plan(batch), batches_.sources.data() + batch.sources, batch.lanes, diagonal,
                  below, values);
    if (!kernel.factor(plan(batch), values)) failed_ = true;
  });
  return !failed_;
}

// The matrix's own blocks, and what the pieces add, one after the other.
void PieceSolver::assemble_rest(const BlockMatrix& matrix) {
  parallel_for(batches_.kept.size(), kBlocks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      rest_matrix_.diagonal[k] = matrix.diagonal[batches_.kept[k]];
  });
  parallel_for(batches_.kept_slots.size(), kBlocks, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Index slot = batches_.kept_slots[k];
      if (slot == kNone)
        rest_matrix_.below[k].setZero();
      else
        rest_matrix_.below[k] = matrix.below[slot];
    }
  });
  for (const PieceBatch& batch : batches_.batches) {
    const PieceShape& shape = batches_.shapes[batch.shape];
    const double* const values = values_.data() + batch.values;
    for (int lane = 0; lane < batch.lanes; ++lane) {
      std::size_t slot = batch.slots + static_cast<std::size_t>(lane);
      auto at = shape.border_at.begin();
      for (Index p = 0; p < shape.border; ++p) {
        for (Index q = 0; q <= p; ++q, ++at, slot += kLanes) {
          const double* const from = values + static_cast<long>(*at) * kLanes + lane;
          const Index to = batches_.border_slots[slot];
          if (p == q) {
            Mat3& m = rest_matrix_.diagonal[to];
            for (int c = 0, k = 0; c < 3; ++c)
              for (int r = c; r < 3; ++r, ++k) {
                m(r, c) += from[k * kLanes];
                if (r != c) m(c, r) += from[k * kLanes];
              }
          } else {
            const Eigen::Map<const Mat3, 0, Eigen::Stride<3 * kLanes, kLanes>> block(from);
            if (to >= 0)
              rest_matrix_.below[to] += block;
            else
              rest_matrix_.below[~to] += block.transpose();
          }
        }
      }
    }
  }
}

void PieceSolver::solve(std::vector<Vec3>& x) const {
  if (!with_pieces_) return rest_->solve(x);
  if (!factored_) throw Error("solve() needs a successful factor() before it");
  const auto blocks = static_cast<std::size_t>(blocks_);
  if (x.size() != blocks) {
    throw Error(fmt::format("a right-hand side of {} blocks does not fit a matrix of {}", x.size(),
                            blocks));
  }
  for (std::size_t k = 0; k < rest_vector_.size(); ++k) rest_vector_[k] = x[batches_.kept[k]];
  each_batch([&](std::size_t b) { forward(batches_.batches[b], x.data()); });
  for (const PieceBatch& batch : batches_.batches) {
    const PieceShape& shape = batches_.shapes[batch.shape];
    const double* from = vectors_.data() + batch.vector + 3 * kLanes * shape.columns;
    const Index* node = batches_.nodes.data() + batch.nodes + shape.columns * kLanes;
    for (Index p = 0; p < shape.border; ++p, from += 3 * kLanes, node += kLanes)
      for (int lane = 0; lane < batch.lanes; ++lane)
        for (int k = 0; k < 3; ++k) rest_vector_[node[lane]][k] += from[k * kLanes + lane];
  }
  rest_->solve(rest_vector_);
  each_batch([&](std::size_t b) { backward(batches_.batches[b], x.data()); });
  for (std::size_t k = 0; k < rest_vector_.size(); ++k) x[batches_.kept[k]] = rest_vector_[k];
}

void PieceSolver::forward(const PieceBatch& batch, const Vec3* x) const {
  const PieceShape& shape = batches_.shapes[batch.shape];
  double* const own = vectors_.data() + batch.vector;
  double* to = own;
  const Index* node = batches_.nodes.data() + batch.nodes;
  for (Index c = 0; c < shape.columns; ++c, to += 3 * kLanes, node += kLanes) {
    for (int lane = 0; lane < batch.lanes; ++lane)
      for (int k = 0; k < 3; ++k) to[k * kLanes + lane] = x[node[lane]][k];
    for (int lane = batch.lanes; lane < kLanes; ++lane)
      for (int k = 0; k < 3; ++k) to[k * kLanes + lane] = 0.0;
  }
  std::fill_n(to, 3 * kLanes * shape.border, 0.0);
  kernels::pieces().forward(plan(batch), values_.data() + batch.values, own);
}

void PieceSolver::backward(const PieceBatch& batch, Vec3* x) const {
  const PieceShape& shape = batches_.shapes[batch.shape];
  double* const own = vectors_.data() + batch.vector;
  const Index* const nodes = batches_.nodes.data() + batch.nodes;
  for (Index c = shape.columns; c < shape.columns + shape.border; ++c) {
    for (int lane = 0; lane < batch.lanes; ++lane)
      for (int k = 0; k < 3; ++k)
        own[(3 * c + k) * kLanes + lane] = rest_vector_[nodes[c * kLanes + lane]][k];
  }
  kernels::pieces().backward(plan(batch), values_.data() + batch.values, own);
  for (Index c = 0; c < shape.columns; ++c) {
    for (int lane = 0; lane < batch.lanes; ++lane)
      for (int k = 0; k < 3; ++k) x[nodes[c * kLanes + lane]][k] = own[(3 * c + k) * kLanes + lane];
  }
}

}  // namespace

std::unique_ptr<LinearSolver> make_piece_solver() { return std::make_unique<PieceSolver>(true); }

std::unique_ptr<LinearSolver> make_net_solver() { return std::make_unique<PieceSolver>(false); }

}  // namespace retiarius
