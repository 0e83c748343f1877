// Numbers as integers of few bits, with a relative error that is the same for small and large ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace retiarius {

// A value v is written as an integer code: below steps * quantum in steps of `quantum`, above that
// with `steps` codes for each doubling. The error is at most quantum / 2 below, and v / (2 steps)
// above. Only operations that IEEE 754 rounds in one way are used, so that other programs that read
// codes compute the same numbers bit for bit, which prediction needs.
struct Minifloat {
  double quantum = 1.0;
  std::int32_t steps = 128;

  // Of any value; what is too large, or no number, has the largest code.
  std::int32_t code(double value) const {
    constexpr int kOctaves = 2200;  // more than there are between any two numbers
    constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
    double scaled = std::abs(value) / quantum;
    int octave = 0;
    while (scaled >= 2.0 * steps && octave < kOctaves) {
      scaled *= 0.5;
      ++octave;
    }
    const double exact = std::floor(scaled + 0.5) + static_cast<double>(octave) * steps;
    const auto size = static_cast<std::int32_t>(exact < kLargest ? exact : kLargest);
    return value < 0.0 ? -size : size;
  }

  double value(std::int32_t code) const {
    const std::int64_t size = code < 0 ? -std::int64_t{code} : code;
    const std::int64_t octave = size < steps ? 0 : size / steps - 1;
    const double scaled =
        std::ldexp(static_cast<double>(size - octave * steps), static_cast<int>(octave)) * quantum;
    return code < 0 ? -scaled : scaled;
  }
};

}  // namespace retiarius
