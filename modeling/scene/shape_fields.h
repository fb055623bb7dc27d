#pragma once

#include "modeling/scene/scene.h"
#include "modeling/text/json_fields.h"

/// The fields of the shapes of parts.
namespace modeling {

/// Files of meshes that can be read (modeling/import/mesh_file.h).
inline constexpr std::string_view kMeshFiles = "*.obj *.ply *.stl *.gltf *.glb *.fbx *.dae";

template <>
struct Fields<Resolution> {
  static constexpr auto list() {
    using T = Resolution;
    return std::tuple{
        field("cellSize", &T::cellSize, "Cell size", "Target edge of a cell.").size(0.05),
        field("counts", &T::counts, "Cells",
              "Cells along the shape's u, v and w; null: as many as make them nearest to cellSize.")
            .absent("auto")
            .between(1, 1e6)};
  }
};

template <>
struct Fields<SlabShape> {
  static constexpr auto list() {
    using T = SlabShape;
    return std::tuple{field("size", &T::size, "Size", "Extent along x, y and z.").required().size(0.2),
                      field("resolution", &T::resolution, "Cells", "How finely it is divided.")};
  }
};

template <>
struct Fields<BezierPatchShape> {
  static constexpr auto list() {
    using T = BezierPatchShape;
    constexpr auto hasOneNet = [](const T& patch) { return !patch.oppositeNet; };
    return std::tuple{
        field("net", &T::net, "Net", "Control points, four rows (along u) of four (along v).")
            .required()
            .in(Dimension::length, 0.1),
        field("oppositeNet", &T::oppositeNet, "Opposite net",
              "Where given, the solid lies between the two nets.")
            .in(Dimension::length, 0.1)
            .absent("none"),
        field("thickness", &T::thickness, "Thickness",
              "Thickness of the wall; not read where oppositeNet is given.")
            .size(0.05)

            .where(hasOneNet),
        field("side", &T::side, "Wall lies", "Where the wall lies as seen along the net's normal.")
            .where(hasOneNet),
        field("resolution", &T::resolution, "Cells", "How finely it is divided.")};
  }
};

template <>
struct Fields<RevolutionShape> {
  static constexpr auto list() {
    using T = RevolutionShape;
    return std::tuple{
        field("outside", &T::outside, "Outside", "Outer profile: segments of (r, z) points.")
            .required()
            .in(Dimension::length, 0.1),
        field("inside", &T::inside, "Inside", "Inner profile, running the same way.")
            .required()
            .in(Dimension::length, 0.1),
        field("correspondence", &T::correspondence, "Profiles match",
              "Which points of the profiles face each other."),
        field("startAngle", &T::startAngle, "Starts at", "Where the turn starts, from x towards y.").angle(),
        field("turnAngle", &T::turnAngle, "Turn", "How far it turns; 360 is a full turn.")
            .angle()
            .between(1e-3, 360)
            .gauge(),
        field("resolution", &T::resolution, "Cells", "How finely it is divided.")};
  }
};

template <>
struct Fields<CurvedCylinderShape> {
  static constexpr auto list() {
    using T = CurvedCylinderShape;
    constexpr auto hasCentreLine = [](const T& sweep) { return sweep.secondRail.empty(); };
    constexpr auto isHollow = [](const T& sweep) {
      return sweep.section == SweepSection::ring || sweep.section == SweepSection::arc;
    };
    constexpr auto isArc = [](const T& sweep) { return sweep.section == SweepSection::arc; };
    return std::tuple{
        field("curve", &T::curve, "Curve", "Centre line, or first rail: segments of points.")
            .required()
            .in(Dimension::length, 0.1),
        field("secondRail", &T::secondRail, "Second rail", "The other rail; empty: curve is the centre line.")
            .in(Dimension::length, 0.1),
        field("firstAxis", &T::firstAxis, "First axis", "Direction of the section's first axis.")
            .where(hasCentreLine),
        field("keepFirstAxis", &T::keepFirstAxis, "Keep it all along",
              "The first axis keeps that direction all along instead of turning with the curve.")
            .where(hasCentreLine),
        field("section", &T::section, "Section", "What is swept along the curve."),
        field("halfWidth", &T::halfWidth, "Half width",
              "Along the first axis: a number, or four a segment; not read where there are two rails.")
            .size(0.05)

            .where(hasCentreLine),
        field("halfDepth", &T::halfDepth, "Half depth", "Along the second axis: a number, or four a segment.")
            .size(0.05),
        field("wallThickness", &T::wallThickness, "Wall", "Thickness of the wall of a ring or an arc.")
            .size(0.05)

            .where(isHollow),
        field("startAngle", &T::startAngle, "Arc from",
              "Where an arc starts, from the first axis towards the second.")
            .angle()
            .where(isArc),
        field("endAngle", &T::endAngle, "Arc to", "Where an arc ends.").angle().where(isArc),
        field("resolution", &T::resolution, "Cells", "How finely it is divided.")};
  }
};

template <>
struct Fields<BondType> {
  static constexpr auto list() {
    using T = BondType;
    return std::tuple{
        field("stiffness", &T::stiffness, "Stiffness", "Stiffness k of the spring.")
            .required()
            .in(Dimension::stiffness, 100.0)
            .logarithmic()
            .atLeast(1e-9),
        field("restLength", &T::restLength, "Length at rest", "Length l at rest.")
            .size(0.05)
            .absent("as in the file"),
        field("damping", &T::damping, "Damping", "Strength d of the damper.")
            .in(Dimension::damping, 0.1)
            .logarithmic()
            .atLeast(0),
        field("threshold", &T::threshold, "Breaks at", "Relative stretch at which a bond breaks.")
            .in(Dimension::share, 0.01)
            .absent("never")
            .between(1e-9, 1e9)};
  }
};

template <>
struct Fields<NetworkShape> {
  static constexpr auto list() {
    using T = NetworkShape;
    return std::tuple{
        field("file", &T::file, "File", "Path of the file, relative to the scene's folder.")
            .required()
            .file("*.data *.lmp *.lammps"),
        field("format", &T::format, "Format", "Format of the file.").required(),
        field("bondTypes", &T::bondTypes, "Bonds", "Constants for each bond type of the file.").required()};
  }
};

template <>
struct Fields<MeshShape> {
  static constexpr auto list() {
    using T = MeshShape;
    return std::tuple{
        field("file", &T::file, "File",
              "Path relative to the scene's folder: OBJ, PLY, STL, glTF, FBX or Collada.")
            .required()
            .file(kMeshFiles),
        field("unit", &T::unit, "Unit",
              "What a length of 1 in the file is; guess: by the format, or by its size."),
        field("up", &T::up, "Up axis", "Which axis of the file points up; guess: by the format."),
        field("cellSize", &T::cellSize, "Cell size", "Edge of a cell.").size(0.05)};
  }
};

}  // namespace modeling
