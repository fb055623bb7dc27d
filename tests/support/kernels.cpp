#include "tests/support/kernels.h"

#include <cstdlib>

#include "sim/kernel/bond_kernel.h"

namespace tests {

std::vector<std::string> kernelsHere() {
  std::vector<std::string> names;
  for (const auto kind : {sim::KernelKind::plain, sim::KernelKind::avx2, sim::KernelKind::avx512}) {
    if (sim::stepBlocksFor(kind) != nullptr) names.emplace_back(sim::nameOfKernel(kind));
  }
  return names;
}

ChosenKernel::ChosenKernel(const std::string& name) {
  setenv("SMITHEREENS_KERNEL", name.c_str(), 1);
}

ChosenKernel::~ChosenKernel() {
  unsetenv("SMITHEREENS_KERNEL");
}

}  // namespace tests
