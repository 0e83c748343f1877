#define RETIARIUS_KERNEL_SPACE avx2
#define RETIARIUS_KERNEL_WIDTH 4
#include "retiarius/solve/piece_kernels.inc"
