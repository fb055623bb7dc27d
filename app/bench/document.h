#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/result.h"

namespace app {

struct DocumentOptions {
  std::filesystem::path docs = "docs";  ///< benchmarks.md is here, plots/ below
  bool reuse = false;  ///< writes anew from what results there are in docs/plots; measures nothing
  bool quick = false;  ///< where a benchmark can be: to try the whole
  std::vector<int> threads{1, 2};
};

/// `bench all`: runs every benchmark, leaves results and plots in docs/plots, and rewrites docs/benchmarks.md
/// between its markers, `<!-- begin NAME -->` and `<!-- end NAME -->`. What stands outside of markers is
/// written by hand; a benchmark without markers is not written down. One that fails leaves its section as it
/// was, and is named in the problem.
sim::Status benchAll(const DocumentOptions& options);

/// `text` with what stands between the markers of this name replaced.
std::string withSection(std::string text, const std::string& name, const std::string& section);

}  // namespace app
