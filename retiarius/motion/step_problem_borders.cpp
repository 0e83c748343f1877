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

// A dy + B db = r for the net and B^T dy + D db = -g_b for the bodies, with r in dy on entry, by
// the bodies' Schur complement D - B^T A^-1 B. `again`: with the last factorisation.
void StepProblem::solve_bordered(bool again) {
  const std::size_t count = touching_.size();
  const auto row_of = [](std::size_t p) { return static_cast<Eigen::Index>(6 * p); };
  columns_.clear();
  for (const Index body : touching_)
    columns_.push_back({&borders_[body].nodes, &borders_[body].rows});
  if (again)
    active_->repeat_bordered(columns_, dy_, products_);
  else
    active_->begin_bordered(columns_, dy_, products_);
  const std::vector<Vec6>& body_gradient = reduced_body_gradient();
  schur_ = -products_.leftCols(row_of(count));
  schur_rhs_ = -products_.rightCols(1);
  for (std::size_t p = 0; p < count; ++p) {
    schur_rhs_.segment<6>(row_of(p)) -= body_gradient[touching_[p]];
    for (std::size_t q = 0; q < count; ++q)
      schur_.block<6, 6>(row_of(p), row_of(q)) += border_diagonal_[p * count + q];
  }
  schur_factor_.compute(0.5 * (schur_ + schur_.transpose()));
  schur_factor_.solveInPlace(schur_rhs_);
  for (std::size_t p = 0; p < count; ++p) db_[touching_[p]] = schur_rhs_.segment<6>(row_of(p));
  active_->end_bordered(schur_rhs_, dy_);
}

}  // namespace retiarius
