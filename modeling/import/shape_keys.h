#pragma once

#include <optional>
#include <string_view>

/// How far shape keys are on, as FBX and Collada files state it. assimp (5.2 to 5.4) says 1 of a key of FBX
/// whatever it is, and of one of Collada that is 0.
namespace modeling {

/// What there is of shape keys in a file.
struct ShapeKeys {
  bool someAreOn = false;
  bool someAreOff = false;
};

/// `bytes` is FBX, text or binary.
ShapeKeys shapeKeysOfFbx(std::string_view bytes);
/// `text` is Collada.
ShapeKeys shapeKeysOfCollada(std::string_view text);

}  // namespace modeling
