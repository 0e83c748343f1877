#include "retiarius/base/instruction_set.hpp"
#include "retiarius/solve/kernel_table.hpp"

namespace retiarius::kernels {

namespace portable {
extern const KernelTable table;
}
namespace avx2 {
extern const KernelTable table;
}
namespace avx512 {
extern const KernelTable table;
}

const KernelTable& active() {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return avx512::table;
  if (instruction_set() == InstructionSet::avx2) return avx2::table;
#endif
  return portable::table;
}

}  // namespace retiarius::kernels
