#define RETIARIUS_KERNEL_SPACE portable
#define RETIARIUS_KERNEL_WIDTH 2
#define RETIARIUS_KERNEL_ROWS 3
#define RETIARIUS_KERNEL_COLUMNS 3
#include "retiarius/solve/front_kernels.inc"
