#include "sim/kernel/bond_kernel.h"

#include <cstdlib>
#include <string_view>

namespace sim {
namespace {

#ifdef SMITHEREENS_X86_KERNELS
bool hasAvx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
bool hasAvx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
}
#endif

}  // namespace

KernelKind fastestKernel() {
  // So that whole programs can be compared by kernel.
  if (const char* const asked = std::getenv("SMITHEREENS_KERNEL")) {
    for (const KernelKind kind : {KernelKind::plain, KernelKind::avx2, KernelKind::avx512}) {
      if (std::string_view(asked) == nameOfKernel(kind) && stepBlocksFor(kind) != nullptr) return kind;
    }
  }
#ifdef SMITHEREENS_X86_KERNELS
  if (hasAvx512()) return KernelKind::avx512;
  if (hasAvx2()) return KernelKind::avx2;
#endif
  return KernelKind::plain;
}

StepBlocks stepBlocksFor(KernelKind kind) {
  switch (kind) {
    case KernelKind::automatic:
      return stepBlocksFor(fastestKernel());
    case KernelKind::plain:
      return kernel_plain::stepBlocks;
#ifdef SMITHEREENS_X86_KERNELS
    case KernelKind::avx2:
      return hasAvx2() ? kernel_avx2::stepBlocks : nullptr;
    case KernelKind::avx512:
      return hasAvx512() ? kernel_avx512::stepBlocks : nullptr;
#else
    case KernelKind::avx2:
    case KernelKind::avx512:
      return nullptr;
#endif
  }
  return nullptr;
}

const char* nameOfKernel(KernelKind kind) {
  switch (kind) {
    case KernelKind::automatic:
      return nameOfKernel(fastestKernel());
    case KernelKind::plain:
      return "plain";
    case KernelKind::avx2:
      return "avx2";
    case KernelKind::avx512:
      return "avx512";
  }
  return "plain";
}

}  // namespace sim
