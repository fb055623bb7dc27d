#pragma once

#include "modeling/material/material.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// The colours things have under the chosen colouring.
class Palette {
 public:
  /// Keeps references.
  Palette(const sim::Network& network, const sim::Snapshot& moment, const modeling::Scene& scene,
          const ViewSettings& settings);

  ColourDraw surface(const TopologyDraw& topology) const;
  /// All nodes, or those that nothing holds where they are shown as balls; none of hidden parts.
  NodeDraw nodes(const std::vector<std::uint8_t>& hidden) const;
  std::uint32_t ofNode(sim::NodeIndex node) const;

 private:
  std::uint32_t ofMaterial(sim::MaterialIndex material, bool inside, sim::FragmentId fragment) const;
  std::uint32_t ofFace(const DrawnFace& face) const;

  const sim::Network& network_;
  const sim::Snapshot& moment_;
  const ViewSettings& settings_;
  std::vector<modeling::Look> looks_;
};

}  // namespace ui
