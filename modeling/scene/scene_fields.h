#pragma once

#include "modeling/scene/scene.h"
#include "modeling/text/json_fields.h"

/// The keys of a scene file, struct by struct. What stands here is what is read, written, and in the schema.
namespace modeling {

template <>
struct Fields<Resolution> {
  static constexpr auto list() {
    using T = Resolution;
    return std::tuple{field("cellSize", &T::cellSize, "Target edge of a cell, cm.").above(0),
                      field("counts", &T::counts, "Cells along the shape's u, v and w; null: by cellSize.")
                          .atLeast(1)
                          .atMost(1e6)};
  }
};

template <>
struct Fields<SlabShape> {
  static constexpr auto list() {
    using T = SlabShape;
    return std::tuple{field("size", &T::size, "Extent along x, y and z, cm.").required().above(0),
                      field("resolution", &T::resolution, "How finely it is divided.")};
  }
};

template <>
struct Fields<BezierPatchShape> {
  static constexpr auto list() {
    using T = BezierPatchShape;
    return std::tuple{
        field("net", &T::net, "Control points, four rows (along u) of four (along v), cm.").required(),
        field("oppositeNet", &T::oppositeNet, "Where given, the solid lies between the two nets."),
        field("thickness", &T::thickness, "Of the wall, cm; not read where oppositeNet is given.").above(0),
        field("side", &T::side, "Where the wall lies as seen along the net's normal."),
        field("resolution", &T::resolution, "How finely it is divided.")};
  }
};

template <>
struct Fields<RevolutionShape> {
  static constexpr auto list() {
    using T = RevolutionShape;
    return std::tuple{
        field("outside", &T::outside, "Outer profile: segments of (r, z) points, cm.").required(),
        field("inside", &T::inside, "Inner profile, running the same way, cm.").required(),
        field("correspondence", &T::correspondence, "Which points of the profiles face each other."),
        field("startAngle", &T::startAngle, "Degrees, from x towards y.").angle(),
        field("turnAngle", &T::turnAngle, "Degrees; 360 is a full turn.").angle().above(0).atMost(360),
        field("resolution", &T::resolution, "How finely it is divided.")};
  }
};

template <>
struct Fields<CurvedCylinderShape> {
  static constexpr auto list() {
    using T = CurvedCylinderShape;
    return std::tuple{
        field("curve", &T::curve, "Centre line, or first rail: segments of points, cm.").required(),
        field("secondRail", &T::secondRail, "The other rail; empty: curve is the centre line."),
        field("firstAxis", &T::firstAxis, "Direction of the section's first axis."),
        field("keepFirstAxis", &T::keepFirstAxis,
              "Keep that direction all along instead of turning with the curve."),
        field("section", &T::section, "What is swept along."),
        field("halfWidth", &T::halfWidth, "Along the first axis, cm: a number, or four a segment.").above(0),
        field("halfDepth", &T::halfDepth, "Along the second axis, cm: a number, or four a segment.").above(0),
        field("wallThickness", &T::wallThickness, "Of a ring or an arc, cm.").above(0),
        field("startAngle", &T::startAngle, "Of an arc, degrees, from the first axis towards the second.")
            .angle(),
        field("endAngle", &T::endAngle, "Of an arc, degrees.").angle(),
        field("resolution", &T::resolution, "How finely it is divided.")};
  }
};

template <>
struct Fields<BondType> {
  static constexpr auto list() {
    using T = BondType;
    return std::tuple{
        field("stiffness", &T::stiffness, "k, dyn/cm.").required().above(0),
        field("restLength", &T::restLength, "l, cm; left out: the bond's length in the file.").above(0),
        field("damping", &T::damping, "d, g/s.").atLeast(0),
        field("threshold", &T::threshold, "Relative stretch at which a bond breaks; left out: never.")
            .above(0)};
  }
};

template <>
struct Fields<NetworkShape> {
  static constexpr auto list() {
    using T = NetworkShape;
    return std::tuple{
        field("file", &T::file, "Path, relative to the scene's folder.").required(),
        field("format", &T::format, "Of the file.").required(),
        field("bondTypes", &T::bondTypes, "Constants for each bond type of the file.").required()};
  }
};

template <>
struct Fields<MeshShape> {
  static constexpr auto list() {
    using T = MeshShape;
    return std::tuple{
        field("file", &T::file, "Path, relative to the scene's folder: OBJ, PLY, STL, glTF, FBX or Collada.")
            .required(),
        field("unit", &T::unit, "What a length of 1 in the file is; guess: by the format, or by its size."),
        field("up", &T::up, "Which axis of the file points up; guess: by the format."),
        field("cellSize", &T::cellSize, "Edge of a cell, cm.").above(0)};
  }
};

template <>
struct Fields<Placement> {
  static constexpr auto list() {
    using T = Placement;
    return std::tuple{field("position", &T::position, "Of the part's origin, cm."),
                      field("rotation", &T::rotation,
                            "Degrees about the fixed axes x, then y, then z; or a quaternion [w, x, y, z]."),
                      field("scale", &T::scale, "One factor, or one an axis.").above(0)};
  }
};

template <>
struct Fields<Box> {
  static constexpr auto list() {
    return std::tuple{field("min", &Box::min, "Lower corner, cm.").required(),
                      field("max", &Box::max, "Upper corner, cm.").required()};
  }
};

template <>
struct Fields<Part> {
  static constexpr auto list() {
    using T = Part;
    return std::tuple{
        field("name", &T::name, "Differs from every other part's.").required(),
        field("material", &T::material, "A material's name; only a network may leave it out."),
        field("worldFromPart", &T::worldFromPart, "Scale, then rotation, then position."),
        field("velocity", &T::velocity, "At the start, cm/s."),
        field("angularVelocity", &T::angularVelocity,
              "At the start, about the part's centre of mass, rad/s."),
        field("hold", &T::hold, "Boxes in part coordinates: nodes inside are held where they are.")};
  }
};

template <>
struct Fields<Look> {
  static constexpr auto list() {
    return std::tuple{
        field("outside", &Look::outside, "Colour, sRGB.").atLeast(0).atMost(1),
        field("inside", &Look::inside, "Colour that breaking bares, sRGB.").atLeast(0).atMost(1),
        field("glaze", &Look::glaze, "Strength of the glossy coat.").atLeast(0).atMost(1),
        field("finish", &Look::finish, "What light does at the surface; in pictures.")};
  }
};

template <>
struct Fields<ThresholdSpec> {
  static constexpr auto list() {
    using T = ThresholdSpec;
    return std::tuple{field("mean", &T::mean, "Relative stretch at which bonds break.").above(0),
                      field("spread", &T::spread, "Standard deviation relative to the mean.").atLeast(0)};
  }
};

template <>
struct Fields<Plastic> {
  static constexpr auto list() {
    using T = Plastic;
    return std::tuple{
        field("yieldStrain", &T::yieldStrain, "Strain above which rest lengths flow.").required().above(0),
        field("rate", &T::rate, "Share of the excess strain that flows a second, 1/s.").required().above(0)};
  }
};

template <>
struct Fields<Material> {
  static constexpr auto list() {
    using T = Material;
    return std::tuple{
        field("pattern", &T::pattern, "Which corners of a cell are joined."),
        field("youngsModulus", &T::youngsModulus, "E, dyn/cm^2 (1 GPa = 1e10).").above(0),
        field("density", &T::density, "g/cm^3.").above(0),
        field("lossFactor", &T::lossFactor, "Twice the damping ratio at the lattice's highest frequency.")
            .atLeast(0),
        field("threshold", &T::threshold, "At which strain bonds break."),
        field("strength", &T::strength, "Tensile, dyn/cm^2; in place of threshold.mean.").above(0),
        field("fractureToughness", &T::fractureToughness, "K_IC, dyn/cm^(3/2); in place of threshold.mean.")
            .above(0),
        field("plastic", &T::plastic, "Plastic flow."),
        field("look", &T::look, "Colours and gloss."),
        field("source", &T::source, "Where the numbers come from.")};
  }
};

template <>
struct Fields<Gluing> {
  static constexpr auto list() {
    using T = Gluing;
    return std::tuple{
        field("a", &T::a, "The part whose nodes are replaced.").required(),
        field("b", &T::b, "The part it is glued to.").required(),
        field("reach", &T::reach, "Nodes of a this near to a node of b are glued, cm.").atLeast(0),
        field("pairs", &T::pairs, "Where given, exactly these pairs of a node of a and one of b are glued."),
        field("exclude", &T::exclude, "Nodes of a that stay free."),
        field("region", &T::region, "Box in coordinates of part a: only its nodes inside are glued.")};
  }
};

template <>
struct Fields<FloorShape> {
  static constexpr auto list() { return std::tuple{}; }
};
template <>
struct Fields<BoxShape> {
  static constexpr auto list() {
    return std::tuple{field("halfSize", &BoxShape::halfSize, "Half edges, cm.").required().above(0)};
  }
};
template <>
struct Fields<SphereShape> {
  static constexpr auto list() {
    return std::tuple{field("radius", &SphereShape::radius, "cm.").required().above(0)};
  }
};
template <>
struct Fields<CylinderShape> {
  static constexpr auto list() {
    using T = CylinderShape;
    return std::tuple{field("radius", &T::radius, "cm.").required().above(0),
                      field("halfHeight", &T::halfHeight, "Along its z, cm.").required().above(0)};
  }
};

template <>
struct Fields<MeshObstacle> {
  static constexpr auto list() {
    using T = MeshObstacle;
    return std::tuple{
        field("file", &T::file, "Path, relative to the scene's folder: OBJ, PLY, STL, glTF, FBX or Collada."),
        field("unit", &T::unit, "What a length of 1 in the file is; guess: by the format, or by its size."),
        field("up", &T::up, "Which axis of the file points up; guess: by the format."),
        field("thickness", &T::thickness, "Of a sheet, which an open mesh is, cm.").above(0),
        field("surface", &T::surface, "The triangles themselves, cm, in place of the file's.")};
  }
};

template <>
struct Fields<SceneCollider> {
  static constexpr auto list() {
    using T = SceneCollider;
    return std::tuple{
        field("name", &T::name, "Differs from every other collider's.").required(),
        field("position", &T::position, "A point of a floor, else the centre, cm."),
        field("rotation", &T::rotation, "As a part's; a floor's normal is its z."),
        field("stiffness", &T::stiffness, "dyn/cm a node; left out: the node's own contact stiffness.")
            .above(0),
        field("dampingRatio", &T::dampingRatio, "Relative to critical.").atLeast(0),
        field("friction", &T::friction, "Lateral force relative to the push.").atLeast(0),
        field("visible", &T::visible, "Whether it is drawn; it pushes either way."),
        field("active", &T::active,
              "Seconds, from and until: at other times it is not there; null: always.")};
  }
};

template <>
struct Fields<SceneEnvironment> {
  static constexpr auto list() {
    using T = SceneEnvironment;
    return std::tuple{field("gravity", &T::gravity, "cm/s^2."),
                      field("colliders", &T::colliders, "Immovable objects.")};
  }
};

template <>
struct Fields<SceneTrack> {
  static constexpr auto list() {
    using T = SceneTrack;
    return std::tuple{
        field(
            "target", &T::target,
            "gravity, gravity.scale, stiffness.scale[.MATERIAL], damping.scale[.MATERIAL], "
            "collider.NAME.position or collider.NAME.rotation (a rotation vector in degrees). Scales of one "
            "target multiply; of several gravity tracks the last one that has begun counts.")
            .required(),
        field("keys", &T::keys, "Pairs of time in seconds and value.").required(),
        field("interpolation", &T::interpolation, "Between two keys.")};
  }
};

template <>
struct Fields<Contact> {
  static constexpr auto list() {
    using T = Contact;
    return std::tuple{
        field("between", &T::between, "Nodes of different fragments repel."),
        field("self", &T::self, "Nodes of one fragment repel too."),
        field("length", &T::length, "Natural length of a contact: nearest is safe where things break."),
        field("stiffnessScale", &T::stiffnessScale, "Relative to the weaker node's.").above(0),
        field("dampingRatio", &T::dampingRatio, "Relative to critical.").atLeast(0),
        field("friction", &T::friction, "Lateral force relative to the push.").atLeast(0)};
  }
};

template <>
struct Fields<sim::SkipSettings> {
  static constexpr auto list() {
    using T = sim::SkipSettings;
    return std::tuple{field("sleep", &T::sleep, "Fragments at rest, until something wakes them."),
                      field("rigid", &T::rigid, "Deformation of fragments that fly freely and unstrained."),
                      field("contactSearch", &T::contactSearch, "Where nothing is near anything."),
                      field("labelling", &T::labelling, "Fragments where nothing broke."),
                      field("recording", &T::recording, "In takes, nodes that did not move."),
                      field("thresholds", &T::thresholds, "Tests of bonds that cannot break."),
                      field("damping", &T::damping, "Dampers of no strength."),
                      field("ledger", &T::ledger, "The account of energy while nobody reads it.")};
  }
};

template <>
struct Fields<Solver> {
  static constexpr auto list() {
    using T = Solver;
    return std::tuple{field("method", &T::method, "How the equations of motion are stepped."),
                      field("precision", &T::precision, "What forces of bonds are computed in."),
                      field("step", &T::step, "Seconds, auto, or a tolerance of strain.").above(0),
                      field("safety", &T::safety, "Share of the largest stable step.").above(0).atMost(0.9),
                      field("contact", &T::contact, "Between nodes."),
                      field("skip", &T::skip, "What may be left out where a scene does not need it."),
                      field("seed", &T::seed, "Of the random thresholds.")};
  }
};

template <>
struct Fields<Output> {
  static constexpr auto list() {
    return std::tuple{field("fps", &Output::fps, "Frames a second.").above(0),
                      field("duration", &Output::duration, "Seconds.").atLeast(0)};
  }
};

template <>
struct Fields<Camera> {
  static constexpr auto list() {
    using T = Camera;
    return std::tuple{
        field("position", &T::position, "Of the eye, cm.").required(),
        field("target", &T::target, "In the middle of the picture, cm.").required(),
        field("fieldOfView", &T::fieldOfView, "Vertical, degrees.").above(0).atMost(170),
        field("aperture", &T::aperture,
              "Of the lens, cm across: what is not in focus is blurred; in pictures.")
            .atLeast(0),
        field("focus", &T::focus, "Distance that is sharp, cm; left out: that of the target.").above(0)};
  }
};

template <>
struct Fields<Ground> {
  static constexpr auto list() {
    using T = Ground;
    return std::tuple{
        field("kind", &T::kind,
              "studio: a visible floor, grey, that fades into the backdrop; others: a plane."),
        field("colour", &T::colour, "sRGB; left out: the kind's own.").atLeast(0).atMost(1),
        field("second", &T::second, "Other squares, or the grain of wood, sRGB.").atLeast(0).atMost(1),
        field("size", &T::size, "Of a square, width of a plank, cm.").above(0)};
  }
};

template <>
struct Fields<Backdrop> {
  static constexpr auto list() {
    using T = Backdrop;
    return std::tuple{
        field("kind", &T::kind, "environment: the image of the environment."),
        field("colour", &T::colour, "Of a gradient: at the horizon, sRGB.").atLeast(0).atMost(1),
        field("top", &T::top, "Of a gradient: overhead, sRGB.").atLeast(0).atMost(1)};
  }
};

template <>
struct Fields<EnvironmentLight> {
  static constexpr auto list() {
    using T = EnvironmentLight;
    return std::tuple{
        field("image", &T::image,
              "OpenEXR, Radiance .hdr or PNG of all around, twice as wide as high: it lights in place of the "
              "studio's lamps."),
        field("strength", &T::strength, "Factor of its light.").above(0),
        field("turn", &T::turn, "About the vertical, degrees; 0: its middle lies towards +y.")};
  }
};

template <>
struct Fields<PictureStyle> {
  static constexpr auto list() {
    using T = PictureStyle;
    return std::tuple{
        field("surface", &T::surface, "Of the cells, or the level surface of the nodes' potential field."),
        field("ground", &T::ground, "What things stand on."),
        field("backdrop", &T::backdrop, "What is seen where there is nothing."),
        field("environment", &T::environment, "Light from an image.")};
  }
};

template <>
struct Fields<View> {
  static constexpr auto list() {
    using T = View;
    return std::tuple{
        field("camera", &T::camera, "Left out: everything is framed."),
        field("picture", &T::picture, "Ground, backdrop and light of ray-traced pictures."),
        field("hidden", &T::hidden, "Names of parts that are simulated, but not drawn in the window."),
        field("locked", &T::locked, "Names of parts and colliders that clicks in the window pass over.")};
  }
};

template <>
struct Fields<Scene> {
  static constexpr auto list() {
    using T = Scene;
    return std::tuple{field("name", &T::name, "What people call it."),
                      field("materials", &T::materials, "By name."),
                      field("parts", &T::parts, "What there is, in the order of its nodes.").required(),
                      field("glue", &T::glue, "Done in this order."),
                      field("environment", &T::environment, "What acts from outside."),
                      field("tracks", &T::tracks, "Values that vary in time."),
                      field("solver", &T::solver, "How motion is computed."),
                      field("output", &T::output, "What is recorded."),
                      field("view", &T::view, "How it is looked at.")};
  }
};

}  // namespace modeling
