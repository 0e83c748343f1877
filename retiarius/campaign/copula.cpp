#include "retiarius/campaign/copula.hpp"

#include <algorithm>

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "retiarius/campaign/normal.hpp"
#include "retiarius/campaign/statistics.hpp"

namespace retiarius {

namespace {

Eigen::MatrixXd matrix(const GroupSpec& group) {
  const auto n = static_cast<Eigen::Index>(group.variables.size());
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      group.correlation.data(), n, n);
}

}  // namespace

std::string correlation_problem(const GroupSpec& group) {
  const std::size_t n = group.variables.size();
  if (n < 2) return "a group has at least two variables";
  if (group.correlation.size() != n * n)
    return fmt::format("has {} numbers; {} variables need {} x {}", group.correlation.size(), n, n,
                       n);
  const Eigen::MatrixXd c = matrix(group);
  if ((c.diagonal().array() != 1.0).any()) return "must have ones on its diagonal";
  if (c != c.transpose()) return "must be symmetric";
  const Eigen::LLT<Eigen::MatrixXd> factor(c);
  const bool definite = factor.info() == Eigen::Success &&
                        Eigen::MatrixXd(factor.matrixL()).diagonal().minCoeff() > 1e-7;
  return definite ? "" : "must be positive definite: no variables can be correlated so";
}

Eigen::MatrixXd correlation_factor(const GroupSpec& group) {
  return Eigen::LLT<Eigen::MatrixXd>(matrix(group)).matrixL();
}

void correlate(const Eigen::MatrixXd& factor, std::vector<double>& shares) {
  Eigen::VectorXd scores(static_cast<Eigen::Index>(shares.size()));
  for (Eigen::Index i = 0; i < scores.size(); ++i)
    scores[i] = normal_quantile(shares[static_cast<std::size_t>(i)]);
  for (Eigen::Index i = 0; i < scores.size(); ++i) {
    double score = 0.0;
    for (Eigen::Index j = 0; j <= i; ++j) score += factor(i, j) * scores[j];
    shares[static_cast<std::size_t>(i)] =
        std::clamp(normal_share(score), 0x1.0p-53, 1.0 - 0x1.0p-53);
  }
}

}  // namespace retiarius
