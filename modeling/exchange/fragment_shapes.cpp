#include "modeling/exchange/fragment_shapes.h"

#include <algorithm>
#include <cmath>

#include "modeling/exchange/gltf_axes.h"
#include "modeling/exchange/rounded_surface.h"

namespace modeling {

namespace {

ShapeVertex vertexOf(const RoundedSurface& surface, const RoundedSurface::Corner& corner, const Vec3& origin,
                     const FaceCoordinates& coordinates) {
  const auto at = inMetres(surface.points[corner.point] - origin);
  const auto normal = upright(surface.normals[corner.normal]);
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();
  for (std::size_t c = 0; c < 4; ++c) uv += corner.weights[c] * coordinates[c];
  // glTF counts v from the top of a picture.
  ShapeVertex vertex{at[0],     at[1],         at[2],
                     normal[0], normal[1],     normal[2],
                     uv.x(),    1.0F - uv.y(), surface.damage[corner.point]};
  // Zeros have one sign.
  for (float& number : vertex) number += 0.0F;
  return vertex;
}

/// What a face adds to the volume of what it closes, at rest, cm^3.
double volumeBelow(const sim::SurfaceTopology& topology, const sim::SurfaceTopology::Face& face) {
  double volume = 0.0;
  const Vec3& a = topology.restPoints[face.points[0]];
  for (unsigned c = 2; c < face.cornerCount; ++c)
    volume += a.dot(topology.restPoints[face.points[c - 1]].cross(topology.restPoints[face.points[c]])) / 6.0;
  return volume;
}

/// The faces of some fragments. Points and normals keep their numbers.
sim::SurfaceMesh facesOf(const sim::SurfaceMesh& mesh, const std::set<sim::FragmentId>& fragments) {
  sim::SurfaceMesh part = mesh;
  std::erase_if(part.faces, [&](const auto& face) { return !fragments.contains(face.fragment); });
  return part;
}

}  // namespace

std::uint32_t ShapedFragment::numberOf(const ShapeVertex& vertex) {
  const auto [found, isNew] = known_.try_emplace(vertex, static_cast<std::uint32_t>(vertices_.size()));
  if (isNew) vertices_.push_back(vertex);
  return found->second;
}

void ShapedFragment::begin(std::size_t frame) {
  shapes_.push_back({frame, frame});
}

void ShapedFragment::add(const MaterialSide& side, const std::array<ShapeVertex, 3>& corners) {
  const std::size_t shape = shapes_.size() - 1;
  std::vector<ShapeTriangle>& triangles = triangles_[side];
  const Corners vertices{numberOf(corners[0]), numberOf(corners[1]), numberOf(corners[2])};
  const auto [found, isNew] = newest_[side].try_emplace(vertices, triangles.size());
  if (isNew) {
    triangles.push_back({vertices, shape, shape});
  } else {
    triangles[found->second].lastShape = shape;
  }
}

void ShapedFragment::end() {
  for (auto& [side, newest] : newest_) {
    const std::vector<ShapeTriangle>& triangles = triangles_[side];
    std::erase_if(newest,
                  [&](const auto& entry) { return triangles[entry.second].lastShape + 1 < shapes_.size(); });
  }
}

FragmentShapes::FragmentShapes(const sim::Network& network, const sim::Snapshot& first,
                               sim::LooseNodes looseNodes, const std::optional<PartParameters>& parameters)
    : first_(first),
      parameters_(parameters),
      givesMaterial_(looseNodes == sim::LooseNodes::givenToNeighbours),
      builder_(network, looseNodes) {}

std::map<sim::FragmentId, FragmentShapes::Signature> FragmentShapes::signaturesOf(
    const sim::SurfaceTopology& topology, const FragmentFollower& followed) const {
  std::map<sim::FragmentId, Signature> signatures;
  for (const auto& face : topology.faces) {
    if (!followed.has(face.fragment)) continue;
    const auto [found, isNew] = signatures.try_emplace(face.fragment);
    std::vector<double>& marks = found->second.marks;
    if (isNew) {
      const auto& nodes = followed.nodesOf(face.fragment);
      marks.assign(nodes.begin(), nodes.end());
    }
    found->second.volume += volumeBelow(topology, face);
    if (!givesMaterial_) continue;
    for (const double number : {static_cast<double>(face.cell), static_cast<double>(face.material),
                                static_cast<double>(face.cornerCount), face.inside ? 1.0 : 0.0})
      marks.push_back(number);
    for (const std::uint32_t point : face.points) {
      const Vec3& at = topology.restPoints[point];
      marks.insert(marks.end(), {at.x(), at.y(), at.z()});
    }
  }
  return signatures;
}

void FragmentShapes::follow(const sim::BrokenPointer& broken, const FragmentFollower& followed) {
  const std::size_t frame = frames_++;
  if (frame == 0 || broken->version != version_) {
    const sim::SurfaceTopology& topology = builder_.topology(broken);
    auto signatures = signaturesOf(topology, followed);
    std::set<sim::FragmentId> changed;
    for (auto& [id, signature] : signatures) {
      const auto before = signatures_.find(id);
      if (before != signatures_.end() && before->second.marks == signature.marks &&
          std::abs(signature.volume - before->second.volume) <= kVolumeShare * before->second.volume) {
        signature.volume = before->second.volume;
      } else {
        changed.insert(id);
      }
    }
    addShapes(topology, followed, changed);
    if (frame == 0) measure(topology);
    signatures_ = std::move(signatures);
    version_ = broken->version;
  }
  for (const auto& [id, signature] : signatures_) fragments_[id].goOn(frame);
}

void FragmentShapes::addShapes(const sim::SurfaceTopology& topology, const FragmentFollower& followed,
                               const std::set<sim::FragmentId>& changed) {
  if (changed.empty()) return;
  const sim::SurfaceMesh mesh = facesOf(sim::placeSurface(topology, first_.positions), changed);
  const RoundedSurface rounded = roundedSurface(mesh);
  for (const sim::FragmentId id : changed) fragments_[id].begin(frames_ - 1);
  std::uint32_t coordinatesFace = sim::kNone;
  FaceCoordinates coordinates;
  coordinates.fill(Eigen::Vector2f::Zero());
  for (const RoundedSurface::Triangle& triangle : rounded.triangles) {
    const auto& face = mesh.faces[triangle.face];
    if (parameters_ && triangle.face != coordinatesFace) {
      coordinates = parameters_->textureCoordinates(mesh, face);
      coordinatesFace = triangle.face;
    }
    const Vec3& origin = followed.originOf(face.fragment);
    std::array<ShapeVertex, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
      corners[c] = vertexOf(rounded, triangle.corners[c], origin, coordinates);
    fragments_[face.fragment].add(MaterialSide(face.material, face.inside), corners);
  }
  for (const sim::FragmentId id : changed) fragments_[id].end();
}

void FragmentShapes::measure(const sim::SurfaceTopology& topology) {
  std::map<sim::FragmentId, Extent> extents;
  std::map<sim::MaterialIndex, std::map<sim::FragmentId, bool>> isIn;
  for (const auto& face : topology.faces) {
    isIn[face.material][face.fragment] = true;
    Extent& extent = extents[face.fragment];
    extent.volume += volumeBelow(topology, face);
    for (unsigned c = 2; c < face.cornerCount; ++c) {
      const Vec3& a = topology.restPoints[face.points[0]];
      const Vec3& b = topology.restPoints[face.points[c - 1]];
      const Vec3& d = topology.restPoints[face.points[c]];
      extent.area += 0.5 * (b - a).cross(d - a).norm();
    }
  }
  for (const auto& [material, fragments] : isIn) {
    for (const auto& [id, present] : fragments) {
      extents_[material].volume += extents[id].volume;
      extents_[material].area += extents[id].area;
    }
  }
}

double FragmentShapes::thicknessOf(sim::MaterialIndex material) const {
  const auto found = extents_.find(material);
  if (found == extents_.end() || !(found->second.area > 0.0)) return 0.0;
  return std::max(0.0, 2.0 * found->second.volume / found->second.area);
}

}  // namespace modeling
