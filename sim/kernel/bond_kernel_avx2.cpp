#define SMITHEREENS_KERNEL kernel_avx2
#include "sim/kernel/bond_kernel_body.h"
