#define RETIARIUS_KERNEL_SPACE portable
#define RETIARIUS_KERNEL_WIDTH 2
#include "retiarius/solve/piece_kernels.inc"
