// Correlated groups of variables.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "retiarius/campaign/spec.hpp"

namespace retiarius {

// What is wrong with the group's correlation matrix; empty: nothing.
std::string correlation_problem(const GroupSpec& group);

// The lower factor L of the group's correlation matrix C = L L^T.
Eigen::MatrixXd correlation_factor(const GroupSpec& group);

// Independent uniform shares become correlated ones that are uniform each: a Gaussian copula (Nataf
// 1962), the shares of L z for the normal scores z of the given shares. In place.
void correlate(const Eigen::MatrixXd& factor, std::vector<double>& shares);

}  // namespace retiarius
