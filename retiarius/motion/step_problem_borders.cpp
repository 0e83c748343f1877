// The bodies' share of a Newton system: six dense columns each, eliminated by their Schur
// complement.
#include <algorithm>

#include "retiarius/motion/step_problem.hpp"

namespace retiarius {

Mat63& StepProblem::Border::at(Index node) {
  if (place[node] == kNone) {
    place[node] = static_cast<Index>(nodes.size());
    nodes.push_back(node);
    rows.push_back(Mat63::Zero());
  }
  return rows[place[node]];
}

void StepProblem::Border::clear() {
  for (const Index node : nodes) place[node] = kNone;
  nodes.clear();
  rows.clear();
}

// The columns K N J of the bodies that touch.
void StepProblem::build_borders() {
  for (const Index body : touching_) borders_[body].clear();
  touching_.clear();
  for (const Constraint& c : constraints_) {
    if (c.body == kNone) continue;
    Border& border = borders_[c.body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
    if (border.nodes.empty()) touching_.push_back(c.body);
    const Mat63 follows = lever_map(c).transpose() * c.blocked;
    border.at(c.node) += follows * matrix_.diagonal[c.node].transpose();
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s) {
      const Neighbour& n = neighbours_[s];
      const Mat3& block = matrix_.below[n.slot];
      border.at(n.node) += n.row ? Mat63(follows * block) : Mat63(follows * block.transpose());
    }
  }
  for (const ContactAssembly::NodeBody& e : node_body_) {
    Border& border = borders_[e.body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
    border.at(e.node) += e.block.transpose();
    touching_.push_back(e.body);
  }
  for (const ContactAssembly::BodyBody& e : body_body_)
    touching_.insert(touching_.end(), {e.first, e.second});
  std::sort(touching_.begin(), touching_.end());
  touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
  for (const Index body : touching_) {
    Border& border = borders_[body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
  }
  build_border_diagonal();
  add_body_blocks();
}

// The blocks J^T N K N J of each pair of bodies that touch, with the bodies' masses.
void StepProblem::build_border_diagonal() {
  const std::size_t count = touching_.size();
  border_diagonal_.assign(count * count, Mat6::Zero());
  for (std::size_t p = 0; p < count; ++p) {
    border_diagonal_[p * count + p] = body_mass_[touching_[p]];
    for (const Constraint& c : constraints_) {
      if (c.body != touching_[p]) continue;
      const Mat63 follows = lever_map(c).transpose() * c.blocked;
      for (std::size_t q = 0; q < count; ++q) {
        const Border& border = borders_[touching_[q]];
        const Index place = border.place[c.node];
        if (place == kNone) continue;
        border_diagonal_[p * count + q] += follows * border.rows[place].transpose();
      }
    }
  }
}

// Second derivatives of the barriers in the bodies' own unknowns.
void StepProblem::add_body_blocks() {
  const std::size_t count = touching_.size();
  const auto place_of = [&](Index body) {
    return static_cast<std::size_t>(std::lower_bound(touching_.begin(), touching_.end(), body) -
                                    touching_.begin());
  };
  for (const ContactAssembly::BodyBody& e : body_body_) {
    const std::size_t p = place_of(e.first), q = place_of(e.second);
    border_diagonal_[p * count + q] += e.block;
    if (p != q) border_diagonal_[q * count + p] += e.block.transpose();
  }
}

// A^-1 B, one column after the other, and after them A^-1 dy, which goes back to its place.
void StepProblem::solve_with_border_columns() {
  const std::size_t n = dy_.size();
  columns_.assign(6 * touching_.size() * n, Vec3::Zero());
  columns_.insert(columns_.end(), dy_.begin(), dy_.end());
  Vec3* first = columns_.data();
  for (const Index body : touching_) {
    const Border& border = borders_[body];
    for (int k = 0; k < 6; ++k, first += n) {
      for (std::size_t t = 0; t < border.nodes.size(); ++t) {
        first[border.nodes[t]] = border.rows[t].row(k).transpose();
      }
    }
  }
  active_->solve(columns_);
  std::copy(columns_.end() - static_cast<std::ptrdiff_t>(n), columns_.end(), dy_.begin());
}

// B^T x for the columns of one touching body.
Vec6 StepProblem::border_times(std::size_t body, const Vec3* x) const {
  const Border& border = borders_[touching_[body]];
  Vec6 sum = Vec6::Zero();
  for (std::size_t t = 0; t < border.nodes.size(); ++t) {
    sum.noalias() += border.rows[t] * x[border.nodes[t]];
  }
  return sum;
}

// The bodies' Schur complement D - B^T A^-1 B, factorised.
void StepProblem::build_schur() {
  const std::size_t n = dy_.size(), count = touching_.size();
  const Eigen::Index size = static_cast<Eigen::Index>(6 * count);
  schur_.resize(size, size);
  for (std::size_t p = 0; p < count; ++p) {
    const Eigen::Index row = static_cast<Eigen::Index>(6 * p);
    for (std::size_t q = 0; q < count; ++q) {
      for (int l = 0; l < 6; ++l) {
        const std::size_t column = 6 * q + static_cast<std::size_t>(l);
        schur_.block<6, 1>(row, static_cast<Eigen::Index>(column)) =
            border_diagonal_[p * count + q].col(l) - border_times(p, columns_.data() + column * n);
      }
    }
  }
  schur_factor_.compute(0.5 * (schur_ + schur_.transpose()));
}

// A dy + B db = r for the net and B^T dy + D db = -g_b for the bodies, with A^-1 r in dy on entry.
void StepProblem::solve_bordered() {
  const std::size_t n = dy_.size();
  const std::vector<Vec6>& body_gradient = reduced_body_gradient();
  schur_rhs_.resize(static_cast<Eigen::Index>(6 * touching_.size()));
  for (std::size_t p = 0; p < touching_.size(); ++p) {
    schur_rhs_.segment<6>(static_cast<Eigen::Index>(6 * p)) =
        -body_gradient[touching_[p]] - border_times(p, dy_.data());
  }
  schur_factor_.solveInPlace(schur_rhs_);
  for (std::size_t p = 0; p < touching_.size(); ++p) {
    db_[touching_[p]] = schur_rhs_.segment<6>(static_cast<Eigen::Index>(6 * p));
  }
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 d = dy_[i];
    for (Eigen::Index m = 0; m < schur_rhs_.size(); ++m) {
      d -= schur_rhs_(m) * columns_[static_cast<std::size_t>(m) * n + i];
    }
    dy_[i] = d;
  }
}

}  // namespace retiarius
