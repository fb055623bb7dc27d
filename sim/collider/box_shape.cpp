#include "sim/collider/box_shape.h"

namespace sim {

Intrusion BoxShape::intrusion(const Vec3& local, std::uint32_t) const {
  const Vec3 depths = halfSize - local.cwiseAbs();
  Eigen::Index axis = 0;
  const double depth = depths.minCoeff(&axis);
  Vec3 normal = Vec3::Zero();
  normal[axis] = local[axis] < 0.0 ? -1.0 : 1.0;
  return {depth, normal};
}

ColliderSurface BoxShape::surface() const {
  ColliderSurface surface;
  for (int axis = 0; axis < 3; ++axis) {
    const int second = (axis + 1) % 3;
    const int third = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      const auto corner = [&](double a, double b) {
        Vec3 point = halfSize;
        point[axis] *= side;
        point[second] *= side * a;
        point[third] *= b;
        return point;
      };
      Vec3 normal = Vec3::Zero();
      normal[axis] = side;
      surface.addFlat({corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)}, normal);
    }
  }
  return surface;
}

ColliderOutline BoxShape::outline() const {
  ColliderOutline outline;
  addBoxEdges(halfSize, outline);
  return outline;
}

}  // namespace sim
