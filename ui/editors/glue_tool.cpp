#include "ui/editors/glue_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

using modeling::Vec3;

constexpr double kLinkDistance = 7.0;   ///< logical pixels
constexpr double kDragDistance = 4.0;   ///< likewise: less is a click
constexpr double kRegionMargin = 0.01;  ///< cm: much less than between two nodes

QString tr(const char* text) {
  return QCoreApplication::translate("glue tool", text);
}

double distanceToSegment(const QPointF& point, const QPointF& from, const QPointF& to) {
  const QPointF way = to - from;
  const double squared = QPointF::dotProduct(way, way);
  const double share =
      squared > 0.0 ? std::clamp(QPointF::dotProduct(point - from, way) / squared, 0.0, 1.0) : 0.0;
  const QPointF away = point - from - share * way;
  return std::hypot(away.x(), away.y());
}

/// Edges of a box, from corners counted by bits.
void drawEdges(const std::array<Vec3, 8>& corners, const QColor& colour, Overlay& overlay) {
  for (std::size_t i = 0; i < 8; ++i)
    for (const std::size_t bit : {1U, 2U, 4U})
      if ((i & bit) == 0) overlay.line(corners[i], corners[i | bit], colour, 1.5);
}

}  // namespace

QString GlueTool::hint() const {
  switch (editing_.stage()) {
    case GlueEditing::Stage::chooseA:
      return tr("Click the part to glue, such as a handle; Esc ends");
    case GlueEditing::Stage::chooseB:
      return tr("Click the part to glue it to, such as a body; Esc ends");
    case GlueEditing::Stage::adjust:
      return tr("Click a line to take it out or put it back; drag a box round those to keep; Esc ends");
    case GlueEditing::Stage::off:
      break;
  }
  return {};
}

QCursor GlueTool::cursor() const {
  return !hoveredPart_.empty() || hoveredNode_ ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

std::optional<modeling::NodeIndex> GlueTool::linkAt(const Viewport& viewport, const QPointF& pixel) const {
  const auto& outcome = editing_.outcome();
  if (editing_.stage() != GlueEditing::Stage::adjust || !outcome) return std::nullopt;
  std::optional<modeling::NodeIndex> best;
  double nearest = kLinkDistance;
  for (const auto* links : {&outcome->links, &outcome->freed})
    for (const GlueLink& link : *links) {
      const auto from = viewport.project(link.atA);
      const auto to = viewport.project(link.atB);
      if (!from || !to) continue;
      const double here = distanceToSegment(pixel, *from, *to);
      if (here >= nearest) continue;
      nearest = here;
      best = link.a;
    }
  return best;
}

bool GlueTool::press(Viewport& viewport, const PointerEvent& event) {
  if (editing_.stage() == GlueEditing::Stage::adjust) {
    const auto node = linkAt(viewport, event.position);
    if (node) {
      editing_.toggle(*node);
    } else {
      pressed_ = event.position;
    }
    viewport.update();
    return true;
  }
  const Pick pick = viewport.pickAt(event.position);
  if (!pick.item || pick.item->kind != ItemKind::part) return true;
  const auto& parts = session_.document().scene().parts;
  if (pick.item->index < parts.size()) editing_.choose(parts[pick.item->index].name);
  hoveredPart_.clear();
  viewport.update();
  return true;
}

void GlueTool::move(Viewport& viewport, const PointerEvent& event) {
  if (!pressed_) return;
  if (!box_ && (event.position - *pressed_).manhattanLength() < kDragDistance) return;
  box_ = QRectF(*pressed_, event.position);
  viewport.update();
}

void GlueTool::release(Viewport& viewport, const PointerEvent&) {
  pressed_.reset();
  if (!box_) return;
  if (const auto region = regionIn(viewport, box_->normalized())) editing_.setRegion(region);
  box_.reset();
  viewport.update();
}

bool GlueTool::cancel(Viewport& viewport) {
  pressed_.reset();
  if (!std::exchange(box_, std::nullopt)) return false;
  viewport.update();
  return true;
}

std::optional<modeling::Box> GlueTool::regionIn(const Viewport& viewport, const QRectF& box) const {
  const auto& outcome = editing_.outcome();
  const auto& parts = session_.document().scene().parts;
  const auto part = std::find_if(parts.begin(), parts.end(),
                                 [&](const modeling::Part& one) { return one.name == editing_.gluing().a; });
  if (!outcome || part == parts.end()) return std::nullopt;
  const Eigen::Affine3d partFromWorld = part->worldFromPart.worldFromPart().inverse();
  Eigen::AlignedBox3d held;
  for (const auto* links : {&outcome->links, &outcome->freed}) {
    for (const GlueLink& link : *links) {
      const auto there = viewport.project(link.atA);
      if (there && box.contains(*there)) held.extend(partFromWorld * link.atA);
    }
  }
  if (held.isEmpty()) return std::nullopt;
  // Nodes on its faces are meant to be inside, whatever the last bit says.
  const Vec3 margin = Vec3::Constant(kRegionMargin);
  return modeling::Box{held.min() - margin, held.max() + margin};
}

void GlueTool::hover(Viewport& viewport, const PointerEvent& event) {
  hoveredPart_.clear();
  hoveredNode_ = linkAt(viewport, event.position);
  const auto stage = editing_.stage();
  if (stage == GlueEditing::Stage::chooseA || stage == GlueEditing::Stage::chooseB) {
    const Pick pick = viewport.pickAt(event.position);
    const auto& parts = session_.document().scene().parts;
    if (pick.item && pick.item->kind == ItemKind::part && pick.item->index < parts.size())
      hoveredPart_ = parts[pick.item->index].name;
  }
  viewport.update();
}

void GlueTool::drawBox(const std::string& part, const QColor& colour, Overlay& overlay) const {
  const Preview& preview = *session_.preview();
  if (!preview.built || !preview.rest) return;
  const sim::Network& network = preview.built->network;
  const auto name = std::find(network.partNames.begin(), network.partNames.end(), part);
  const auto index = static_cast<std::size_t>(name - network.partNames.begin());
  Eigen::AlignedBox3d box;
  for (std::size_t node = 0; node < network.nodeParts.size(); ++node)
    if (network.nodeParts[node] == index) box.extend(preview.rest->positions[node]);
  if (box.isEmpty()) return;
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i)
    corners[i] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  drawEdges(corners, colour, overlay);
  overlay.text(corners[7], QString::fromStdString(part), colour);
}

