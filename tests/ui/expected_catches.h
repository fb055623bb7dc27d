#pragma once

namespace tests {

/// How often tests let handlers throw on purpose: what the net caught beyond is a fault of the window.
inline int& expectedCatches() {
  static int count = 0;
  return count;
}

}  // namespace tests
