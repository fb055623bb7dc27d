#pragma once

#include <QColor>
#include <QString>

#include "sim/base/types.h"

namespace ui {

/// What is drawn over the picture of the viewport: handles of tools, pairs of glue, labels. Points are of the
/// world (cm), widths in logical pixels. Later things cover earlier ones.
class Overlay {
 public:
  virtual ~Overlay() = default;
  virtual void line(const sim::Vec3& from, const sim::Vec3& to, const QColor& colour, double width = 1.5) = 0;
  virtual void point(const sim::Vec3& at, const QColor& colour, double diameter = 8.0) = 0;
  virtual void text(const sim::Vec3& at, const QString& text, const QColor& colour) = 0;
};

}  // namespace ui
