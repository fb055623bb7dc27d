#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace modeling {

/// How far shape keys are on, as FBX and Collada files state it. assimp (5.2 to 5.4) says 1 of a key of FBX
/// whatever it is, and of one of Collada that is 0.
class ShapeKeys {
 public:
  /// `bytes` is FBX, text or binary.
  static ShapeKeys ofFbx(std::string_view bytes);
  /// `text` is Collada.
  static ShapeKeys ofCollada(std::string_view text);

  /// A key as assimp has it.
  struct Key {
    std::string name;
    double weight = 1.0;
  };
  /// How far each key of a mesh is on, 1 being wholly. Nothing where the file does not say it clearly.
  std::optional<std::vector<double>> weightsOf(const std::vector<Key>& keys) const;

 private:
  std::optional<double> namedWeight(const std::vector<Key>& keys, const std::string& name) const;

  bool isFbx_ = false;
  std::map<std::string, std::vector<double>> named_;  ///< FBX: all keys of that name
  std::vector<std::vector<double>> lists_;            ///< Collada: of each mesh with keys, in their order
};

}  // namespace modeling
