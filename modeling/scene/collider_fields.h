#pragma once

#include "modeling/scene/shape_fields.h"

/// The fields of colliders and of their forms.
namespace modeling {

template <>
struct Fields<FloorShape> {
  static constexpr auto list() { return std::tuple{}; }
};

template <>
struct Fields<BoxShape> {
  static constexpr auto list() {
    return std::tuple{field("halfSize", &BoxShape::halfSize, "Half size", "Half the edges along x, y and z.")
                          .required()
                          .size(0.5)};
  }
};

template <>
struct Fields<SphereShape> {
  static constexpr auto list() {
    return std::tuple{
        field("radius", &SphereShape::radius, "Radius", "Radius of the sphere.").required().size(0.2)};
  }
};

template <>
struct Fields<CylinderShape> {
  static constexpr auto list() {
    using T = CylinderShape;
    return std::tuple{field("radius", &T::radius, "Radius", "Radius of the cylinder.").required().size(0.2),
                      field("halfHeight", &T::halfHeight, "Half height", "Half its height along its z.")
                          .required()
                          .size(0.2)};
  }
};

template <>
struct Fields<MeshObstacle> {
  static constexpr auto list() {
    using T = MeshObstacle;
    constexpr auto hasFile = [](const T& mesh) { return !mesh.file.empty() || !mesh.surface.mesh; };
    return std::tuple{
        field("file", &T::file, "File",
              "Path relative to the scene's folder: OBJ, PLY, STL, glTF, FBX or Collada.")
            .file(kMeshFiles)
            .where(hasFile),
        field("unit", &T::unit, "Unit",
              "What a length of 1 in the file is; guess: by the format, or by its size.")
            .where(hasFile),
        field("up", &T::up, "Up axis", "Which axis of the file points up; guess: by the format.")
            .where(hasFile),
        field("thickness", &T::thickness, "Thickness",
              "Thickness of a sheet, which an open mesh is; not read of a closed one.")
            .size(0.05),
        field(
            "surface", &T::surface, "Surface",
            "The triangles themselves, in place of the file's: points in cm, and triangles of three numbers "
            "of points each.")
            .absent("read from the file")};
  }
};

template <>
struct Fields<SceneCollider> {
  static constexpr auto list() {
    using T = SceneCollider;
    return std::tuple{
        field("name", &T::name, "Name", "Differs from every other collider's.").required(),
        field("position", &T::position, "Position", "A point of a floor, else the centre.")
            .in(Dimension::length, 0.5),
        field("rotation", &T::rotation, "Rotation", "As a part's; a floor's normal is its z.")
            .in(Dimension::degrees, 5.0),
        field("stiffness", &T::stiffness, "Stiffness", "Stiffness for each node that touches it.")
            .in(Dimension::stiffness, 1e5)
            .logarithmic()
            .absent("the node's own")
            .atLeast(1e-9),
        field("dampingRatio", &T::dampingRatio, "Damping", "Damping relative to critical.")
            .step(0.05)
            .between(0, 100),
        field("friction", &T::friction, "Friction", "Lateral force relative to the push.")
            .step(0.05)
            .between(0, 100),
        field("visible", &T::visible, "Drawn", "Whether it is drawn; it pushes either way."),
        field("active", &T::active, "Active",
              "From when until when, the end excluded, it is there at all; null: always.")
            .in(Dimension::time, 0.05)
            .absent("always")};
  }
};

}  // namespace modeling
