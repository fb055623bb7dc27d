#pragma once

#include <string>
#include <vector>

#include "sim/base/result.h"

namespace app {

/// A value of the scene, by its path, and what it is to be in turn.
struct Variation {
  std::string path;
  std::vector<std::string> values;  ///< JSON, or a text that stands for itself
};

/// "PATH=A,B,C". Commas within brackets, braces or quotes part nothing. A Problem names the option.
sim::Result<Variation> parseVariation(const std::string& text);

/// More runs than this are a slip.
inline constexpr std::size_t kMostRuns = 1000;

/// Every combination, the last variation's values changing fastest.
class SweepGrid {
 public:
  /// A Problem when there are no runs or more than kMostRuns.
  static sim::Result<SweepGrid> create(const std::vector<std::string>& variations);

  std::size_t runs() const { return runs_; }
  const std::vector<Variation>& variations() const { return variations_; }
  /// The values of a run, one a variation.
  std::vector<std::string> valuesOf(std::size_t run) const;
  /// Pictures side by side on the sheet: one for each value of the last variation.
  std::size_t columns() const { return variations_.back().values.size(); }

 private:
  std::vector<Variation> variations_;
  std::size_t runs_ = 1;
};

}  // namespace app
