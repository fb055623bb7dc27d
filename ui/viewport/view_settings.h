#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ui {

/// What the colour of a surface and of nodes stands for.
enum class Colouring : std::uint8_t { material, fragments, quality };

/// How a node is shown that nothing holds any more.
/// As sim::LooseNodes, in the same order.
enum class IsolatedNodes : std::uint8_t { shards, tetrahedra, spheres, hidden };

/// What of the lattice is drawn, and how. All of it can be combined.
struct ViewSettings {
  bool surface = true;
  bool nodes = false;
  bool bonds = false;
  bool brokenBonds = false;  ///< where bonds are drawn: the broken ones too
  bool levelSurface = false;
  bool gluePairs = false;
  bool xray = false;         ///< the surface lets through what is behind it
  bool insideColour = true;  ///< faces of fracture in the material's inside colour
  Colouring colouring = Colouring::material;
  IsolatedNodes isolated = IsolatedNodes::shards;
  double explode = 0.0;  ///< fragments move away from the middle of their body by this share of the distance
  bool grid = true;
  bool shadows = true;
  bool occlusion = true;           ///< corners and undersides darker, as they see less of the sky
  bool invisibleColliders = true;  ///< as outlines
  bool statistics = false;         ///< what drawing costs
  std::vector<std::string> hiddenParts;
  std::vector<std::string> hiddenColliders;

  bool operator==(const ViewSettings&) const = default;
};

}  // namespace ui
