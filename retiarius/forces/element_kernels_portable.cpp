#define RETIARIUS_KERNEL_SPACE portable
#define RETIARIUS_KERNEL_WIDTH 2
#include "retiarius/forces/element_kernels.inc"
