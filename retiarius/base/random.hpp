// Counter-based random numbers: a pure function of seed, stream and counter, so that a value does
// not depend on what else was drawn, by whom, or in which order.
#pragma once

#include <cstdint>

namespace retiarius {

// 64 random bits: the finaliser of SplitMix64 (Steele, Lea & Flood 2014) over the mixed key.
inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  const auto mix = [](std::uint64_t z) {
    z += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  };
  return mix(mix(mix(seed) ^ stream) ^ counter);
}

// Uniform in [0, 1), with 53 bits.
inline double random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t counter) {
  return static_cast<double>(random_bits(seed, stream, counter) >> 11) * 0x1.0p-53;
}

}  // namespace retiarius
