#include "retiarius/measure/closure.hpp"

#include <algorithm>

namespace retiarius {

namespace {
constexpr double kHeld = 0.5;       // s
constexpr double kRounding = 1e-9;  // s, of times that are products
}  // namespace

void Closure::set_prescribed(double time, bool prescribed) {
  now_ = time;
  if (prescribed) {
    free_since_.reset();
  } else if (!free_since_) {
    free_since_ = time;
  }
}

void Closure::see(double time, const Readings& r) {
  now_ = time;
  const bool small = r.mouth_area < 0.05 * area_ && r.mouth_vector_area < 0.05 * area_ &&
                     r.mouth_width < 0.1 * width_;
  if (!small) {
    small_since_.reset();
  } else if (!small_since_) {
    small_since_ = time;
  }
}

bool Closure::closed() const {
  if (!small_since_ || !free_since_) return false;
  return now_ - std::max(*small_since_, *free_since_) >= kHeld - kRounding;
}

}  // namespace retiarius
