// A random order of many things, of which any place can be told without the others.
#pragma once

#include <cstdint>

namespace retiarius {

// Where a permutation of 0 ... count - 1 takes `index` (< count, count at most 2^62); another one
// for every seed and stream. A Feistel network over the least square of a power of two that is not
// smaller than count, walked until it falls inside (Black & Rogaway 2002).
std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t seed,
                       std::uint64_t stream);

}  // namespace retiarius
