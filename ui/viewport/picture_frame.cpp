#include "ui/viewport/picture_frame.h"

#include "ui/document/scene_edits.h"
#include "ui/document/selection.h"
#include "ui/viewport/collider_shape.h"
#include "ui/viewport/pick_resolver.h"

namespace ui {
namespace {

std::vector<sim::PartIndex> partsNamed(const DrawData& data, const std::string& name) {
  std::vector<sim::PartIndex> parts;
  if (!data.shown.network) return parts;
  const std::vector<std::string>& names = data.shown.network->partNames;
  for (std::size_t part = 0; part < names.size(); ++part) {
    if (names[part] == name) parts.push_back(static_cast<sim::PartIndex>(part));
  }
  return parts;
}

std::vector<std::size_t> collidersNamed(const DrawData& data, const std::string& name) {
  std::vector<std::size_t> colliders;
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (data.colliders[i].name == name) colliders.push_back(i);
  }
  return colliders;
}

template <class Index>
void append(std::vector<Index>& list, const std::vector<Index>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

void markLocked(MarkedThings& marked, const DrawData& data, const modeling::Scene& scene) {
  if (scene.view.locked.empty()) return;
  const auto locked = [&](ItemKind kind, const std::string& name) {
    const std::optional<Item> item = itemNamed(scene, kind, name);
    return item && isLocked(scene, *item);
  };
  if (data.shown.network) {
    const std::vector<std::string>& names = data.shown.network->partNames;
    for (std::size_t part = 0; part < names.size(); ++part) {
      if (locked(ItemKind::part, names[part]))
        marked.passedParts.push_back(static_cast<sim::PartIndex>(part));
    }
  }
  for (std::size_t i = 0; i < data.colliders.size(); ++i) {
    if (locked(ItemKind::collider, data.colliders[i].name)) marked.passedColliders.push_back(i);
  }
}

}  // namespace

MarkedThings markedThings(const DrawData& data, const modeling::Scene& scene, const Selection& selection) {
  MarkedThings marked;
  for (const Item& item : selection.items()) {
    if (item.kind == ItemKind::part && item.index < scene.parts.size())
      append(marked.outlinedParts, partsNamed(data, scene.parts[item.index].name));
    if (item.kind == ItemKind::collider && item.index < scene.environment.colliders.size())
      append(marked.outlinedColliders, collidersNamed(data, scene.environment.colliders[item.index].name));
  }
  markLocked(marked, data, scene);
  return marked;
}

Eigen::AlignedBox3d boxOfAll(const DrawData& data) {
  Eigen::AlignedBox3d box = data.box;
  for (const sim::Collider& collider : data.colliders) box.extend(boxOf(collider));
  if (box.isEmpty()) return box;
  // What is in the air is seen with the floor on which it will fall.
  const sim::Vec3 middle = box.center();
  for (const sim::Collider& collider : data.colliders) {
    if (!collider.isFloor()) continue;
    const sim::Vec3 normal = collider.rotation * sim::Vec3::UnitZ();
    box.extend(sim::Vec3(middle - normal.dot(middle - collider.position) * normal));
  }
  return box;
}

Eigen::AlignedBox3d boxOfOutlined(const DrawData& data, const MarkedThings& marked) {
  Eigen::AlignedBox3d box;
  for (const std::size_t collider : marked.outlinedColliders) {
    box.extend(boxOf(data.colliders[collider]));
    box.extend(data.colliders[collider].position);
  }
  if (marked.outlinedParts.empty() || !data.motion) return box;
  const sim::Network& network = *data.shown.network;
  std::vector<std::uint8_t> chosen(network.partNames.size(), 0);
  for (const sim::PartIndex part : marked.outlinedParts) chosen[part] = 1;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (network.nodeParts[node] >= chosen.size() || chosen[network.nodeParts[node]] == 0) continue;
    box.extend(Eigen::Map<const Eigen::Vector3f>(data.motion->positions[node].data()).cast<double>());
  }
  return box;
}

}  // namespace ui
