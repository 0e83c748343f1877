// Eigen's METIS support needs the streams that it does not include.
#include <iostream>

#include <Eigen/MetisSupport>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>

#include "benchmarks/opponents/scalar_lower.hpp"
#include "benchmarks/opponents/solvers.hpp"

namespace retiarius::benchmarks {

namespace {

template <typename Ordering>
class EigenSolver final : public LinearSolver {
 public:
  explicit EigenSolver(std::string_view name) : name_(name) {}
  std::string_view name() const override { return name_; }

  void analyse(const BlockPattern& pattern) override {
    lower_ = ScalarLower(pattern);
    ldlt_.analyzePattern(view());
  }

  bool factor(const BlockMatrix& matrix) override {
    lower_.copy(matrix);
    ldlt_.factorize(view());
    return ldlt_.info() == Eigen::Success && ldlt_.vectorD().minCoeff() > 0.0;
  }

  void solve(std::vector<Vec3>& x) const override {
    Eigen::Map<Eigen::MatrixXd> b(x.front().data(), lower_.size(),
                                  static_cast<Eigen::Index>(3 * x.size()) / lower_.size());
    b = ldlt_.solve(b).eval();
  }

  double factor_entries() const override { return 0.0; }
  double factor_flops() const override { return 0.0; }

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  Eigen::Map<Sparse> view() {
    return {lower_.size(),
            lower_.size(),
            static_cast<Eigen::Index>(lower_.rows().size()),
            lower_.starts().data(),
            lower_.rows().data(),
            lower_.values().data()};
  }

  std::string_view name_;
  ScalarLower lower_;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Ordering> ldlt_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_eigen_amd_solver() {
  return std::make_unique<EigenSolver<Eigen::AMDOrdering<int>>>("Eigen LDLT, AMD");
}

std::unique_ptr<LinearSolver> make_eigen_metis_solver() {
  return std::make_unique<EigenSolver<Eigen::MetisOrdering<int>>>("Eigen LDLT, METIS");
}

}  // namespace retiarius::benchmarks
