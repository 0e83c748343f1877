// The largest mean of one segment's tension over a sliding window of time.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "retiarius/base/archive.hpp"

namespace retiarius {

// Snaps of a stiff thread last less than a step; what a thread or seam feels is their mean over a
// while. The tension of a step holds over the whole step, so means are weighted with time. Windows
// end at accepted steps; of the step that reaches out of the window only the part inside counts.
// Windows that would begin before the run count only if the whole run is shorter than one: then it
// is the mean over the run.
//
// Memory is bounded: steps shorter than a 512th of the window are kept in groups of that length.
class TensionWindow {
 public:
  explicit TensionWindow(double width = 0.02);  // s

  // A step of length h (s) with the tension of each segment in it, N.
  void add(double h, const std::vector<double>& tension);
  void clear();

  // N; absent before the first step.
  std::optional<double> largest() const;

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive) {
    archive(pieces_, integral_, length_, dropped_, largest_, full_);
  }

 private:
  struct Piece {
    double h = 0.0;                // s
    std::vector<double> integral;  // of each segment's tension over the piece, N s
    void transfer(Archive& archive) { archive(h, integral); }
  };

  void append(double h, const std::vector<double>& tension);
  void drop_old();
  void sum_again();

  double width_;
  std::deque<Piece> pieces_;      // the oldest may reach out of the window
  std::vector<double> integral_;  // over all pieces, N s
  double length_ = 0.0;           // of all pieces, s
  std::size_t dropped_ = 0;       // pieces since the sums were last taken anew
  double largest_ = 0.0;
  bool full_ = false;  // a whole window has passed
};

}  // namespace retiarius
