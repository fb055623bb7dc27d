#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/scene/scene.h"
#include "ui/document/selection.h"

/// What the outliner, the add menu and tools do to a scene: each keeps the scene whole, so that what referred
/// to a name still does, and nothing refers to what is gone. Used within Document::edit().
namespace ui {

/// `wanted`, or with a number after it ("cup 2") where something else has that name already.
std::string uniqueName(std::string_view wanted, const std::vector<std::string>& taken);
/// Of all of a kind that has names of its own: parts, colliders, materials.
std::vector<std::string> namesOf(const modeling::Scene& scene, ItemKind kind);
/// Whether items of the kind have names of their own; a gluing and a track are called after what they join or
/// drive.
bool hasName(ItemKind kind);

/// Renames a part, collider, material or the scene, and everything that refers to it. The name it gets
/// differs from others of the kind. An empty name leaves it as it is.
void rename(modeling::Scene& scene, const Item& item, std::string_view name);

/// Why these cannot be removed: a material in use, unless all that use it go too.
std::optional<sim::Problem> removalProblem(const modeling::Scene& scene, std::span<const Item> items);
/// Removes them with what cannot be without them: gluings of a part, tracks of a collider or material. Of
/// materials that are in use nothing is removed (removalProblem()).
void remove(modeling::Scene& scene, std::span<const Item> items);

/// Copies under names of their own, behind the last of their kind; a gluing between two copied parts is
/// copied too. Copied parts and colliders (but floors) stand `offset` beside the originals. Answers the
/// copies, in the order of `items`; tracks and gluings by themselves cannot be doubled.
std::vector<Item> duplicate(modeling::Scene& scene, std::span<const Item> items, const sim::Vec3& offset);

/// Moves one so that it comes to stand at `index` of its list. Nothing refers to places in lists but the
/// caller's own items.
void reorder(modeling::Scene& scene, const Item& item, std::size_t index);

bool isHidden(const modeling::Scene& scene, const Item& item);
void setHidden(modeling::Scene& scene, const Item& item, bool hidden);
bool isLocked(const modeling::Scene& scene, const Item& item);
void setLocked(modeling::Scene& scene, const Item& item, bool locked);
bool canHide(ItemKind kind);
bool canLock(ItemKind kind);

/// Names of parts made of it.
std::vector<std::string> usersOf(const modeling::Scene& scene, std::string_view material);

}  // namespace ui
