#define SMITHEREENS_KERNEL kernel_avx512
#include "sim/kernel/bond_kernel_body.h"
