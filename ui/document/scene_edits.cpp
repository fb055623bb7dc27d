#include "ui/document/scene_edits.h"

#include <algorithm>
#include <set>

namespace ui {
namespace {

using modeling::Scene;
using Names = std::vector<std::string>;

template <class List>
Names namesIn(const List& list) {
  Names names;
  for (const auto& item : list) names.push_back(item.name);
  return names;
}

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void replaceName(Names& names, const std::string& before, const std::string& after) {
  std::replace(names.begin(), names.end(), before, after);
}

void setContained(Names& names, const std::string& name, bool contained) {
  std::erase(names, name);
  if (contained) names.push_back(name);
}

/// Tracks of materials or of colliders that name this one.
bool drives(const modeling::SceneTrack& track, ItemKind kind, const std::string& name) {
  return track.target.object == name &&
         sim::drivesCollider(track.target.target) == (kind == ItemKind::collider);
}

std::string* nameIn(Scene& scene, const Item& item) {
  if (item.index >= countOf(scene, item.kind)) return nullptr;
  switch (item.kind) {
    case ItemKind::scene:
      return &scene.name;
    case ItemKind::part:
      return &scene.parts[item.index].name;
    case ItemKind::collider:
      return &scene.environment.colliders[item.index].name;
    case ItemKind::material:
      return &scene.materials[item.index].name;
    case ItemKind::gluing:
    case ItemKind::track:
      return nullptr;
  }
  return nullptr;
}

/// Hidden and locked name parts and colliders alike: a name stays there while either has it.
void forgetInView(Scene& scene, const std::string& name) {
  if (contains(namesIn(scene.parts), name) || contains(namesIn(scene.environment.colliders), name)) return;
  std::erase(scene.view.hidden, name);
  std::erase(scene.view.locked, name);
}

void followPart(Scene& scene, const std::string& before, const std::string& after) {
  for (modeling::Gluing& gluing : scene.glue) {
    if (gluing.a == before) gluing.a = after;
    if (gluing.b == before) gluing.b = after;
  }
  replaceName(scene.view.hidden, before, after);
  replaceName(scene.view.locked, before, after);
}

void followMaterial(Scene& scene, const std::string& before, const std::string& after) {
  for (modeling::Part& part : scene.parts) {
    if (part.material == before) part.material = after;
  }
}

void followTracks(Scene& scene, ItemKind kind, const std::string& before, const std::string& after) {
  for (modeling::SceneTrack& track : scene.tracks) {
    if (drives(track, kind, before)) track.target.object = after;
  }
}

std::set<std::size_t> indicesOf(std::span<const Item> items, ItemKind kind) {
  std::set<std::size_t> indices;
  for (const Item& item : items) {
    if (item.kind == kind) indices.insert(item.index);
  }
  return indices;
}

template <class List>
void eraseAt(List& list, const std::set<std::size_t>& indices) {
  for (auto index = indices.rbegin(); index != indices.rend(); ++index) {
    if (*index < list.size()) list.erase(list.begin() + static_cast<std::ptrdiff_t>(*index));
  }
}

template <class List>
Names namesAt(const List& list, const std::set<std::size_t>& indices) {
  Names names;
  for (const std::size_t index : indices) {
    if (index < list.size()) names.push_back(list[index].name);
  }
  return names;
}

template <class List>
void move(List& list, std::size_t from, std::size_t to) {
  if (from >= list.size() || to >= list.size()) return;
  const auto begin = list.begin();
  const auto source = begin + static_cast<std::ptrdiff_t>(from);
  const auto target = begin + static_cast<std::ptrdiff_t>(to);
  if (from < to) {
    std::rotate(source, source + 1, target + 1);
  } else {
    std::rotate(target, source, source + 1);
  }
}

/// "cup 2" is a further "cup".
std::string_view withoutNumber(std::string_view name) {
  const std::size_t digits = name.find_last_not_of("0123456789");
  if (digits == std::string_view::npos || digits + 1 == name.size() || name[digits] != ' ') return name;
  return digits == 0 ? name : name.substr(0, digits);
}

}  // namespace

std::string uniqueName(std::string_view wanted, const Names& taken) {
  if (!contains(taken, wanted)) return std::string(wanted);
  const std::string_view stem = withoutNumber(wanted);
  for (int number = 2;; ++number) {
    std::string name = std::string(stem) + " " + std::to_string(number);
    if (!contains(taken, name)) return name;
  }
}

Names namesOf(const Scene& scene, ItemKind kind) {
  if (kind == ItemKind::part) return namesIn(scene.parts);
  if (kind == ItemKind::collider) return namesIn(scene.environment.colliders);
  if (kind == ItemKind::material) return namesIn(scene.materials);
  return {};
}

bool hasName(ItemKind kind) {
  return kind != ItemKind::gluing && kind != ItemKind::track;
}

void rename(Scene& scene, const Item& item, std::string_view name) {
  std::string* present = nameIn(scene, item);
  if (!present || (name.empty() && item.kind != ItemKind::scene) || *present == name) return;
  const std::string before = *present;
  Names others = namesOf(scene, item.kind);
  if (item.index < others.size()) others.erase(others.begin() + static_cast<std::ptrdiff_t>(item.index));
  const std::string after = uniqueName(name, others);
  *present = after;
  if (item.kind == ItemKind::part) followPart(scene, before, after);
  if (item.kind == ItemKind::material) {
    scene.materials[item.index].values.name = after;
    followMaterial(scene, before, after);
    followTracks(scene, item.kind, before, after);
  }
  if (item.kind == ItemKind::collider) {
    followTracks(scene, item.kind, before, after);
    replaceName(scene.view.locked, before, after);
  }
}

std::optional<sim::Problem> removalProblem(const Scene& scene, std::span<const Item> items) {
  const std::set<std::size_t> parts = indicesOf(items, ItemKind::part);
  const Names materials = namesAt(scene.materials, indicesOf(items, ItemKind::material));
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const modeling::Part& part = scene.parts[i];
    if (parts.contains(i) || !contains(materials, part.material)) continue;
    return sim::Problem{"parts[" + std::to_string(i) + "].material",
                        "the part \"" + part.name + "\" is made of \"" + part.material + "\"",
                        "give the part another material first"};
  }
  return std::nullopt;
}

