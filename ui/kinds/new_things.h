#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "modeling/scene/scene.h"
#include "ui/document/selection.h"
#include "ui/kinds/new_thing.h"

/// What the add menu offers, and how it comes into a scene: standing on the floor beside what is there.
namespace ui {

/// All of them, in the order of menus: dishes, other parts, what stands in the way.
const std::vector<NewThing>& newThings();
/// The one of this name, which there must be.
const NewThing& newThing(std::string_view name);

/// Adds it. Beside everything, or, a handle or spout where a body of revolution is `selected`, at its wall
/// and glued to it. A scene without a material gets a ceramic, one with nothing at all a floor too.
Item addThing(modeling::Scene& scene, const NewThing& thing, const std::vector<Item>& selected);

/// Adds a network that is read from a file, with constants for each of its types of bonds.
Item addNetwork(modeling::Scene& scene, const std::string& file, int bondTypes);

/// Adds a mesh that is read from a file: filled with cells, of a material as of other parts, or as an
/// obstacle. How its unit was taken is told when the scene is built.
Item addMesh(modeling::Scene& scene, const std::string& file, const std::vector<Item>& selected);
Item addMeshObstacle(modeling::Scene& scene, const std::string& file);

}  // namespace ui
