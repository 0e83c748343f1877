#define RETIARIUS_KERNEL_SPACE avx2
#define RETIARIUS_KERNEL_WIDTH 4
#define RETIARIUS_KERNEL_ROWS 2
#define RETIARIUS_KERNEL_COLUMNS 6
#include "retiarius/solve/front_kernels.inc"