void remove(Scene& scene, std::span<const Item> items) {
  if (removalProblem(scene, items)) return;
  const Names parts = namesAt(scene.parts, indicesOf(items, ItemKind::part));
  const Names materials = namesAt(scene.materials, indicesOf(items, ItemKind::material));
  const Names colliders = namesAt(scene.environment.colliders, indicesOf(items, ItemKind::collider));
  eraseAt(scene.glue, indicesOf(items, ItemKind::gluing));
  eraseAt(scene.tracks, indicesOf(items, ItemKind::track));
  eraseAt(scene.parts, indicesOf(items, ItemKind::part));
  eraseAt(scene.materials, indicesOf(items, ItemKind::material));
  eraseAt(scene.environment.colliders, indicesOf(items, ItemKind::collider));
  std::erase_if(scene.glue, [&](const modeling::Gluing& gluing) {
    return contains(parts, gluing.a) || contains(parts, gluing.b);
  });
  std::erase_if(scene.tracks, [&](const modeling::SceneTrack& track) {
    return contains(sim::drivesCollider(track.target.target) ? colliders : materials, track.target.object);
  });
  for (const Names* gone : {&parts, &colliders}) {
    for (const std::string& name : *gone) forgetInView(scene, name);
  }
}

namespace {

Item duplicatePart(Scene& scene, std::size_t index, const sim::Vec3& offset) {
  modeling::Part copy = scene.parts[index];
  copy.name = uniqueName(copy.name, namesOf(scene, ItemKind::part));
  copy.worldFromPart.position += offset;
  scene.parts.push_back(std::move(copy));
  return {ItemKind::part, scene.parts.size() - 1};
}

Item duplicateCollider(Scene& scene, std::size_t index, const sim::Vec3& offset) {
  auto& colliders = scene.environment.colliders;
  modeling::SceneCollider copy = colliders[index];
  copy.name = uniqueName(copy.name, namesOf(scene, ItemKind::collider));
  if (!copy.isFloor()) copy.position += offset;
  colliders.push_back(std::move(copy));
  return {ItemKind::collider, colliders.size() - 1};
}

Item duplicateMaterial(Scene& scene, std::size_t index) {
  modeling::SceneMaterial copy = scene.materials[index];
  copy.name = uniqueName(copy.name, namesOf(scene, ItemKind::material));
  copy.values.name = copy.name;
  scene.materials.push_back(std::move(copy));
  return {ItemKind::material, scene.materials.size() - 1};
}

/// Copies of parts that were glued to each other are glued alike.
void duplicateGlue(Scene& scene, const std::vector<std::pair<std::string, std::string>>& copies) {
  const auto copyOf = [&](const std::string& name) {
    const auto found =
        std::find_if(copies.begin(), copies.end(), [&](const auto& row) { return row.first == name; });
    return found == copies.end() ? std::string() : found->second;
  };
  const std::size_t before = scene.glue.size();
  for (std::size_t i = 0; i < before; ++i) {
    modeling::Gluing gluing = scene.glue[i];
    gluing.a = copyOf(gluing.a);
    gluing.b = copyOf(gluing.b);
    if (!gluing.a.empty() && !gluing.b.empty()) scene.glue.push_back(std::move(gluing));
  }
}

}  // namespace

