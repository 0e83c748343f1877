// Direct solution of symmetric positive definite block systems: the face of every factorisation.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "retiarius/base/block_matrix.hpp"

namespace retiarius {

using Mat63 = Eigen::Matrix<double, 6, 3>;

// Six columns that are zero but at some nodes: rows[i] is what they have at nodes[i], transposed.
struct BorderColumns {
  const std::vector<Index>* nodes;
  const std::vector<Mat63>* rows;
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  virtual std::string_view name() const = 0;

  // Symbolic work: ordering, elimination tree, storage. Needed once for each pattern.
  virtual void analyse(const BlockPattern& pattern) = 0;

  // As analyse(), for a pattern much like the last one: the order of elimination may stay. True if
  // it does, so that analyse() might give another one.
  virtual bool analyse_again(const BlockPattern& pattern) {
    analyse(pattern);
    return false;
  }

  // Whether the next patterns will follow each other soon: then analyse() takes the first good
  // order instead of the best of several. Solvers without such a choice ignore it.
  virtual void expect_changes(bool /*soon*/) {}

  // Factorises; false when the matrix is not positive definite (a pivot was not positive).
  virtual bool factor(const BlockMatrix& matrix) = 0;

  // Whether to keep the partial results that refactor() needs, from the next factor() on; they may
  // double the memory. Solvers without use for them ignore it.
  virtual void keep_parts(bool /*keep*/) {}

  // As factor(), with the same result to the last bit, where the matrix differs from that of the
  // last call in rows and columns of `changed` alone (in any order, also several times each). What
  // does not depend on those stays where parts are kept and the last call succeeded.
  virtual bool refactor(const BlockMatrix& matrix, const std::vector<Index>& /*changed*/) {
    return factor(matrix);
  }

  // Solves in place. Throws Error unless the last factor() succeeded, or where x does not fit. This
  // and what follows uses storage of the solver: not from two threads at once.
  virtual void solve(std::vector<Vec3>& x) const = 0;

  // For a matrix A bordered by dense columns B, where solutions are wanted only together: the first
  // half makes the products B^T A^-1 [B r] of which the border's Schur complement is made, the
  // second the solution A^-1 (r - B c) for what that gives. As solve() otherwise. The first half
  // may be repeated for another r with the same factor and border, with the products it has made.
  virtual void begin_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                              Eigen::MatrixXd& products) const;
  virtual void repeat_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                               Eigen::MatrixXd& products) const;
  virtual void end_bordered(const Eigen::VectorXd& c, std::vector<Vec3>& x) const;

  // Numbers of the analysis: nonzero scalars of the factor and floating-point operations.
  virtual double factor_entries() const = 0;
  virtual double factor_flops() const = 0;

 private:
  void find_products(const std::vector<BorderColumns>& border, Eigen::Index column,
                     Eigen::MatrixXd& products) const;

  mutable std::vector<std::vector<Vec3>> bordered_;  // A^-1 [B r], column by column
  mutable Eigen::Index border_ = kNone;              // columns of B there
};

// The slow readable reference: Eigen's simplicial LDLT on scalars.
std::unique_ptr<LinearSolver> make_reference_solver();

// Multifrontal 3x3-block Cholesky under nested dissection.
std::unique_ptr<LinearSolver> make_multifrontal_solver();

// The inner nodes of a net's pieces in vectors, eight pieces at once, then the rest by the
// multifrontal solver.
std::unique_ptr<LinearSolver> make_piece_solver();

// Of the residual in the norm of the preconditioner: Newton's iteration then still gains as many
// digits in each step as it needs in all.
inline constexpr double kPcgTolerance = 1e-6;

// Conjugate gradients preconditioned by the diagonal blocks, to a relative residual of that.
// factor() sees only whether those are definite; where the rest is not, solutions are NaN.
std::unique_ptr<LinearSolver> make_pcg_solver();

// The better of the two direct ones by the counts of the pattern; name() tells which.
std::unique_ptr<LinearSolver> make_net_solver();

}  // namespace retiarius
