#include <algorithm>

#include "modeling/scene/scene_codec.h"
#include "sim/collider/surface_check.h"

namespace modeling {

using ColliderCodec = TaggedCodec<SceneCollider, ColliderForm, &SceneCollider::form>;

bool Codec<SceneCollider>::read(JsonReader& reader, const JsonValue& value, SceneCollider& out,
                                const Rule& rule) {
  return ColliderCodec::read(reader, value, out, rule);
}

Json Codec<SceneCollider>::write(const SceneCollider& value, const SceneCollider& base, const Rule& rule) {
  return ColliderCodec::write(value, base, rule);
}

Json Codec<SceneCollider>::schema(const Rule& rule) {
  return ColliderCodec::schema(rule);
}

namespace {

using Points = std::vector<Vec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

constexpr Rule kPoints{
    "points", "Corners, cm.", true, {-reachOf(Dimension::length), reachOf(Dimension::length)}, false};
constexpr Rule kTriangles{
    "triangles", "Numbers of three points each, from 0.", true, {0.0, 4294967295.0}, false};

}  // namespace

bool Codec<ObstacleSurface>::read(JsonReader& reader, const JsonValue& value, ObstacleSurface& out,
                                  const Rule& rule) {
  if (!reader.checkObject(value, rule, {"points", "triangles"})) return false;
  for (const Rule& needed : {kPoints, kTriangles})
    if (value.find(needed.key) == nullptr) return reader.failMissing(value, needed.key);
  Points points;
  Triangles triangles;
  const JsonValue& list = *value.find("triangles");
  if (!Codec<Points>::read(reader, *value.find("points"), points, kPoints) ||
      !Codec<Triangles>::read(reader, list, triangles, kTriangles))
    return false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (*std::max_element(triangles[i].begin(), triangles[i].end()) < points.size()) continue;
    return reader.fail((*list.array())[i].position, "this triangle names a point that is not there",
                       "count points from 0");
  }
  if (const sim::Status status = sim::checkSurface(points, triangles); !status)
    return reader.fail(list.position, status.problem().what, status.problem().remedy);
  out.mesh = std::make_shared<sim::TriangleMesh>(std::move(points), triangles);
  return true;
}

Json Codec<ObstacleSurface>::write(const ObstacleSurface& value, const ObstacleSurface&, const Rule&) {
  return {{"points", Codec<Points>::write(value.mesh->points(), {}, kPoints)},
          {"triangles", Codec<Triangles>::write(value.mesh->triangles(), {}, kTriangles)}};
}

Json Codec<ObstacleSurface>::schema(const Rule&) {
  Json schema = objectSchema();
  schema["properties"]["points"] = Codec<Points>::schema(kPoints);
  schema["properties"]["triangles"] = Codec<Triangles>::schema(kTriangles);
  schema["required"] = {"points", "triangles"};
  return schema;
}

}  // namespace modeling
