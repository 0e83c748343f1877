#include "retiarius/measure/tension_window.hpp"

#include <algorithm>
#include <limits>

namespace retiarius {

namespace {
constexpr double kGroups = 512.0;  // pieces in a window at most, about
// Times are sums of steps: a window counts as full in spite of their rounding.
constexpr double kRounding = 1e-9;
}  // namespace

TensionWindow::TensionWindow(double width) : width_(width) { clear(); }

void TensionWindow::clear() {
  pieces_.clear();
  integral_.clear();
  length_ = 0.0;
  dropped_ = 0;
  largest_ = -std::numeric_limits<double>::infinity();
  full_ = false;
}

void TensionWindow::append(double h, const std::vector<double>& tension) {
  if (integral_.empty()) integral_.assign(tension.size(), 0.0);
  if (pieces_.empty() || pieces_.back().h + h > width_ / kGroups)
    pieces_.push_back({0.0, std::vector<double>(tension.size(), 0.0)});
  Piece& last = pieces_.back();
  for (std::size_t s = 0; s < tension.size(); ++s) {
    last.integral[s] += h * tension[s];
    integral_[s] += h * tension[s];
  }
  last.h += h;
  length_ += h;
}

void TensionWindow::drop_old() {
  while (pieces_.size() > 1 && length_ - pieces_.front().h >= width_ * (1.0 - kRounding)) {
    const Piece& old = pieces_.front();
    for (std::size_t s = 0; s < integral_.size(); ++s) integral_[s] -= old.integral[s];
    length_ -= old.h;
    pieces_.pop_front();
    ++dropped_;
  }
  if (dropped_ > pieces_.size()) sum_again();
}

// Running sums gather rounding; taken anew once in a window they cost as much as one step more.
void TensionWindow::sum_again() {
  std::fill(integral_.begin(), integral_.end(), 0.0);
  length_ = 0.0;
  for (const Piece& p : pieces_) {
    for (std::size_t s = 0; s < integral_.size(); ++s) integral_[s] += p.integral[s];
    length_ += p.h;
  }
  dropped_ = 0;
}

void TensionWindow::add(double h, const std::vector<double>& tension) {
  if (!(h > 0.0)) return;
  append(h, tension);
  drop_old();
  if (length_ < width_ * (1.0 - kRounding)) return;
  full_ = true;
  const Piece& old = pieces_.front();
  const double outside = std::max(0.0, length_ - width_) / old.h;
  for (std::size_t s = 0; s < integral_.size(); ++s)
    largest_ = std::max(largest_, (integral_[s] - outside * old.integral[s]) / width_);
}

std::optional<double> TensionWindow::largest() const {
  if (integral_.empty()) return std::nullopt;
  if (full_) return largest_;
  return *std::max_element(integral_.begin(), integral_.end()) / length_;
}

}  // namespace retiarius
