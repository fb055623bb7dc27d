#include "modeling/scene/read_obstacles.h"

#include "modeling/import/mesh_file.h"

namespace modeling {

sim::Status readObstacles(Scene& scene, const std::filesystem::path& folder,
                          std::vector<std::string>& remarks, const Attendance& attendance) {
  auto& colliders = scene.environment.colliders;
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    auto* obstacle = std::get_if<MeshObstacle>(&colliders[i].form);
    if (obstacle == nullptr || obstacle->isRead()) continue;
    const std::string place = "environment.colliders[" + std::to_string(i) + "].file";
    auto read = loadMesh(folder, obstacle->source(), attendance);
    if (!read) return sim::Problem{place, read.problem().what, read.problem().remedy};
    if (read->mesh.triangles().size() > kMostObstacleTriangles) {
      return sim::Problem{place,
                          obstacle->file + ": an obstacle may have " +
                              std::to_string(kMostObstacleTriangles) + " triangles, and this has " +
                              std::to_string(read->mesh.triangles().size()),
                          "use a mesh of fewer faces"};
    }
    remarks.push_back(read->remark + (read->mesh.closed() ? "; it is closed: a solid obstacle"
                                                          : "; it is open: a sheet as an obstacle"));
    obstacle->surface.mesh = std::make_shared<const sim::TriangleMesh>(std::move(read->mesh));
  }
  return sim::Done{};
}

sim::Status takeOverSurfaces(const Scene& from, Scene& scene) {
  auto& colliders = scene.environment.colliders;
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    auto* obstacle = std::get_if<MeshObstacle>(&colliders[i].form);
    if (obstacle == nullptr || obstacle->isRead()) continue;
    for (const SceneCollider& other : from.environment.colliders) {
      const auto* known = std::get_if<MeshObstacle>(&other.form);
      if (known != nullptr && known->source() == obstacle->source()) obstacle->surface = known->surface;
    }
    if (!obstacle->isRead()) {
      return sim::Problem{"environment.colliders[" + std::to_string(i) + "]",
                          "an obstacle of another mesh cannot come into a run that goes on",
                          "run the changed scene from the start"};
    }
  }
  return sim::Done{};
}

}  // namespace modeling
