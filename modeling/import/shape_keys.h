#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace modeling {

/// How far the shape keys of an FBX are on, as the file states it: assimp (5.2 to 5.4) says wholly of each,
/// whatever it is.
class ShapeKeys {
 public:
  /// `bytes` is FBX, text or binary.
  explicit ShapeKeys(std::string_view bytes);

  /// How far each key of a mesh is on, 1 being wholly. Nothing where the file does not say it clearly.
  std::optional<std::vector<double>> weightsOf(const std::vector<std::string>& names) const;

 private:
  std::optional<double> weightOf(const std::string& name, const std::vector<std::string>& names) const;

  std::map<std::string, std::vector<double>> weights_;  ///< of all keys of that name
};

}  // namespace modeling
