#include "retiarius/motion/sweep_kernels.hpp"

#include "retiarius/base/instruction_set.hpp"

namespace retiarius::kernels {

namespace portable {
extern const SweepTable sweep_table;
}
namespace avx2 {
extern const SweepTable sweep_table;
}
namespace avx512 {
extern const SweepTable sweep_table;
}

const SweepTable& sweeps() {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return avx512::sweep_table;
  if (instruction_set() == InstructionSet::avx2) return avx2::sweep_table;
#endif
  return portable::sweep_table;
}

}  // namespace retiarius::kernels