void GlueTool::drawRegion(Overlay& overlay) const {
  const modeling::Gluing& gluing = editing_.gluing();
  if (!gluing.region) return;
  for (const modeling::Part& part : session_.document().scene().parts) {
    if (part.name != gluing.a) continue;
    const Eigen::Affine3d worldFromPart = part.worldFromPart.worldFromPart();
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
      for (Eigen::Index k = 0; k < 3; ++k)
        corners[i][k] = (i >> k) & 1U ? gluing.region->max[k] : gluing.region->min[k];
    for (Vec3& corner : corners) corner = worldFromPart * corner;
    drawEdges(corners, Theme::instance().colours().good, overlay);
  }
}

/// The overlay draws lines in space: this rectangle is one right before the eye.
void GlueTool::drawDragged(const Viewport& viewport, Overlay& overlay) const {
  const std::array<QPointF, 4> corners{box_->topLeft(), box_->topRight(), box_->bottomRight(),
                                       box_->bottomLeft()};
  const auto inSpace = [&](const QPointF& pixel) {
    const Ray ray = viewport.rayThrough(pixel);
    return Vec3(ray.origin + viewport.camera().distance() * ray.direction);
  };
  for (std::size_t i = 0; i < 4; ++i)
    overlay.line(inSpace(corners[i]), inSpace(corners[(i + 1) % 4]), Theme::instance().colours().accent, 1.2);
}

void GlueTool::drawLinks(Overlay& overlay) const {
  const Colours& colours = Theme::instance().colours();
  const GlueOutcome& outcome = *editing_.outcome();
  for (const GlueLink& link : outcome.freed) {
    const bool isHovered = hoveredNode_ == link.a;
    overlay.line(link.atA, link.atB, colours.dimText, isHovered ? 3.0 : 1.0);
    overlay.point(link.atA, colours.dimText, 5.0);
  }
  for (const GlueLink& link : outcome.links) {
    const bool isHovered = hoveredNode_ == link.a;
    const QColor colour = isHovered ? colours.bad : colours.warning;
    overlay.line(link.atA, link.atB, colour, isHovered ? 3.5 : 2.0);
    overlay.point(link.atA, colour, isHovered ? 8.0 : 6.0);
    overlay.point(link.atB, colours.accent, 5.0);
  }
  if (!outcome.nearest) return;
  const GlueLink& nearest = *outcome.nearest;
  overlay.line(nearest.atA, nearest.atB, colours.bad, 2.5);
  overlay.point(nearest.atA, colours.bad);
  overlay.point(nearest.atB, colours.bad);
  overlay.text(0.5 * (nearest.atA + nearest.atB),
               tr("nearest: %1 cm apart").arg(nearest.distance(), 0, 'g', 3), colours.bad);
}

void GlueTool::draw(const Viewport& viewport, Overlay& overlay) {
  if (box_) drawDragged(viewport, overlay);
  const Colours& colours = Theme::instance().colours();
  const auto stage = editing_.stage();
  if (stage == GlueEditing::Stage::chooseB) drawBox(editing_.gluing().a, colours.accent, overlay);
  if (!hoveredPart_.empty() && stage != GlueEditing::Stage::adjust && hoveredPart_ != editing_.gluing().a)
    drawBox(hoveredPart_, colours.warning, overlay);
  if (stage != GlueEditing::Stage::adjust) return;
  drawRegion(overlay);
  if (editing_.outcome()) drawLinks(overlay);
}

}  // namespace ui
