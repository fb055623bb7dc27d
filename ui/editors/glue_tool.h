#pragma once

#include <optional>

#include "ui/editors/glue_editing.h"
#include "ui/viewport/tool.h"

namespace ui {

/// Gluing in the viewport: parts are chosen by clicks, what would be glued is drawn as lines, and a click on
/// a line takes it out or puts it back.
class GlueTool : public Tool {
 public:
  GlueTool(Session& session, GlueEditing& editing) : session_(session), editing_(editing) {}

  QString hint() const override;
  QCursor cursor() const override;
  bool press(Viewport& viewport, const PointerEvent& event) override;
  void move(Viewport&, const PointerEvent&) override {}
  void release(Viewport&, const PointerEvent&) override {}
  void hover(Viewport& viewport, const PointerEvent& event) override;
  void draw(const Viewport& viewport, Overlay& overlay) override;

 private:
  /// The node of part a whose link is under the pointer.
  std::optional<modeling::NodeIndex> linkAt(const Viewport& viewport, const QPointF& pixel) const;
  void drawBox(const std::string& part, const QColor& colour, Overlay& overlay) const;
  void drawRegion(Overlay& overlay) const;
  void drawLinks(Overlay& overlay) const;

  Session& session_;
  GlueEditing& editing_;
  std::string hoveredPart_;
  std::optional<modeling::NodeIndex> hoveredNode_;
};

}  // namespace ui
