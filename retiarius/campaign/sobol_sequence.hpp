// A scrambled Sobol' sequence: points that fill the unit cube more evenly than random ones.
#pragma once

#include <array>
#include <cstdint>

namespace retiarius {

// Sobol' (1967). The first coordinate is van der Corput's; each further one has its own primitive
// polynomial over GF(2), in ascending order, and its own initial direction numbers
// (sobol_numbers.hpp). Scrambled as Owen (1995) does: every binary digit is flipped or not by a
// random bit that depends on the digits before it, so that each point is uniform in the cube and
// every elementary interval keeps its share of the points.
class SobolSequence {
 public:
  static constexpr int kDimensions = 64;
  static constexpr int kDigits = 32;  // points repeat after 2^32

  SobolSequence();

  // The digits of a coordinate of a point before scrambling, as a fraction of 2^32.
  std::uint32_t digits(std::uint64_t index, int dimension) const;

  // The scrambled coordinate, in [0, 1). Digits below the 32nd are random.
  double scrambled(std::uint64_t index, int dimension, std::uint64_t seed) const;

 private:
  std::array<std::array<std::uint32_t, kDigits>, kDimensions> directions_{};
};

// Coefficients of a primitive polynomial over GF(2), of x^k in bit k.
bool is_primitive(std::uint32_t polynomial);

}  // namespace retiarius
