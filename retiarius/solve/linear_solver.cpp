// Bordered systems for solvers that give whole solutions only.
#include "retiarius/solve/linear_solver.hpp"

#include "retiarius/base/error.hpp"

namespace retiarius {

void LinearSolver::begin_bordered(const std::vector<BorderColumns>& border,
                                  const std::vector<Vec3>& r, Eigen::MatrixXd& products) const {
  border_ = kNone;
  bordered_.resize(6 * border.size() + 1);
  auto column = bordered_.begin();
  for (const BorderColumns& b : border) {
    for (int c = 0; c < 6; ++c, ++column) {
      column->assign(r.size(), Vec3::Zero());
      for (std::size_t i = 0; i < b.nodes->size(); ++i)
        (*column)[(*b.nodes)[i]] = (*b.rows)[i].row(c).transpose();
    }
  }
  *column = r;
  for (std::vector<Vec3>& x : bordered_) solve(x);
  const auto count = static_cast<Eigen::Index>(bordered_.size());
  products.resize(count - 1, count);
  for (Eigen::Index j = 0; j < count; ++j) find_products(border, j, products);
  border_ = count - 1;
}

// Of one column of A^-1 [B r] with B^T.
void LinearSolver::find_products(const std::vector<BorderColumns>& border, Eigen::Index column,
                                 Eigen::MatrixXd& products) const {
  const std::vector<Vec3>& x = bordered_[static_cast<std::size_t>(column)];
  for (std::size_t p = 0; p < border.size(); ++p) {
    auto sum = products.block<6, 1>(static_cast<Eigen::Index>(6 * p), column);
    sum.setZero();
    for (std::size_t i = 0; i < border[p].nodes->size(); ++i)
      sum.noalias() += (*border[p].rows)[i] * x[(*border[p].nodes)[i]];
  }
}

void LinearSolver::repeat_bordered(const std::vector<BorderColumns>& border,
                                   const std::vector<Vec3>& r, Eigen::MatrixXd& products) const {
  if (static_cast<Eigen::Index>(6 * border.size()) != border_ || products.rows() != border_ ||
      products.cols() != border_ + 1)
    throw Error("repeat_bordered() needs begin_bordered() with the same border before it");
  bordered_.back() = r;
  solve(bordered_.back());
  find_products(border, border_, products);
}

void LinearSolver::end_bordered(const Eigen::VectorXd& c, std::vector<Vec3>& x) const {
  if (c.size() != border_)
    throw Error("end_bordered() needs begin_bordered() with as many columns before it");
  x = bordered_.back();
  for (std::size_t i = 0; i < x.size(); ++i)
    for (Eigen::Index k = 0; k < c.size(); ++k)
      x[i] -= c[k] * bordered_[static_cast<std::size_t>(k)][i];
}

}  // namespace retiarius
