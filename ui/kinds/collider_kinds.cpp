#include "ui/kinds/collider_kinds.h"

#include <QCoreApplication>
#include <utility>

namespace ui {
namespace {

using modeling::ColliderForm;
using modeling::Vec3;

QString translated(const char* text) {
  return QCoreApplication::translate("collider kinds", text);
}

QString standsInTheWay() {
  return translated("Something rigid that stands in the way and never moves by itself");
}

// One record a kind of collider. One that is missing does not compile.

ColliderKind recordOf(const modeling::FloorShape&) {
  return {translated("Floor"), QStringLiteral("floor"), translated("An endless plane that nothing passes"),
          modeling::FloorShape{}};
}

ColliderKind recordOf(const modeling::BoxShape&) {
  return {translated("Box"), QStringLiteral("box"), standsInTheWay(),
          modeling::BoxShape{Vec3::Constant(4.0)}};
}

ColliderKind recordOf(const modeling::SphereShape&) {
  return {translated("Sphere"), QStringLiteral("sphere"), standsInTheWay(), modeling::SphereShape{4.0}};
}

ColliderKind recordOf(const modeling::CylinderShape&) {
  return {translated("Cylinder"), QStringLiteral("cylinder"), standsInTheWay(),
          modeling::CylinderShape{3.0, 4.0}};
}

ColliderKind recordOf(const modeling::MeshObstacle&) {
  return {translated("Mesh"), QStringLiteral("mesh-obstacle"), standsInTheWay(), std::nullopt};
}

template <std::size_t... kIndex>
std::vector<ColliderForm> oneOfEach(std::index_sequence<kIndex...>) {
  return {ColliderForm(std::in_place_index<kIndex>)...};
}

}  // namespace

ColliderKind kindOf(const ColliderForm& form) {
  return std::visit([](const auto& kind) { return recordOf(kind); }, form);
}

std::vector<NewThing> newColliders() {
  std::vector<NewThing> things;
  for (const ColliderForm& form : oneOfEach(std::make_index_sequence<std::variant_size_v<ColliderForm>>())) {
    const ColliderKind kind = kindOf(form);
    if (!kind.usual) continue;
    things.push_back({.name = std::string(modeling::kindName(form)),
                      .title = kind.title,
                      .help = kind.help,
                      .icon = kind.icon,
                      .form = *kind.usual,
                      .preset = std::nullopt});
  }
  return things;
}

}  // namespace ui
