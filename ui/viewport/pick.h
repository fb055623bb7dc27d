#pragma once

#include <optional>

#include "sim/base/types.h"
#include "ui/document/selection.h"

namespace ui {

/// What lies under the pointer.
struct Pick {
  enum class Kind { nothing, part, collider, node, bond, cell, fragment };
  Kind kind = Kind::nothing;
  std::uint32_t index = sim::kNone;       ///< of the part, collider, node, bond, cell; id of the fragment
  std::uint32_t node = sim::kNone;        ///< of the network, the nearest to the point on a body
  std::optional<Item> item;               ///< the part or collider of the scene it belongs to
  sim::Vec3 point = sim::Vec3::Zero();    ///< cm, on the surface
  sim::Vec3 normal = sim::Vec3::UnitZ();  ///< unit, outwards
};

}  // namespace ui
