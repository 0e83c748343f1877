#define RETIARIUS_KERNEL_SPACE avx512
#define RETIARIUS_KERNEL_WIDTH 8
#include "retiarius/forces/element_kernels.inc"
