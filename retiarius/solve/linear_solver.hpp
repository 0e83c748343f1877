// Direct solution of symmetric positive definite block systems: the face of every factorisation.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "retiarius/base/block_matrix.hpp"

namespace retiarius {

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  virtual std::string_view name() const = 0;

  // Symbolic work: ordering, elimination tree, storage. Needed once for each pattern.
  virtual void analyse(const BlockPattern& pattern) = 0;

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

  // Solves in place for one right-hand side, or for several, one after the other in x: up to eight
  // of them cost little more than one, and a solution does not depend on the others that it is
  // found with, though one found alone may differ by rounding. Throws Error unless the last
  // factor() succeeded. Uses storage of the solver: not from two threads at once.
  virtual void solve(std::vector<Vec3>& x) const = 0;

  // Numbers of the analysis: nonzero scalars of the factor and floating-point operations.
  virtual double factor_entries() const = 0;
  virtual double factor_flops() const = 0;
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
