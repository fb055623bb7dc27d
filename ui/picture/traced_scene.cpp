#include "ui/picture/traced_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

namespace ui {

namespace {

/// Share of a ray's start distance from the origin of coordinates by which its nearest meetings are passed
/// over: some ten roundings of single precision, so that no surface shadows itself.
constexpr float kSkip = 2e-6F;

RTCRay rayFrom(const Vec3f& origin, const Vec3f& direction, float distance, float time) {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = kSkip * (1.0F + origin.norm());
  ray.tfar = distance;
  ray.time = time;
  ray.mask = 0xffffffffU;
  return ray;
}

/// Distance to a floor seen from above; infinite where the ray does not come down on it.
float distanceTo(const TracedScene::Plane& floor, const Vec3f& origin, const Vec3f& direction) {
  const float falling = -floor.normal.dot(direction);
  const float height = floor.normal.dot(origin) - floor.offset;
  const bool meets = falling > 0.0F && height > kSkip * (1.0F + origin.norm());
  return meets ? height / falling : std::numeric_limits<float>::infinity();
}

/// Copies them, once or for both ends of the time that the shutter is open. False without memory.
bool setVertices(RTCGeometry geometry, const DrawnMesh& mesh) {
  if (!mesh.endPositions.empty()) rtcSetGeometryTimeStepCount(geometry, 2);
  unsigned step = 0;
  for (const std::vector<Vec3f>* positions : {&mesh.positions, &mesh.endPositions}) {
    if (positions->empty()) continue;
    auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, step++, RTC_FORMAT_FLOAT3, sizeof(Vec3f), positions->size()));
    if (vertices == nullptr) return false;
    std::copy(positions->begin(), positions->end(), vertices);
  }
  return true;
}

}  // namespace

sim::Result<std::unique_ptr<TracedScene>> TracedScene::create(DrawnMesh mesh, std::vector<Plane> floors) {
  std::unique_ptr<TracedScene> traced(new TracedScene);
  traced->mesh_ = std::move(mesh);
  traced->floors_ = std::move(floors);
  traced->hasGlass_ = std::any_of(traced->mesh_.looks.begin(), traced->mesh_.looks.end(),
                                  [](const DrawnLook& look) { return look.glass; });
  const sim::Problem noMemory{"", "there is not enough memory to trace rays",
                              "close other programs, or draw fewer cells"};
  traced->device_ = rtcNewDevice(nullptr);
  if (traced->device_ == nullptr) return noMemory;
  traced->scene_ = rtcNewScene(traced->device_);
  rtcSetSceneFlags(traced->scene_, RTC_SCENE_FLAG_ROBUST);
  if (!traced->mesh_.quads.empty()) {
    RTCGeometry geometry = rtcNewGeometry(traced->device_, RTC_GEOMETRY_TYPE_QUAD);
    using Corners = std::array<std::uint32_t, 4>;
    auto* corners = static_cast<Corners*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, sizeof(Corners), traced->mesh_.quads.size()));
    if (!setVertices(geometry, traced->mesh_) || corners == nullptr) {
      rtcReleaseGeometry(geometry);
      return noMemory;
    }
    std::copy(traced->mesh_.quads.begin(), traced->mesh_.quads.end(), corners);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(traced->scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(traced->scene_);
  if (rtcGetDeviceError(traced->device_) != RTC_ERROR_NONE) return noMemory;
  return traced;
}

TracedScene::~TracedScene() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

// A flat piece of a smooth surface lies below it, and would cast shadows on itself where light grazes: the
// start of rays is lifted to where the planes of the corners' normals meet above it (Hanika, "Hacking the
// shadow terminator", 2021).
SurfaceHit TracedScene::meshHit(std::uint32_t quad, const std::array<float, 4>& weights, const Vec3f& point,
                                const Vec3f& facing, float time) const {
  const auto& corner = mesh_.quads[quad];
  SurfaceHit hit;
  hit.point = hit.start = point;
  hit.facing = facing;
  hit.normal.setZero();
  hit.restPoint.setZero();
  for (unsigned c = 0; c < 4; ++c) {
    const Vec3f& vertexNormal = mesh_.normals[corner[c]];
    const Vec3f normal = vertexNormal.dot(facing) < 0.0F ? Vec3f(-vertexNormal) : vertexNormal;
    Vec3f position = mesh_.positions[corner[c]];
    if (!mesh_.endPositions.empty()) position += time * (mesh_.endPositions[corner[c]] - position);
    const float below = std::min(0.0F, normal.dot(point - position));
    hit.start -= weights[c] * below * normal;
    hit.normal += weights[c] * normal;
    hit.restPoint += weights[c] * mesh_.restPoints[corner[c]];
  }
  hit.normal = hit.normal.norm() > 0.0F ? Vec3f(hit.normal.normalized()) : facing;
  hit.look = &mesh_.looks[mesh_.lookOfQuad[quad]];
  hit.entering = mesh_.normals[corner[0]].dot(facing) >= 0.0F;
  return hit;
}

std::optional<SurfaceHit> TracedScene::nearest(const Vec3f& origin, const Vec3f& direction,
                                               float time) const {
  RTCRayHit query{};
  query.ray = rayFrom(origin, direction, std::numeric_limits<float>::infinity(), time);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &query);

  float distance = query.ray.tfar;
  const Plane* floor = nullptr;
  for (const Plane& plane : floors_) {
    if (const float reach = distanceTo(plane, origin, direction); reach < distance) {
      distance = reach;
      floor = &plane;
    }
  }
  if (!std::isfinite(distance)) return std::nullopt;
  const Vec3f point = origin + distance * direction;
  if (floor != nullptr) {
    return SurfaceHit{.point = point,
                      .start = point,
                      .facing = floor->normal,
                      .normal = floor->normal,
                      .distance = distance};
  }
  Vec3f facing = Vec3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).stableNormalized();
  if (facing.dot(direction) > 0.0F) facing = -facing;
  // Embree splits a quad along its corners 1 and 3 and gives (u, v) of the whole quad.
  const float u = query.hit.u;
  const float v = query.hit.v;
  SurfaceHit hit =
      meshHit(query.hit.primID, {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v}, point, facing, time);
  hit.distance = distance;
  return hit;
}

bool TracedScene::isBlocked(const Vec3f& origin, const Vec3f& direction, float distance, float time) const {
  for (const Plane& plane : floors_) {
    if (distanceTo(plane, origin, direction) < distance) return true;
  }
  RTCRay ray = rayFrom(origin, direction, distance, time);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &ray);
  return ray.tfar < 0.0F;
}

// Straight on: bending it would need a search for each light. A surface reflects some twelfth away.
Light TracedScene::transmitted(const Vec3f& origin, const Vec3f& direction, float distance,
                               float time) const {
  if (!hasGlass_) return Light::Constant(isBlocked(origin, direction, distance, time) ? 0.0F : 1.0F);
  constexpr float kThroughSurface = 0.92F;
  constexpr int kMostSurfaces = 12;
  Light light = Light::Ones();
  Vec3f from = origin;
  for (int surface = 0; surface < kMostSurfaces; ++surface) {
    const auto hit = nearest(from, direction, time);
    if (!hit || hit->distance >= distance) return light;
    if (hit->look == nullptr || !hit->look->glass) return Light::Zero();
    light *= kThroughSurface;
    if (!hit->entering) light *= glassColour(*hit->look, hit->distance);
    distance -= hit->distance;
    from = hit->point;
  }
  return Light::Zero();
}

}  // namespace ui
