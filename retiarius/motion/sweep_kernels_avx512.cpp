#define RETIARIUS_KERNEL_SPACE avx512
#define RETIARIUS_KERNEL_WIDTH 8
#include "retiarius/motion/sweep_kernels.inc"
