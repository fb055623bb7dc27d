#pragma once

#include <array>

#include "modeling/scene/collider_fields.h"
#include "modeling/scene/material_fields.h"
#include "modeling/scene/shape_fields.h"
#include "modeling/scene/view_fields.h"

/// The fields of a scene, struct by struct. What stands here and in the headers above is read, written, in
/// the schema, in the tables of docs/formats.md and in the forms of the window (docs/how-to/add-a-field.md).
namespace modeling {

/// More nodes than this no scene has (modeling/shapes/resolution.h).
inline constexpr double kMostNodes = static_cast<double>(kMaxLatticeNodes);

/// No track takes more than this (keyRange, which knows what is driven).
inline constexpr double kMostOfKey = reachOf(Dimension::acceleration);

template <>
struct Fields<Placement> {
  static constexpr auto list() {
    using T = Placement;
    return std::tuple{
        field("position", &T::position, "Position", "Where the part's origin is.").in(Dimension::length, 0.5),
        field("rotation", &T::rotation, "Rotation",
              "Angles about the fixed axes x, then y, then z; or a quaternion [w, x, y, z].")
            .in(Dimension::degrees, 5.0),
        field("scale", &T::scale, "Scale", "One factor, or one an axis.").step(0.05).between(1e-6, 1e6)};
  }
};

template <>
struct Fields<Box> {
  static constexpr auto list() {
    return std::tuple{field("min", &Box::min, "From", "Lower corner.").required().in(Dimension::length, 0.2),
                      field("max", &Box::max, "To", "Upper corner.").required().in(Dimension::length, 0.2)};
  }
};

template <>
struct Fields<Part> {
  static constexpr auto list() {
    using T = Part;
    return std::tuple{
        field("name", &T::name, "Name", "Differs from every other part's.").required(),
        field("material", &T::material, "Material", "A material's name; only a network may leave it out."),
        field("worldFromPart", &T::worldFromPart, "Placement", "Scale, then rotation, then position."),
        field("velocity", &T::velocity, "Velocity", "Velocity at the start.").in(Dimension::velocity, 10.0),
        field("angularVelocity", &T::angularVelocity, "Turning",
              "Angular velocity at the start, about the part's centre of mass.")
            .in(Dimension::angularVelocity, 0.5),
        field("hold", &T::hold, "Held",
              "Boxes in part coordinates, before scaling: nodes inside keep the velocity they start with.")
            .in(Dimension::length, 0.1)};
  }
};

template <>
struct Fields<Gluing> {
  static constexpr auto list() {
    using T = Gluing;
    return std::tuple{
        field("a", &T::a, "Part", "The part whose nodes are replaced.").required(),
        field("b", &T::b, "Glued to", "The part it is glued to.").required(),
        field("reach", &T::reach, "Reach",
              "Nodes of a this near to a node of b are glued; not read where pairs are given.")
            .in(Dimension::length, 0.05)
            .atLeast(0),
        field("pairs", &T::pairs, "Pairs",
              "Where given, exactly these pairs of a node of a and one of b are glued, counted from 0 within "
              "the parts.")
            .between(0, kMostNodes),
        field("exclude", &T::exclude, "Taken out", "Nodes of a that stay free.").between(0, kMostNodes),
        field("region", &T::region, "Only Within",
              "Box in coordinates of part a: only its nodes inside are glued.")
            .present("Limited to a box")
            .absent("everywhere")};
  }
};

template <>
struct Fields<SceneEnvironment> {
  static constexpr auto list() {
    using T = SceneEnvironment;
    return std::tuple{field("gravity", &T::gravity, "Gravity", "Acceleration of everything that is not held.")
                          .in(Dimension::acceleration, 20.0),
                      field("colliders", &T::colliders, "Colliders", "Immovable objects.")};
  }
};

template <>
struct Fields<SceneTrack> {
  static constexpr auto list() {
    using T = SceneTrack;
    return std::tuple{
        field(
            "target", &T::target, "Drives",
            "gravity, gravity.scale, stiffness.scale[.MATERIAL], damping.scale[.MATERIAL], "
            "collider.NAME.position or collider.NAME.rotation (a rotation vector in degrees). Scales of one "
            "target multiply; of several gravity tracks the last one that has begun counts.")
            .required(),
        field("keys", &T::keys, "Keys", "Pairs of time in seconds and value, in order of time.")
            .required()
            .in(Dimension::number, 0.1)
            .between(-kMostOfKey, kMostOfKey),
        field("interpolation", &T::interpolation, "Between keys",
              "step holds a key's value until the next; smooth eases at both.")};
  }
};

template <>
struct Fields<Contact> {
  static constexpr auto list() {
    using T = Contact;
    return std::tuple{
        field("kind", &T::kind, "What meets",
              "What repels between fragments: surfaces, where they are drawn; or nodes, a cell apart, as in "
              "the "
              "paper. Implicit methods always use nodes."),
        field("between", &T::between, "Between fragments", "Different fragments repel."),
        field("self", &T::self, "Within a fragment", "Nodes of one fragment repel too."),
        field("length", &T::length, "Natural length",
              "Natural length of a contact of nodes: nearest is safe where things break."),
        field("stiffnessScale", &T::stiffnessScale, "Stiffness", "Stiffness relative to the weaker node's.")
            .step(0.05)
            .between(1e-6, 1e6),
        field("dampingRatio", &T::dampingRatio, "Damping", "Damping relative to critical.")
            .step(0.05)
            .between(0, 100),
        field("friction", &T::friction, "Friction", "Lateral force relative to the push.")
            .step(0.05)
            .between(0, 100)};
  }
};

template <>
struct Fields<sim::SkipSettings> {
  static constexpr std::string_view kSince = "November 2026";
  static constexpr std::string_view kAlways =
      "what needs no computing is always left out, with the same bits";
  static constexpr std::array kRetired{
      RetiredKey{"contactSearch", kSince, kAlways}, RetiredKey{"labelling", kSince, kAlways},
      RetiredKey{"recording", kSince, kAlways},     RetiredKey{"thresholds", kSince, kAlways},
      RetiredKey{"damping", kSince, kAlways},       RetiredKey{"ledger", kSince, kAlways}};

