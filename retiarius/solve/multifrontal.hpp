// Multifrontal Cholesky factorisation in 3x3 blocks (J. W. H. Liu, The multifrontal method for
// sparse matrix solution: theory and practice, SIAM Review 34, 1992).
//
// A front takes the matrix's entries of its pivot columns and its children's updates, always in the
// same order, so that the factor does not depend on which thread computed what.
#pragma once

#include <atomic>
#include <vector>

#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/aligned_array.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "retiarius/solve/symbolic.hpp"

namespace retiarius {

class MultifrontalSolver : public LinearSolver {
 public:
  std::string_view name() const override { return "multifrontal"; }

  void analyse(const BlockPattern& pattern) override;
  bool analyse_again(const BlockPattern& pattern) override;
  void expect_changes(bool soon) override { trials_ = soon ? 1 : kOrderTrials; }
  bool factor(const BlockMatrix& matrix) override { return factor(matrix, nullptr); }
  void keep_parts(bool keep) override {
    keeps_parts_ = keep;
    has_parts_ = has_parts_ && keep;
  }
  bool refactor(const BlockMatrix& matrix, const std::vector<Index>& changed) override {
    return factor(matrix, &changed);
  }
  void solve(std::vector<Vec3>& x) const override;
  void begin_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                      Eigen::MatrixXd& products) const override;
  // The border's columns go along with r in the lanes of vectors at no cost to speak of.
  void repeat_bordered(const std::vector<BorderColumns>& border, const std::vector<Vec3>& r,
                       Eigen::MatrixXd& products) const override {
    begin_bordered(border, r, products);
  }
  void end_bordered(const Eigen::VectorXd& c, std::vector<Vec3>& x) const override;

  double factor_entries() const override { return symbolic_.entries; }
  double factor_flops() const override { return symbolic_.flops; }

 private:
  void use_analysis(const BlockPattern& pattern);
  bool factor(const BlockMatrix& matrix, const std::vector<Index>* changed);
  void mark_changes(const std::vector<Index>& changed);
  bool parallel() const { return threads() > 1 && symbolic_.tasks.size() > 1; }
  void place_kept();
  void reserve_updates();
  bool factor_serial();
  bool factor_parallel();
  void factor_above(Index f);
  void factor_task(Index task);
  bool factor_front(const Front& front, double* memory, bool spread);
  void assemble(const Front& front, double* panel) const;
  enum class Part { panel, update };
  void add_children(const Front& front, double* panel, double* update, double* memory, Part part);
  void make_update(const Front& front, const double* panel, double* update, bool spread) const;
  void place_sums();
  void add_sums(double* all, std::size_t width) const;
  template <class Body>
  void each_task(const Body& body) const;
  void check_size(std::size_t blocks) const;
  void forward(const Front& front, double* all, double* w) const;
  void backward(const Front& front, double* all, double* w) const;
  void forward_all() const;
  void backward_all() const;
  void mark_reached(const std::vector<BorderColumns>& border) const;
  template <class Body>
  void for_reached(const Body& body) const;
  void fill_lanes(const std::vector<BorderColumns>& border) const;
  void forward_half(Index front, double* w) const;
  void find_products(Eigen::MatrixXd& products) const;
  double* lanes_of(std::size_t group) const {
    return lanes_.data() + group * 3 * kernels::kLanes * half_.size();
  }

  // `memory` is the task's; one thread has its own.
  double* update_of(const Front& front, double* memory) {
    if (keeps_parts_) return kept_.data() + kept_updates_[&front - symbolic_.fronts.data()];
    if (!side_by_side_) return serial_.data() + front.update;
    return (front.update_shared ? shared_.data() : memory) + front.task_update;
  }

  int trials_ = kOrderTrials;
  Symbolic symbolic_;
  double first_cost_ = 0.0;      // of the pattern that the order was made for, see Symbolic
  std::vector<Index> position_;  // of each block in the order of elimination
  std::vector<Index> front_of_;  // of each position, the front that eliminates it
  Index pairs_ = 0;
  bool analysed_ = false, factored_ = false;
  AlignedArray factor_, serial_, shared_, tasks_;
  bool keeps_parts_ = false;
  AlignedArray kept_;  // all updates
  std::size_t kept_size_ = 0;
  std::vector<std::size_t> kept_updates_;  // where each front's begins
  bool has_parts_ = false;
  std::vector<char> is_changed_;            // whether each front depends on a block that changed
  mutable AlignedArray front_vector_;       // of the top, then one a task
  std::vector<std::size_t> front_vectors_;  // where those of the tasks begin
  std::vector<Index> sum_rows_;             // see place_sums()
  std::vector<Index> sum_starts_;           // of each task's own places
  mutable std::vector<Vec3> permuted_;      // the blocks, then the tasks' own places
  // Of begin_bordered(): kLanes columns interleaved, group after group, of the border and then r,
  // at the fronts that the border reaches; at the others r alone.
  mutable AlignedArray lanes_;
  mutable std::vector<Vec3> half_;
  mutable std::vector<char> reached_;
  mutable std::size_t lane_columns_ = 0;  // of the border; 0: none with this factor
  const BlockMatrix* matrix_ = nullptr;   // while factor() runs
  const kernels::KernelTable* kernels_ = nullptr;
  bool side_by_side_ = false;  // by tasks
  std::atomic<bool> failed_ = false;
};

}  // namespace retiarius
