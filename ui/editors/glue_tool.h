#pragma once

#include <optional>

#include "ui/editors/glue_editing.h"
#include "ui/viewport/tool.h"

namespace ui {

/// Gluing in the viewport: parts are chosen by clicks, what would be glued is drawn as lines, and a click on
/// a line takes it out or puts it back. A box that is dragged round lines keeps the gluing to where those
/// are.
class GlueTool : public Tool {
 public:
  GlueTool(Session& session, GlueEditing& editing) : session_(session), editing_(editing) {}

  QString hint() const override;
  QCursor cursor() const override;
  bool press(Viewport& viewport, const PointerEvent& event) override;
  void move(Viewport& viewport, const PointerEvent& event) override;
  void release(Viewport& viewport, const PointerEvent& event) override;
  void hover(Viewport& viewport, const PointerEvent& event) override;
  bool cancel(Viewport& viewport) override;
  void draw(const Viewport& viewport, Overlay& overlay) override;

 private:
  /// Of part A's coordinates, round the links in the box; nothing where there are none.
  std::optional<modeling::Box> regionIn(const Viewport& viewport, const QRectF& box) const;
  /// The node of part a whose link is under the pointer.
  std::optional<modeling::NodeIndex> linkAt(const Viewport& viewport, const QPointF& pixel) const;
  void drawBox(const std::string& part, const QColor& colour, Overlay& overlay) const;
  void drawRegion(Overlay& overlay) const;
  void drawDragged(const Viewport& viewport, Overlay& overlay) const;
  void drawLinks(Overlay& overlay) const;

  Session& session_;
  GlueEditing& editing_;
  std::string hoveredPart_;
  std::optional<modeling::NodeIndex> hoveredNode_;
  std::optional<QPointF> pressed_;
  std::optional<QRectF> box_;  ///< being dragged, with its corner at the press first
};

}  // namespace ui
