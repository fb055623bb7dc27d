#pragma once

#include <QRectF>
#include <QSizeF>

#include "ui/viewport/draw_data.h"
#include "ui/viewport/gl.h"

class QPainter;

/// What stands over the picture of the viewport besides tools and axes. Places are in logical pixels.
namespace ui {

class Overlay;

/// What colours mean, in the lower right corner.
void paintLegends(QPainter& painter, const QSizeF& size, const DrawData& data);
/// What drawing costs, in the upper left corner. `longestWait` of the window's thread, ms.
void paintStatistics(QPainter& painter, const DrawData& data, const DrawStatistics& drawing,
                     double longestWait);
/// Outlines of those that only push.
void paintInvisibleColliders(Overlay& overlay, const DrawData& data);
/// The frame that is being drawn around things to select; nothing where it is empty.
void paintBand(QPainter& painter, const QRectF& band);

}  // namespace ui
