#define SMITHEREENS_KERNEL kernel_plain
#include "sim/kernel/bond_kernel_body.h"
