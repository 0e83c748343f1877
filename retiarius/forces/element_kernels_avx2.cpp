#define RETIARIUS_KERNEL_SPACE avx2
#define RETIARIUS_KERNEL_WIDTH 4
#include "retiarius/forces/element_kernels.inc"
