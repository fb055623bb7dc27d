#include <set>

#include "modeling/preflight/overlaps.h"

namespace modeling {
namespace {

/// The part and all that hangs on it by glue.
std::set<std::string> gluedTo(const Scene& scene, const std::string& part) {
  std::set<std::string> together{part};
  for (bool grew = true; grew;) {
    grew = false;
    for (const Gluing& glue : scene.glue) {
      if (together.contains(glue.a)) grew |= together.insert(glue.b).second;
      if (together.contains(glue.b)) grew |= together.insert(glue.a).second;
    }
  }
  return together;
}

}  // namespace

std::size_t applyMends(const std::vector<Overlap>& overlaps, Scene& scene) {
  std::set<std::string> moved;
  std::size_t mended = 0;
  for (const Overlap& overlap : overlaps) {
    if (!overlap.mend || moved.contains(overlap.mend->part)) continue;
    const std::set<std::string> together = gluedTo(scene, overlap.mend->part);
    for (Part& part : scene.parts) {
      if (together.contains(part.name)) part.worldFromPart.position += overlap.mend->move;
    }
    moved.insert(together.begin(), together.end());
    ++mended;
  }
  return mended;
}

}  // namespace modeling
