#include "retiarius/forces/element_kernels.hpp"

#include "retiarius/base/instruction_set.hpp"

namespace retiarius::kernels {

namespace portable {
extern const ElementTable element_table;
}
namespace avx2 {
extern const ElementTable element_table;
}
namespace avx512 {
extern const ElementTable element_table;
}

const ElementTable& elements() {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return avx512::element_table;
  if (instruction_set() == InstructionSet::avx2) return avx2::element_table;
#endif
  return portable::element_table;
}

}  // namespace retiarius::kernels