std::vector<Item> duplicate(Scene& scene, std::span<const Item> items, const sim::Vec3& offset) {
  std::vector<Item> copies;
  std::vector<std::pair<std::string, std::string>> parts;
  for (const Item& item : items) {
    if (item.index >= countOf(scene, item.kind)) continue;
    if (item.kind == ItemKind::part) {
      copies.push_back(duplicatePart(scene, item.index, offset));
      parts.emplace_back(scene.parts[item.index].name, scene.parts.back().name);
    }
    if (item.kind == ItemKind::collider) copies.push_back(duplicateCollider(scene, item.index, offset));
    if (item.kind == ItemKind::material) copies.push_back(duplicateMaterial(scene, item.index));
  }
  duplicateGlue(scene, parts);
  return copies;
}

void reorder(Scene& scene, const Item& item, std::size_t index) {
  switch (item.kind) {
    case ItemKind::scene:
      return;
    case ItemKind::part:
      return move(scene.parts, item.index, index);
    case ItemKind::gluing:
      return move(scene.glue, item.index, index);
    case ItemKind::collider:
      return move(scene.environment.colliders, item.index, index);
    case ItemKind::material:
      return move(scene.materials, item.index, index);
    case ItemKind::track:
      return move(scene.tracks, item.index, index);
  }
}

bool canHide(ItemKind kind) {
  return kind == ItemKind::part || kind == ItemKind::collider;
}

bool canLock(ItemKind kind) {
  return canHide(kind);
}

bool isHidden(const Scene& scene, const Item& item) {
  if (!canHide(item.kind) || item.index >= countOf(scene, item.kind)) return false;
  if (item.kind == ItemKind::collider) return !scene.environment.colliders[item.index].visible;
  return contains(scene.view.hidden, scene.parts[item.index].name);
}

void setHidden(Scene& scene, const Item& item, bool hidden) {
  if (isHidden(scene, item) == hidden || !canHide(item.kind)) return;
  if (item.kind == ItemKind::collider) {
    scene.environment.colliders[item.index].visible = !hidden;
  } else {
    setContained(scene.view.hidden, scene.parts[item.index].name, hidden);
  }
}

bool isLocked(const Scene& scene, const Item& item) {
  if (!canLock(item.kind) || item.index >= countOf(scene, item.kind)) return false;
  return contains(scene.view.locked, nameOf(scene, item).toStdString());
}

void setLocked(Scene& scene, const Item& item, bool locked) {
  if (isLocked(scene, item) == locked || !canLock(item.kind)) return;
  setContained(scene.view.locked, nameOf(scene, item).toStdString(), locked);
}

Names usersOf(const Scene& scene, std::string_view material) {
  Names users;
  for (const modeling::Part& part : scene.parts) {
    if (part.material == material) users.push_back(part.name);
  }
  return users;
}

}  // namespace ui
