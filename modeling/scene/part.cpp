#include "modeling/scene/part.h"

namespace modeling {

std::string_view kindName(const PartShape& shape) {
  return std::visit([](const auto& kind) { return std::string_view(kind.kName); }, shape);
}

Eigen::AlignedBox3d boxOf(const PartShape& shape) {
  return std::visit([](const auto& kind) { return kind.box(); }, shape);
}

Eigen::AlignedBox3d boxOf(const Part& part) {
  const Eigen::AlignedBox3d box = boxOf(part.shape);
  if (box.isEmpty()) return box;
  const Eigen::Affine3d worldFromPart = part.worldFromPart.worldFromPart();
  Eigen::AlignedBox3d placed;
  for (int corner = 0; corner < 8; ++corner)
    placed.extend(worldFromPart * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  return placed;
}

std::optional<double> cellEdgeOf(const PartShape& shape) {
  return std::visit([](const auto& kind) { return kind.cellEdge(); }, shape);
}

}  // namespace modeling
