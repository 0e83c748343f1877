// Conjugate gradients preconditioned by the inverses of the diagonal blocks (Y. Saad, Iterative
// Methods for Sparse Linear Systems, 2003, algorithm 9.1). Needs few iterations where inertia
// outweighs stiffness over a step.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/linear_solver.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kRows = 1024;  // that a thread takes at once
constexpr double kTolerance = kPcgTolerance;
constexpr int kMostIterations = 20000;  // beyond which a matrix counts as not definite

class PcgSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "pcg"; }
  void analyse(const BlockPattern& pattern) override;
  bool factor(const BlockMatrix& matrix) override;
  void solve(std::vector<Vec3>& x) const override;
  double factor_entries() const override { return 9.0 * static_cast<double>(values_.size()); }
  double factor_flops() const override { return 0.0; }

 private:
  struct Entry {
    Index column, slot;
    bool turned;  // the block comes transposed
  };
  double multiply() const;                     // ap = A p; returns p . ap
  double advance(double step, Vec3* x) const;  // returns r . z for the next residual
  double start(Vec3* x) const;

  std::size_t rows() const { return inverse_.size(); }

  std::vector<Index> starts_;
  std::vector<Entry> entries_;  // of each row, beside its diagonal block
  std::vector<Mat3> values_;    // of each row: the diagonal block, then those of the entries
  std::vector<Mat3> inverse_;   // of the diagonal blocks
  Index pairs_ = 0;
  bool factored_ = false;
  mutable std::vector<Vec3> r_, p_, ap_, z_;
};

void PcgSolver::analyse(const BlockPattern& pattern) {
  factored_ = false;
  pairs_ = pattern.pairs();
  const auto n = static_cast<std::size_t>(pattern.blocks());
  starts_.assign(n + 1, 0);
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      ++starts_[c + 1];
      ++starts_[pattern.rows()[k] + 1];
    }
  }
  for (std::size_t i = 0; i < n; ++i) starts_[i + 1] += starts_[i];
  entries_.resize(static_cast<std::size_t>(starts_.back()));
  std::vector<Index> next(starts_.begin(), starts_.end() - 1);
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      const Index r = pattern.rows()[k];
      entries_[next[r]++] = {c, k, false};
      entries_[next[c]++] = {r, k, true};
    }
  }
  values_.resize(n + entries_.size());
  inverse_.resize(n);
  for (std::vector<Vec3>* v : {&r_, &p_, &ap_, &z_}) v->assign(n, Vec3::Zero());
}

bool PcgSolver::factor(const BlockMatrix& matrix) {
  if (matrix.diagonal.size() != rows() || matrix.below.size() != static_cast<std::size_t>(pairs_)) {
    throw Error(
        fmt::format("the matrix has {} blocks and {} pairs, the pattern that was analysed "
                    "{} and {}; analyse its pattern first",
                    matrix.diagonal.size(), matrix.below.size(), rows(), pairs_));
  }
  const double bad = parallel_sum(rows(), kRows, [&](std::size_t begin, std::size_t end) {
    double count = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Mat3 own = matrix.diagonal[i].selfadjointView<Eigen::Lower>();
      const Eigen::LLT<Mat3> llt(own);
      Mat3* to = values_.data() + i + static_cast<std::size_t>(starts_[i]);
      *to++ = own;
      inverse_[i] = llt.solve(Mat3::Identity());
      if (llt.info() != Eigen::Success || !inverse_[i].allFinite()) ++count;
      for (Index k = starts_[i]; k < starts_[i + 1]; ++k) {
        const Entry& e = entries_[k];
        const Mat3& block = matrix.below[e.slot];
        if (!block.allFinite()) ++count;
        *to++ = e.turned ? Mat3(block.transpose()) : block;
      }
    }
    return count;
  });
  factored_ = bad == 0.0;
  return factored_;
}

// Where the matrix shows a direction of no positive curvature there is no answer but NaN.
void PcgSolver::solve(std::vector<Vec3>& x) const {
  if (!factored_) throw Error("solve() needs a successful factor() before it");
  if (x.size() != rows()) {
    throw Error(fmt::format("a right-hand side of {} blocks does not fit a matrix of {}", x.size(),
                            rows()));
  }
  const double first = start(x.data());
  double size = first;
  for (int k = 0; size > kTolerance * kTolerance * first; ++k) {
    const double curvature = multiply();
    if (!(curvature > 0.0) || k == kMostIterations) {
      std::fill(x.begin(), x.end(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      return;
    }
    const double next = advance(size / curvature, x.data());
    const double turn = next / size;
    size = next;
    parallel_for(rows(), kRows, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) p_[i] = z_[i] + turn * p_[i];
    });
  }
}

double PcgSolver::start(Vec3* x) const {
  return parallel_sum(rows(), kRows, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      r_[i] = x[i];
      p_[i] = inverse_[i] * r_[i];
      sum += r_[i].dot(p_[i]);
      x[i].setZero();
    }
    return sum;
  });
}

double PcgSolver::multiply() const {
  return parallel_sum(rows(), kRows, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Mat3* block = values_.data() + i + static_cast<std::size_t>(starts_[i]);
      Vec3 y = *block++ * p_[i];
      for (Index k = starts_[i]; k < starts_[i + 1]; ++k)
        y.noalias() += *block++ * p_[entries_[k].column];
      ap_[i] = y;
      sum += p_[i].dot(y);
    }
    return sum;
  });
}

double PcgSolver::advance(double step, Vec3* x) const {
  return parallel_sum(rows(), kRows, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      x[i] += step * p_[i];
      r_[i] -= step * ap_[i];
      z_[i] = inverse_[i] * r_[i];
      sum += r_[i].dot(z_[i]);
    }
    return sum;
  });
}

}  // namespace

std::unique_ptr<LinearSolver> make_pcg_solver() { return std::make_unique<PcgSolver>(); }

}  // namespace retiarius
