#include <cstring>

#include <cholmod.h>

#include "benchmarks/opponents/scalar_lower.hpp"
#include "benchmarks/opponents/solvers.hpp"

namespace retiarius::benchmarks {

namespace {

class CholmodSolver final : public LinearSolver {
 public:
  CholmodSolver() {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_METIS;
    common_.postorder = 1;
  }
  ~CholmodSolver() override {
    if (factor_) cholmod_free_factor(&factor_, &common_);
    for (cholmod_dense** dense : {&x_, &y_, &e_})
      if (*dense) cholmod_free_dense(dense, &common_);
    cholmod_finish(&common_);
  }
  CholmodSolver(const CholmodSolver&) = delete;
  CholmodSolver& operator=(const CholmodSolver&) = delete;

  std::string_view name() const override { return "CHOLMOD supernodal, METIS"; }

  void analyse(const BlockPattern& pattern) override {
    lower_ = ScalarLower(pattern);
    cholmod_sparse matrix = view();
    factor_ = cholmod_analyze(&matrix, &common_);
  }

  bool factor(const BlockMatrix& matrix) override {
    lower_.copy(matrix);
    cholmod_sparse sparse = view();
    return cholmod_factorize(&sparse, factor_, &common_) && factor_->minor == factor_->n;
  }

  void solve(std::vector<Vec3>& x) const override {
    cholmod_dense b{};
    b.nrow = b.d = static_cast<std::size_t>(lower_.size());
    b.ncol = 3 * x.size() / b.nrow;
    b.nzmax = b.nrow * b.ncol;
    b.x = x.front().data();
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &x_, nullptr, &y_, &e_, &common_);
    std::memcpy(x.front().data(), x_->x, sizeof(double) * b.nzmax);
  }

  double factor_entries() const override { return common_.lnz; }
  double factor_flops() const override { return common_.fl; }

 private:
  cholmod_sparse view() {
    cholmod_sparse a{};
    a.nrow = a.ncol = static_cast<std::size_t>(lower_.size());
    a.nzmax = lower_.rows().size();
    a.p = lower_.starts().data();
    a.i = lower_.rows().data();
    a.x = lower_.values().data();
    a.stype = -1;
    a.itype = CHOLMOD_INT;
    a.xtype = CHOLMOD_REAL;
    a.dtype = CHOLMOD_DOUBLE;
    a.sorted = a.packed = 1;
    return a;
  }

  ScalarLower lower_;
  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  mutable cholmod_dense *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod_solver() { return std::make_unique<CholmodSolver>(); }

}  // namespace retiarius::benchmarks
