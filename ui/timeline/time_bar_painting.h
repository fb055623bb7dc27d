#pragma once

#include <QFont>
#include <QSize>
#include <QString>
#include <optional>
#include <vector>

#include "ui/session/playback.h"

class QPainter;

namespace ui {

class TimeAxis;

/// What the ruler and the take under it look like at a moment.
struct TimeBarPicture {
  const TimeAxis& axis;
  const std::vector<FrameNote>& notes;       ///< of the frames that are recorded
  const std::vector<std::uint32_t>& breaks;  ///< bonds that broke, by pixel of the axis
  std::uint32_t mostBreaks = 0;              ///< of all frames
  QString name;                              ///< of the take
  QString about;                             ///< how long it is
  bool stale = false;                        ///< the scene has been changed since
  bool nothingToSimulate = false;
  std::optional<Playback::Range> loop;
  bool loops = false;
  double cursorX = 0.0;  ///< px
  QSize size;            ///< px
  QFont font;

  double xOf(double time) const;
};

/// Draws what lies within `dirty`.
void paintTimeBar(QPainter& painter, const TimeBarPicture& picture, const QRect& dirty);

}  // namespace ui
