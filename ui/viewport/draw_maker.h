#pragma once

#include <functional>

#include "sim/surface/surface_mesh.h"
#include "ui/viewport/draw_data.h"

namespace ui {

/// Makes draw data, and keeps from one moment to the next what did not change. Used by one thread.
class DrawMaker {
 public:
  /// `cancelled`: what is asked for is out of date; the result may then lack the level surface.
  DrawData make(const Shown& shown, const ViewSettings& settings, const std::function<bool()>& cancelled);

 private:
  bool isNewTopology(const DrawData& data, const std::vector<std::uint8_t>& hidden) const;
  void addColours(DrawData& data, bool newTopology);
  void addMotion(DrawData& data, bool newTopology);
  void addLevel(DrawData& data, const std::function<bool()>& cancelled);

  std::shared_ptr<const sim::Network> network_;  ///< of surface_
  std::unique_ptr<sim::SurfaceBuilder> surface_;
  std::vector<std::uint8_t> hidden_;
  std::vector<modeling::Look> looks_;
  DrawData last_;
};

}  // namespace ui
