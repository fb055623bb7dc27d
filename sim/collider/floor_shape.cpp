#include "sim/collider/floor_shape.h"

namespace sim {

ColliderOutline FloorShape::outline() const {
  ColliderOutline outline;
  addBoxEdges({20.0, 20.0, 0.0}, outline);
  return outline;
}

}  // namespace sim
