#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "modeling/exchange/export.h"
#include "modeling/exchange/fragment_motion.h"
#include "modeling/exchange/fragment_shapes.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/gltf_animation.h"
#include "modeling/exchange/gltf_axes.h"
#include "modeling/exchange/gltf_file.h"
#include "modeling/exchange/gltf_material.h"
#include "modeling/exchange/shape_chunks.h"
#include "modeling/exchange/take_scene.h"
#include "modeling/text/text_output.h"

namespace modeling {

namespace {

using Json = nlohmann::ordered_json;

Json numberOrNull(double number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

FitResidual residualOf(const std::vector<FragmentMotion>& motions) {
  FitResidual all;
  for (const FragmentMotion& motion : motions) all.add(motion.residual);
  return all;
}

class GlbWriter {
 public:
  /// `motions`: of what is seen. `times`: of the frames, s.
  GlbWriter(const sim::TakeReader& take, const Scene& scene, const FragmentShapes& shapes,
            const std::vector<FragmentMotion>& motions, const std::vector<double>& times)
      : take_(take),
        scene_(scene),
        looks_(looksOf(scene, take.network())),
        shapes_(shapes),
        motions_(motions),
        times_(times),
        animation_(file_, times) {}

  GltfFile run() {
    const std::string name = oneWord(scene_.name, "take");
    const std::size_t root = file_.append("nodes", {{"name", name}, {"extras", wholeExtras()}});
    Json children = Json::array();
    for (const FragmentMotion& motion : motions_) children.push_back(addFragment(motion));
    if (!children.empty()) file_.json()["nodes"][root]["children"] = std::move(children);
    file_.append("scenes", {{"name", name}, {"nodes", Json::array({root})}, {"extras", wholeExtras()}});
    file_.json()["scene"] = 0;
    animation_.finish();
    if (!extensions_.empty()) file_.json()["extensionsUsed"] = extensions_;
    return std::move(file_);
  }

 private:
  Json wholeExtras() const {
    const FitResidual all = residualOf(motions_);
    return {{"frames_per_second", take_.header().framesPerSecond},
            {"frames", times_.size()},
            {"key_tolerance_cm", kKeyTolerance},
            {"fit_residual_rms_cm", all.rootMeanSquare()},
            {"fit_residual_max_cm", all.largest}};
  }

  Json fragmentExtras(const FragmentMotion& motion) const {
    const sim::Network& network = take_.network();
    const sim::FragmentId parent = motion.fragment.parent;
    const auto part = network.nodeParts[motion.node];
    Json extras = {{"id", motion.fragment.id},
                   {"parent", parent == sim::kNone ? Json(nullptr) : Json(parent)},
                   {"birth_time_s", motion.fragment.born},
                   {"mass_g", numberOrNull(motion.fragment.mass)},
                   {"frames_per_second", take_.header().framesPerSecond},
                   {"fit_residual_rms_cm", motion.residual.rootMeanSquare()},
                   {"fit_residual_max_cm", motion.residual.largest}};
    if (part < network.partNames.size()) extras["part"] = network.partNames[part];
    return extras;
  }

  std::size_t materialOf(const MaterialSide& side) {
    const auto found = materials_.find(side);
    if (found != materials_.end()) return found->second;
    const std::string name = oneWord(take_.network().materials[side.first].name, "material");
    Json material = gltfMaterial(name + (side.second ? "_inside" : "_outside"), looks_[side.first],
                                 side.second, shapes_.thicknessOf(side.first));
    for (const std::string& extension : gltfMaterialExtensions(material)) extensions_.insert(extension);
    return materials_[side] = file_.append("materials", std::move(material));
  }

  /// Triangles with the vertices that they use.
  Json primitive(const std::vector<ShapeVertex>& vertices, const MaterialSide& side,
                 const std::vector<std::uint32_t>& triangles) {
    std::unordered_map<std::uint32_t, std::uint32_t> known;
    std::vector<float> positions, normals, coordinates, damage;
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t number : triangles) {
      const auto [found, isNew] = known.try_emplace(number, static_cast<std::uint32_t>(known.size()));
      corners.push_back(found->second);
      if (!isNew) continue;
      const ShapeVertex& vertex = vertices[number];
      positions.insert(positions.end(), vertex.begin(), vertex.begin() + 3);
      normals.insert(normals.end(), vertex.begin() + 3, vertex.begin() + 6);
      coordinates.insert(coordinates.end(), vertex.begin() + 6, vertex.begin() + 8);
      damage.push_back(vertex[8]);
    }
    Json attributes = {{"POSITION", file_.addPositions(positions)},
                       {"NORMAL", file_.addVertices(normals, 3)},
                       {"_DAMAGE", file_.addVertices(damage, 1)}};
    if (shapes_.haveCoordinates()) attributes["TEXCOORD_0"] = file_.addVertices(coordinates, 2);
    return {{"attributes", std::move(attributes)},
            {"indices", file_.addTriangles(corners)},
            {"material", materialOf(side)}};
  }

  /// The primitives of each shape of a fragment. Shapes have primitives in common.
  std::vector<Json> primitivesOf(const ShapedFragment& shaped) {
    std::vector<Json> primitives(shaped.shapes().size(), Json::array());
    for (const ShapeChunk& chunk : shapeChunks(shaped)) {
      for (const auto& [side, triangles] : chunk.triangles) {
        const Json made = primitive(shaped.vertices(), side, triangles);
        for (std::size_t shape = chunk.firstShape; shape <= chunk.lastShape; ++shape)
          primitives[shape].push_back(made);
      }
    }
    return primitives;
  }

  void show(std::size_t node, const ShapeFrames& frames) {
    if (frames.first == 0 && frames.last + 1 == times_.size()) return;
    extensions_.insert({"KHR_node_visibility", "KHR_animation_pointer"});
    animation_.show(node, frames.first, frames.last);
  }

  std::size_t addMesh(const std::string& name, Json primitives) {
    return file_.append("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
  }

  /// One node for each shape, below the fragment's.
  Json addShapes(const std::string& fragment, const ShapedFragment& shaped, std::vector<Json> primitives) {
    Json children = Json::array();
    for (std::size_t shape = 0; shape < primitives.size(); ++shape) {
      const ShapeFrames& frames = shaped.shapes()[shape];
      const std::string name = fragment + "_from_" + std::to_string(frames.first);
      const std::size_t mesh = addMesh(name, std::move(primitives[shape]));
      const std::size_t node = file_.append("nodes", {{"name", name}, {"mesh", mesh}});
      show(node, frames);
      children.push_back(node);
    }
    return children;
  }

  /// A node that moves as the fragment does, with its mesh, or its shapes where there are several.
  std::size_t addFragment(const FragmentMotion& motion) {
    const ShapedFragment& shaped = shapes_.fragments().at(motion.fragment.id);
    const std::string name = "fragment_" + std::to_string(motion.fragment.id);
    const Pose& start = motion.poses.front();
    Json stated = {{"name", name}, {"translation", shortest(inMetres(start.position))}};
    if (start.rotation.vec() != Vec3::Zero()) stated["rotation"] = shortest(upright(start.rotation));
    stated["extras"] = fragmentExtras(motion);
    const std::size_t node = file_.append("nodes", std::move(stated));
    std::vector<Json> primitives = primitivesOf(shaped);
    if (primitives.size() == 1) {
      const std::size_t mesh = addMesh(name, std::move(primitives.front()));
      file_.json()["nodes"][node]["mesh"] = mesh;
      show(node, shaped.shapes().front());
    } else {
      Json children = addShapes(name, shaped, std::move(primitives));
      file_.json()["nodes"][node]["children"] = std::move(children);
    }
    animation_.move(node, motion.poses, motion.firstFrame, motion.radius, kKeyTolerance);
    return node;
  }

  const sim::TakeReader& take_;
  const Scene& scene_;
  std::vector<Look> looks_;
  const FragmentShapes& shapes_;
  const std::vector<FragmentMotion>& motions_;
  const std::vector<double>& times_;
  GltfFile file_;
  GltfAnimation animation_;
  std::map<MaterialSide, std::size_t> materials_;
  std::set<std::string> extensions_;  ///< that are used
};

void remarkOnFit(const std::vector<FragmentMotion>& motions, const ExportRequest& request) {
  if (!request.remark || motions.empty()) return;
  const FitResidual all = residualOf(motions);
  const auto worst =
      std::max_element(motions.begin(), motions.end(), [](const FragmentMotion& a, const FragmentMotion& b) {
        return a.residual.largest < b.residual.largest;
      });
  request.remark(std::to_string(motions.size()) + " fragments as rigid pieces; their nodes are " +
                 std::to_string(all.rootMeanSquare()) + " cm (RMS) from there, at most " +
                 std::to_string(all.largest) + " cm in fragment " + std::to_string(worst->fragment.id) +
                 "; pc2 and ply hold what deforms");
}

}  // namespace

sim::Status writeGlb(const sim::TakeReader& take, const ExportRequest& request) {
  assert(request.firstFrame <= request.lastFrame && request.lastFrame < take.frameCount());
  const auto scene = sceneOf(take);
  if (!scene) return scene.problem();
  const auto first = take.frame(request.firstFrame);
  if (!first) return first.problem();
  std::optional<PartParameters> parameters;
  // Without the scene, or a file that it names, there are no texture coordinates.
  if (auto found = PartParameters::create(*scene, "", take.network())) parameters = std::move(*found);
  FragmentFollower fragments(*first);
  FragmentShapes shapes(take.network(), **first, request.looseNodes, parameters);
  const auto status =
      forEachFrame(take, request, [&](std::size_t, const sim::Snapshot& frame) -> sim::Status {
        fragments.follow(frame);
        shapes.follow(frame.broken, fragments);
        return sim::Done{};
      });
  if (!status) return status;
  std::vector<FragmentMotion> motions = fragments.motions();
  // Nodes whose material was given to the fragments beside them are not seen.
  std::erase_if(motions,
                [&](const auto& motion) { return !shapes.fragments().contains(motion.fragment.id); });
  const std::vector<double> times = frameTimes(take, request);
  const GltfFile file = GlbWriter(take, *scene, shapes, motions, times).run();
  if (auto written = file.write(request.path); !written) return written;
  remarkOnFit(motions, request);
  return sim::Done{};
}

}  // namespace modeling
