#pragma once

#include <string>

#include <catch2/catch_all.hpp>

// What the tests use of Catch2's version 2, in terms of version 3, which took its single header apart. On the
// include path only where there is no version 2.

using Catch::Approx;

namespace Catch {

inline Matchers::StringContainsMatcher Contains(const std::string& text) {
  return Matchers::ContainsSubstring(text);
}

using Matchers::EndsWith;
using Matchers::StartsWith;

}  // namespace Catch
