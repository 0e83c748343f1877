// Which instruction set the factorisation's dense kernels use. Results differ between sets in the
// last digits (fused multiply-add, order of sums), so runs record the name.
#pragma once

#include <string_view>
#include <vector>

namespace retiarius {

// The set in use: "portable", "avx2" or "avx512". The best one of this processor at start.
std::string_view kernel_name();

// The sets that this build and this processor support, the slowest first.
std::vector<std::string_view> available_kernels();

// Chooses for the whole process; "auto" is the best available. Throws Error for an unknown name
// and for a set that this processor or build lacks. Not to be called during a factorisation.
void set_kernels(std::string_view name);

}  // namespace retiarius
