#define RETIARIUS_KERNEL_SPACE portable
#define RETIARIUS_KERNEL_WIDTH 2
#include "retiarius/motion/sweep_kernels.inc"
