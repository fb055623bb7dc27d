#include "app/cli/sweep_grid.h"

#include <utility>

namespace app {

namespace {

std::vector<std::string> parted(const std::string& list) {
  std::vector<std::string> values{""};
  int depth = 0;
  bool quoted = false;
  for (const char letter : list) {
    if (letter == '"') quoted = !quoted;
    if (!quoted && (letter == '[' || letter == '{')) ++depth;
    if (!quoted && (letter == ']' || letter == '}')) --depth;
    if (letter == ',' && depth == 0 && !quoted) {
      values.emplace_back();
    } else {
      values.back() += letter;
    }
  }
  return values;
}

}  // namespace

sim::Result<Variation> parseVariation(const std::string& text) {
  const std::size_t equals = text.find('=');
  Variation variation;
  if (equals != std::string::npos) {
    variation.path = text.substr(0, equals);
    variation.values = parted(text.substr(equals + 1));
  }
  bool whole = !variation.path.empty();
  for (const std::string& value : variation.values) whole = whole && !value.empty();
  if (!whole) {
    return sim::Problem{"--vary", "\"" + text + "\" varies nothing",
                        "write it as PATH=A,B,C, such as materials.porcelain.density=2,2.5,3"};
  }
  return variation;
}

sim::Result<SweepGrid> SweepGrid::create(const std::vector<std::string>& variations) {
  SweepGrid grid;
  for (const std::string& text : variations) {
    auto variation = parseVariation(text);
    if (!variation) return variation.problem();
    grid.runs_ *= variation->values.size();
    if (grid.runs_ > kMostRuns) {
      return sim::Problem{"--vary", "these are more than " + std::to_string(kMostRuns) + " runs",
                          "vary less at a time"};
    }
    grid.variations_.push_back(std::move(*variation));
  }
  if (grid.variations_.empty()) return sim::Problem{"--vary", "nothing is varied", "add --vary PATH=A,B,C"};
  return grid;
}

std::vector<std::string> SweepGrid::valuesOf(std::size_t run) const {
  std::vector<std::string> values(variations_.size());
  for (std::size_t v = variations_.size(); v-- > 0;) {
    const auto& choices = variations_[v].values;
    values[v] = choices[run % choices.size()];
    run /= choices.size();
  }
  return values;
}

}  // namespace app
