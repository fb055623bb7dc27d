#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/glue/glue.h"
#include "modeling/import/attendance.h"
#include "modeling/scene/scene.h"
#include "modeling/shapes/quality.h"
#include "sim/control/track.h"
#include "sim/network/network.h"
#include "sim/state/settings.h"

/// From the document to what is simulated.
namespace modeling {

/// What acts on a network, and how it is stepped. Tracks name materials and colliders by index.
struct Conditions {
  sim::Environment environment;
  std::vector<sim::Track> tracks;
  sim::Settings settings;  ///< threads: 0, all there are
};

/// The scene's conditions for a network that has these materials (its own, or one that came from a take).
/// Materials are found by name; a track of a material that the network has in several variants becomes
/// several tracks.
Conditions conditionsOf(const Scene& scene, const std::vector<sim::Material>& materials);

struct PartReport {
  std::string name;
  std::size_t nodes = 0;   ///< before gluing
  std::size_t cells = 0;   ///< of the network: without those that gluing dropped
  LatticeQuality quality;  ///< as placed; all zero for a raw network
};

struct BuiltScene {
  Scene scene;  ///< with what files of obstacles hold: what a take is headed by
  sim::Network network;
  Conditions conditions;
  std::vector<PartReport> parts;
  std::vector<GlueReport> glue;
  std::vector<std::string> warnings;  ///< what is allowed, but seldom meant
};

/// Lattices, placement, glue, materials, network. Files are looked for in `folder`; who waits while they are
/// read is told, and can give up. A Problem's place is a path of the scene, such as "parts[2].resolution", or
/// FILE:LINE:COLUMN within a network file.
sim::Result<BuiltScene> build(const Scene& scene, const std::filesystem::path& folder,
                              const Attendance& attendance = {});

}  // namespace modeling
