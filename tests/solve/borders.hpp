// Dense borders for the tests of linear solvers.
#pragma once

#include <vector>

#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius::test {

// A border of some bodies' columns, at one node of `stride` each.
struct Border {
  std::vector<std::vector<Index>> nodes;
  std::vector<std::vector<Mat63>> rows;
  std::vector<BorderColumns> columns;

  Border(int bodies, Index blocks, unsigned seed, Index stride = 2) : nodes(bodies), rows(bodies) {
    const std::vector<Vec3> values = random_vector(6 * bodies * blocks, seed);
    auto next = values.begin();
    for (int b = 0; b < bodies; ++b) {
      for (Index i = (b + blocks) % 3; i < blocks; i += stride + b) {
        nodes[b].push_back(i);
        rows[b].emplace_back();
        for (int c = 0; c < 6; ++c) rows[b].back().row(c) = (next++)->transpose();
      }
      columns.push_back({&nodes[b], &rows[b]});
    }
  }

  std::vector<Vec3> times(const Eigen::VectorXd& c, Index blocks) const {
    std::vector<Vec3> sum(static_cast<std::size_t>(blocks), Vec3::Zero());
    for (std::size_t b = 0; b < nodes.size(); ++b)
      for (std::size_t i = 0; i < nodes[b].size(); ++i)
        sum[nodes[b][i]] += rows[b][i].transpose() * c.segment<6>(static_cast<Eigen::Index>(6 * b));
    return sum;
  }
};

}  // namespace retiarius::test
