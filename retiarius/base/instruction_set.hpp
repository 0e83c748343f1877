// Which instruction set the hot kernels use: those of the laws and of the factorisation. Results
// differ between sets in the last digits (fused multiply-add, order of sums), so runs record the
// name.
#pragma once

#include <string_view>
#include <vector>

namespace retiarius {

enum class InstructionSet { portable, avx2, avx512 };

// The set in use; the best one of this processor at start.
InstructionSet instruction_set();

// Its name: "portable", "avx2" or "avx512".
std::string_view kernel_name();

// The sets that this build and this processor support, the slowest first.
std::vector<std::string_view> available_kernels();

// Chooses for the whole process; "auto" is the best available. Throws Error for an unknown name
// and for a set that this processor or build lacks. Not to be called during a step.
void set_kernels(std::string_view name);

}  // namespace retiarius
