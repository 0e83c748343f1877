#include "retiarius/solve/piece_kernels.hpp"

#include "retiarius/base/instruction_set.hpp"

namespace retiarius::kernels {

namespace portable {
extern const PieceTable piece_table;
}
namespace avx2 {
extern const PieceTable piece_table;
}
namespace avx512 {
extern const PieceTable piece_table;
}

const PieceTable& pieces() {
#ifdef __x86_64__
  if (instruction_set() == InstructionSet::avx512) return avx512::piece_table;
  if (instruction_set() == InstructionSet::avx2) return avx2::piece_table;
#endif
  return portable::piece_table;
}

}  // namespace retiarius::kernels
