#define RETIARIUS_KERNEL_SPACE avx512
#define RETIARIUS_KERNEL_WIDTH 8
#include "retiarius/solve/piece_kernels.inc"
