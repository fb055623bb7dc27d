#include "ui/document/part_boxes.h"

namespace ui {

using Box = Eigen::AlignedBox3d;

Box boxOf(const modeling::Scene& scene, std::span<const Item> items) {
  Box box;
  for (const Item& item : items) {
    if (item.index >= countOf(scene, item.kind)) continue;
    if (item.kind == ItemKind::part) box.extend(boxOf(scene.parts[item.index]));
    if (item.kind == ItemKind::collider) box.extend(boxOf(scene.environment.colliders[item.index]));
  }
  return box;
}

Box boxOf(const modeling::Scene& scene) {
  Box box;
  for (const modeling::Part& part : scene.parts) box.extend(boxOf(part));
  for (const modeling::SceneCollider& collider : scene.environment.colliders) box.extend(boxOf(collider));
  return box;
}

}  // namespace ui
