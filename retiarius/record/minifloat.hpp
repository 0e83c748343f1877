// Numbers as integers of few bits, with a relative error that is the same for small and large ones.
#pragma once

#include <cmath>
#include <cstdint>

namespace retiarius {

// A value v is written as an integer code: below steps * quantum in steps of `quantum`, above that
// with `steps` codes for each doubling. The error is at most quantum / 2 below, and v / (2 steps)
// above. Only operations that IEEE 754 rounds in one way are used, so that other programs that read
// codes compute the same numbers bit for bit, which prediction needs.
struct Minifloat {
  double quantum = 1.0;
  std::int32_t steps = 128;

  // Of a finite value.
  std::int32_t code(double value) const {
    double scaled = std::abs(value) / quantum;
    std::int32_t octave = 0;
    while (scaled >= 2.0 * steps) {
      scaled *= 0.5;
      ++octave;
    }
    const auto size = static_cast<std::int32_t>(std::floor(scaled + 0.5)) + octave * steps;
    return value < 0.0 ? -size : size;
  }

  double value(std::int32_t code) const {
    const std::int32_t size = code < 0 ? -code : code;
    const std::int32_t octave = size < steps ? 0 : size / steps - 1;
    const double scaled = std::ldexp(static_cast<double>(size - octave * steps), octave) * quantum;
    return code < 0 ? -scaled : scaled;
  }
};

}  // namespace retiarius
