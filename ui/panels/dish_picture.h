#pragma once

#include <QIcon>
#include <QRectF>

#include "ui/kinds/part_presets.h"

class QPainter;

namespace ui {

/// The silhouette of a body of revolution, seen from the side, with a rim where it is open; fills the
/// rectangle.
void paintDish(QPainter& painter, const modeling::RevolutionShape& shape, const QRectF& within,
               const QColor& line, const QColor& fill);
/// Of one of the family of icons, in the theme's colours.
QIcon dishIcon(ProfilePreset preset);

}  // namespace ui
