#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "modeling/scene/scene.h"
#include "ui/document/part_presets.h"
#include "ui/document/selection.h"

/// What the add menu offers, and how it comes into a scene: a usual size, standing on the floor beside what
/// is there.
namespace ui {

struct NewThing {
  enum class Kind { profile, turnedSolid, slab, patch, handle, spout, floor, box, sphere, cylinder };
  Kind kind = Kind::profile;
  std::optional<ProfilePreset> preset;  ///< of a profile

  bool operator==(const NewThing&) const = default;
};

/// All of them, in the order of menus: dishes, other parts, what stands in the way.
const std::vector<NewThing>& newThings();
QString nameOf(const NewThing& thing);
/// One sentence for a tooltip.
QString helpOf(const NewThing& thing);
/// Of resources/icons.
QString iconNameOf(const NewThing& thing);
bool isCollider(const NewThing& thing);

/// Adds it. Beside everything, or, a handle or spout where a body of revolution is `selected`, at its wall
/// and glued to it. A scene without a material gets a ceramic, one with nothing at all a floor too.
Item addThing(modeling::Scene& scene, const NewThing& thing, const std::vector<Item>& selected);

/// Adds a network that is read from a file, with constants for each of its types of bonds.
Item addNetwork(modeling::Scene& scene, const std::string& file, int bondTypes);

/// Adds a mesh that is read from a file: filled with cells, of a material as of other parts, or as an
/// obstacle. How its unit was taken is told when the scene is built.
Item addMesh(modeling::Scene& scene, const std::string& file, const std::vector<Item>& selected);
Item addMeshObstacle(modeling::Scene& scene, const std::string& file);

/// Where an outside profile is farthest from the axis at height z, cm; nothing where it does not reach that
/// height.
std::optional<double> outsideRadiusAt(const modeling::RevolutionShape& shape, double z);

}  // namespace ui
