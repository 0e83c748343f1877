#define RETIARIUS_KERNEL_SPACE avx512
#define RETIARIUS_KERNEL_WIDTH 8
#define RETIARIUS_KERNEL_ROWS 4
#define RETIARIUS_KERNEL_COLUMNS 6
#include "retiarius/solve/front_kernels.inc"
