#pragma once

#include "modeling/scene/scene.h"
#include "modeling/text/json_fields.h"

/// The fields of how a scene is looked at.
namespace modeling {

/// Ten times as far as things may be, cm.
inline constexpr double kFarthestLook = 10.0 * reachOf(Dimension::length);

template <>
struct Fields<Camera> {
  static constexpr auto list() {
    using T = Camera;
    return std::tuple{
        field("position", &T::position, "Position", "Where the eye is.")
            .required()
            .in(Dimension::length, 1.0)
            .between(-kFarthestLook, kFarthestLook),
        field("target", &T::target, "Looks at", "What is in the middle of the picture.")
            .required()
            .in(Dimension::length, 1.0)
            .between(-kFarthestLook, kFarthestLook),
        field("fieldOfView", &T::fieldOfView, "Field of view", "Vertical angle.")
            .in(Dimension::degrees, 1.0)
            .between(0.1, 170)
            .gauge(),
        field("aperture", &T::aperture, "Aperture",
              "Diameter of the lens: what is not in focus is blurred in pictures; 0: all is sharp.")
            .in(Dimension::length, 0.1)
            .between(0, 1e4),
        field("focus", &T::focus, "Focus", "Distance at which pictures are sharp.")
            .in(Dimension::length, 1.0)
            .absent("the target's")
            .between(1e-3, kFarthestLook)};
  }
};

template <>
struct Fields<Ground> {
  static constexpr auto list() {
    using T = Ground;
    constexpr auto isDrawn = [](const T& ground) {
      return ground.kind == GroundKind::plain || ground.kind == GroundKind::checker ||
             ground.kind == GroundKind::wood;
    };
    constexpr auto hasPattern = [](const T& ground) {
      return ground.kind == GroundKind::checker || ground.kind == GroundKind::wood;
    };
    return std::tuple{
        field(
            "kind", &T::kind, "Ground",
            "studio: a visible floor, grey, that fades into the backdrop; shadow: nothing but the shadows on "
            "it, for putting the picture over another; all but studio and none are a plane under the things "
            "where there is no floor."),
        field("colour", &T::colour, "Colour", "Colour, sRGB.")
            .absent("the kind's own")
            .atLeast(0)
            .atMost(1)
            .where(isDrawn),
        field("second", &T::second, "Second", "Colour of the other squares, or of the grain of wood, sRGB.")
            .absent("the kind's own")
            .atLeast(0)
            .atMost(1)
            .where(hasPattern),
        field("size", &T::size, "Size", "Edge of a square, width of a plank.")
            .in(Dimension::length, 0.5)
            .atLeast(1e-3)
            .where(hasPattern)};
  }
};

template <>
struct Fields<Backdrop> {
  static constexpr auto list() {
    using T = Backdrop;
    return std::tuple{field("kind", &T::kind, "Backdrop", "environment: the image of the environment."),
                      field("colour", &T::colour, "Colour", "Colour, of a gradient at the horizon, sRGB.")
                          .atLeast(0)
                          .atMost(1)
                          .where([](const T& backdrop) {
                            return backdrop.kind == BackdropKind::colour ||
                                   backdrop.kind == BackdropKind::gradient;
                          }),
                      field("top", &T::top, "Overhead", "Colour of a gradient overhead, sRGB.")
                          .atLeast(0)
                          .atMost(1)
                          .where([](const T& backdrop) { return backdrop.kind == BackdropKind::gradient; })};
  }
};

template <>
struct Fields<EnvironmentLight> {
  static constexpr auto list() {
    using T = EnvironmentLight;
    constexpr auto hasImage = [](const T& light) { return !light.image.empty(); };
    return std::tuple{
        field("image", &T::image, "Image",
              "OpenEXR, Radiance .hdr or PNG of all around, twice as wide as high: it lights in place of the "
              "studio's lamps.")
            .file("*.exr *.hdr *.png"),
        field("strength", &T::strength, "Strength", "Factor of its light.")
            .step(0.1)
            .between(1e-6, 1e6)
            .where(hasImage),
        field("turn", &T::turn, "Turn",
              "Turn about the vertical; 0: the middle of the image lies towards +y.")
            .in(Dimension::degrees, 5.0)
            .where(hasImage)};
  }
};

template <>
struct Fields<PictureStyle> {
  static constexpr auto list() {
    using T = PictureStyle;
    return std::tuple{
        field("surface", &T::surface, "Surface",
              "Surface of the cells, or the level surface of the nodes' potential field."),
        field("ground", &T::ground, "Ground in Pictures", "What things stand on."),
        field("backdrop", &T::backdrop, "Backdrop in Pictures", "What is seen where there is nothing."),
        field("environment", &T::environment, "Light in Pictures", "Light from an image.")};
  }
};

template <>
struct Fields<View> {
  static constexpr auto list() {
    using T = View;
    return std::tuple{
        field("camera", &T::camera, "Camera", "From where it is looked at.")
            .present("Looks from a fixed place")
            .absent("everything is framed"),
        field("picture", &T::picture, "Pictures", "Ground, backdrop and light of ray-traced pictures."),
        field("hidden", &T::hidden, "Hidden",
              "Names of parts that are simulated, but not drawn in the window."),
        field("locked", &T::locked, "Locked",
              "Names of parts and colliders that clicks in the window pass over.")};
  }
};

}  // namespace modeling
