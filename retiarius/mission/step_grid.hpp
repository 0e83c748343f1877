// Times on regular grids: k h, never summed.
#pragma once

#include <cmath>
#include <cstdint>

#include "retiarius/base/archive.hpp"

namespace retiarius {

// Times within this share of the spacing count as on the grid.
inline constexpr double kGridTolerance = 1e-6;

// Times closer than this are one, s: what a step between them changes would be lost in rounding.
inline constexpr double kSameTime = 1e-9;

// The first multiple of h after `now`.
inline double next_on_grid(double now, double h) {
  return (std::floor(now / h + kGridTolerance) + 1.0) * h;
}

// Tells which states are written: those at multiples of an interval, and the last one.
class OutputGrid {
 public:
  explicit OutputGrid(double interval) : interval_(interval) {}

  // Whether the state at `now` is to be written; each time is written once.
  bool due(double now, bool last) {
    if (now <= written_ + kSameTime) return false;
    const double k = std::round(now / interval_);
    if (!last && std::abs(now / interval_ - k) > kGridTolerance) return false;
    written_ = now;
    ++count_;
    return true;
  }

  std::int64_t count() const { return count_; }  // states written

  void transfer(Archive& archive) { archive(written_, count_); }

 private:
  double interval_;
  double written_ = -1.0;
  std::int64_t count_ = 0;
};

}  // namespace retiarius
