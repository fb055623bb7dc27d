#pragma once

#include <string>
#include <vector>

namespace tests {

/// Names of the kernels that this processor has.
std::vector<std::string> kernelsHere();

/// All simulations made while this lives, here and in programs started from here, use that kernel.
class ChosenKernel {
 public:
  explicit ChosenKernel(const std::string& name);
  ~ChosenKernel();
  ChosenKernel(const ChosenKernel&) = delete;
  ChosenKernel& operator=(const ChosenKernel&) = delete;
};

}  // namespace tests
