// The slow readable reference: Eigen's simplicial LDLT on scalars, ordered by minimum degree.
#include <cmath>
#include <utility>

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/linear_solver.hpp"

namespace retiarius {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

// Gives access to the factor's pattern, which is known before the first factorisation.
struct Ldlt : Eigen::SimplicialLDLT<Sparse, Eigen::Lower> {
  const Sparse& lower() const { return m_matrix; }
};

// The lower triangle as a scalar matrix.
Sparse scalar_matrix(const BlockMatrix& matrix) {
  const BlockPattern& pattern = *matrix.pattern;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * (matrix.diagonal.size() + matrix.below.size()));
  const auto add = [&entries](Index row, Index column, const Mat3& block) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        if (3 * row + a >= 3 * column + b) {
          entries.emplace_back(3 * row + a, 3 * column + b, block(a, b));
        }
      }
    }
  };
  for (Index c = 0; c < pattern.blocks(); ++c) {
    add(c, c, matrix.diagonal[c]);
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      add(pattern.rows()[k], c, matrix.below[k]);
    }
  }
  const Eigen::Index size = 3L * pattern.blocks();
  Sparse sparse(size, size);
  sparse.setFromTriplets(entries.begin(), entries.end());
  return sparse;
}

class ReferenceSolver : public LinearSolver {
 public:
  std::string_view name() const override { return "reference"; }

  void analyse(const BlockPattern& pattern) override {
    BlockMatrix ones;
    ones.reset(pattern);
    for (Mat3& block : ones.below) block.setOnes();
    for (Mat3& block : ones.diagonal) block.setOnes();
    blocks_ = pattern.blocks();
    factored_ = false;
    ldlt_.analyzePattern(scalar_matrix(ones));
  }

  bool factor(const BlockMatrix& matrix) override {
    if (matrix.pattern == nullptr || matrix.pattern->blocks() != blocks_) {
      throw Error("the matrix does not have the pattern that was analysed");
    }
    ldlt_.factorize(scalar_matrix(matrix));
    factored_ = ldlt_.info() == Eigen::Success;
    if (factored_) {
      const Eigen::VectorXd pivots = ldlt_.vectorD();
      for (const double pivot : pivots) factored_ = factored_ && pivot > 0 && std::isfinite(pivot);
    }
    return factored_;
  }

  void solve(std::vector<Vec3>& x) const override {
    if (!factored_) throw Error("solve() needs a successful factor() before it");
    if (x.size() != static_cast<std::size_t>(blocks_)) {
      throw Error(fmt::format("a right-hand side of {} blocks does not fit a matrix of {}",
                              x.size(), blocks_));
    }
    if (x.empty()) return;
    Eigen::Map<Eigen::VectorXd> vector(x.front().data(), 3L * blocks_);
    const Eigen::VectorXd solution = ldlt_.solve(vector);
    vector = solution;
  }

  // The pivots are stored apart from the strict lower triangle.
  double factor_entries() const override {
    return static_cast<double>(ldlt_.lower().nonZeros() + ldlt_.lower().cols());
  }

  double factor_flops() const override {
    double flops = 0.0;
    const Sparse& l = ldlt_.lower();
    for (Eigen::Index c = 0; c < l.cols(); ++c) {
      const double count = 1.0 + l.outerIndexPtr()[c + 1] - l.outerIndexPtr()[c];
      flops += count * count;
    }
    return flops;
  }

 private:
  Ldlt ldlt_;
  Index blocks_ = 0;
  bool factored_ = false;
};

}  // namespace

std::unique_ptr<LinearSolver> make_reference_solver() {
  return std::make_unique<ReferenceSolver>();
}

}  // namespace retiarius