  static constexpr auto list() {
    using T = sim::SkipSettings;
    return std::tuple{
        field("sleep", &T::sleep, "Fragments at rest", "Fragments at rest, until something wakes them."),
        field("rigid", &T::rigid, "Deformation in free flight",
              "Deformation of fragments that fly freely and unstrained.")};
  }
};

template <>
struct Fields<Solver> {
  static constexpr std::array kRetired{
      RetiredKey{"precision", "November 2026", "forces are always computed in double precision"}};

  static constexpr auto list() {
    using T = Solver;
    return std::tuple{
        field("method", &T::method, "Method", "How the equations of motion are stepped."),
        field("step", &T::step, "Step",
              "A time; \"auto\": as long as is stable; or an object with tolerance: the automatic step, "
              "shortened to keep to this error of strain.")
            .in(Dimension::time, 1e-6)
            .logarithmic()
            .absent("auto")
            .between(1e-12, 1),
        field("safety", &T::safety, "Safety", "Share of the largest stable step.")
            .step(0.05)
            .between(1e-4, 0.9)
            .gauge(),
        field("contact", &T::contact, "Contact", "What happens between things that touch."),
        field("skip", &T::skip, "Leave Out What Is Not Needed",
              "What may be left out where a scene does not need it; false: the same is computed in full, to "
              "compare."),
        field("seed", &T::seed, "Seed",
              "Seed of the random thresholds: with another one things break otherwise.")
            .between(0, 0x1p64)};
  }
};

template <>
struct Fields<Output> {
  static constexpr auto list() {
    using T = Output;
    return std::tuple{field("fps", &T::fps, "Frame rate", "Frames recorded a second.")
                          .in(Dimension::rate, 1.0)
                          .between(1e-3, 1e6),
                      field("duration", &T::duration, "Duration", "How long it is simulated.")
                          .in(Dimension::time, 0.1)
                          .atLeast(0)};
  }
};

template <>
struct Fields<Scene> {
  static constexpr auto list() {
    using T = Scene;
    return std::tuple{
        field("name", &T::name, "Name", "What people call it."),
        field("materials", &T::materials, "Materials", "What the parts are made of, by name."),
        field("parts", &T::parts, "Parts", "What there is, in the order of its nodes.").required(),
        field("glue", &T::glue, "Glue", "Gluings, done in this order."),
        field("environment", &T::environment, "Surroundings", "What acts from outside."),
        field("tracks", &T::tracks, "Tracks", "Values that vary in time."),
        field("solver", &T::solver, "Solver", "How motion is computed."),
        field("output", &T::output, "Recording", "What is recorded."),
        field("view", &T::view, "View", "How it is looked at.")};
  }
};

}  // namespace modeling
