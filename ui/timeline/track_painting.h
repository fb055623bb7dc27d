#pragma once

#include <QFont>
#include <QSize>
#include <optional>

#include "ui/timeline/track_layout.h"

class QPainter;

namespace ui {

class Selection;

/// What the rows of the tracks look like at a moment.
struct TrackPicture {
  const TrackLayout& layout;
  const Selection& selection;
  std::optional<KeyPlace> chosen;  ///< the selected key
  double cursorTime = 0.0;         ///< s: values of this time stand beside the names
  double cursorX = 0.0;            ///< px
  QSize size;                      ///< px, of all rows
  QFont font;
};

/// Draws what lies within `dirty`.
void paintTracks(QPainter& painter, const TrackPicture& picture, const QRect& dirty);

}  // namespace ui
