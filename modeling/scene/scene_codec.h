#pragma once

#include "modeling/scene/json_codec.h"
#include "modeling/scene/scene_fields.h"
#include "modeling/scene/scene_names.h"

/// The values of a scene file that are not simply an object, a list, a number or a name, and the largest
/// objects.
namespace modeling {

// The largest structs, each in a source of its own, so that none takes long to compile.

/// The part's keys and those of its kind, side by side.
template <>
struct Codec<Part> {
  static bool read(JsonReader& reader, const JsonValue& value, Part& out, const Rule& rule);
  static Json write(const Part& value, const Part& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// The collider's keys and those of its kind, side by side.
template <>
struct Codec<SceneCollider> {
  static bool read(JsonReader& reader, const JsonValue& value, SceneCollider& out, const Rule& rule);
  static Json write(const SceneCollider& value, const SceneCollider& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

template <>
struct Codec<Gluing> {
  static bool read(JsonReader& reader, const JsonValue& value, Gluing& out, const Rule& rule);
  static Json write(const Gluing& value, const Gluing& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

template <>
struct Codec<View> {
  static bool read(JsonReader& reader, const JsonValue& value, View& out, const Rule& rule);
  static Json write(const View& value, const View& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

template <>
struct Codec<Solver> {
  static bool read(JsonReader& reader, const JsonValue& value, Solver& out, const Rule& rule);
  static Json write(const Solver& value, const Solver& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// {"points": [[x, y, z], ...], "triangles": [[a, b, c], ...]}, or null.
template <>
struct Codec<ObstacleSurface> {
  static bool read(JsonReader& reader, const JsonValue& value, ObstacleSurface& out, const Rule& rule);
  static Json write(const ObstacleSurface& value, const ObstacleSurface& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// Three angles or four numbers of a quaternion.
template <>
struct Codec<Rotation> {
  static bool read(JsonReader& reader, const JsonValue& value, Rotation& out, const Rule& rule);
  static Json write(const Rotation& value, const Rotation& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// One number or three.
template <>
struct Codec<Scale> {
  static bool read(JsonReader& reader, const JsonValue& value, Scale& out, const Rule& rule);
  static Json write(const Scale& value, const Scale& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// "auto", seconds, or {"tolerance": number}.
template <>
struct Codec<Step> {
  static bool read(JsonReader& reader, const JsonValue& value, Step& out, const Rule& rule);
  static Json write(const Step& value, const Step& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

template <>
struct Codec<TargetName> {
  static bool read(JsonReader& reader, const JsonValue& value, TargetName& out, const Rule& rule);
  static Json write(const TargetName& value, const TargetName& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// [time, value], the value a number or three.
template <>
struct Codec<SceneTrackKey> {
  static bool read(JsonReader& reader, const JsonValue& value, SceneTrackKey& out, const Rule& rule);
  static Json write(const SceneTrackKey& value, const SceneTrackKey& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// One number for all along, or a list of segments of four.
template <>
struct Codec<ValueChain> {
  static bool read(JsonReader& reader, const JsonValue& value, ValueChain& out, const Rule& rule);
  static Json write(const ValueChain& value, const ValueChain& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// A list of segments, each of four control points, or of two: a straight one.
template <class Point>
struct ChainCodec {
  using Chain = CubicChain<Point>;
  static bool read(JsonReader& reader, const JsonValue& value, Chain& out, const Rule& rule);
  static Json write(const Chain& value, const Chain& base, const Rule& rule);
  static Json schema(const Rule& rule);
};
template <>
struct Codec<ProfileChain> : ChainCodec<Vec2> {};
template <>
struct Codec<CurveChain> : ChainCodec<Vec3> {};

/// An object: one member a type.
template <>
struct Codec<std::vector<NamedBondType>> {
  using Types = std::vector<NamedBondType>;
  static bool read(JsonReader& reader, const JsonValue& value, Types& out, const Rule& rule);
  static Json write(const Types& value, const Types& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

/// An object: one member a material, with an optional "preset" that the other keys are laid over.
template <>
struct Codec<std::vector<SceneMaterial>> {
  using Materials = std::vector<SceneMaterial>;
  static bool read(JsonReader& reader, const JsonValue& value, Materials& out, const Rule& rule);
  static Json write(const Materials& value, const Materials& base, const Rule& rule);
  static Json schema(const Rule& rule);
};

}  // namespace modeling
