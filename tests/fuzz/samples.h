#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/damage.h"

namespace tests {

/// A sound input, all of our own making.
struct Sample {
  std::string_view kind;  ///< how it is tried: see trials.h
  std::string_view file;  ///< its name; what it needs beside it is in its folder
  Nature nature = Nature::text;
};

/// All there are. Those of one kind stand together.
const std::vector<Sample>& samples();

/// Writes all of them, each into the folder of its kind, with what they need beside them. False, and why on
/// standard error, where one cannot be made. Runs simulations in parallel: processes that are forked
/// afterwards must not.
bool writeSamples(const std::filesystem::path& folder);

}  // namespace tests
