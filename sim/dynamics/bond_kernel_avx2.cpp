#define SMITHEREENS_KERNEL kernel_avx2
#include "sim/dynamics/bond_kernel_body.h"
#include "sim/dynamics/bond_kernel_float_body.h"
