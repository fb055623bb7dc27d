#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>
#include <set>
#include <vector>

#include "modeling/scene/tracks.h"

namespace ui {

class TimeAxis;

/// A key: the index of its track in the scene, and its own in the track.
struct KeyPlace {
  std::size_t track = 0;
  std::size_t key = 0;
  bool operator==(const KeyPlace&) const = default;
};

/// The diamond of a key; of a vector there is one a component.
struct KeyHandle {
  KeyPlace place;
  std::size_t component = 0;
};

/// The values that an expanded row shows from its lower to its upper end.
struct ValueSpan {
  double least = 0.0;
  double most = 1.0;
};
/// From the least to the greatest of all components of all keys; wider where they are all the same.
ValueSpan spanOf(const modeling::SceneTrack& track);

/// Where tracks and their keys are in the rows of the timeline, in logical pixels. Made anew wherever it is
/// needed: it refers to what it is given.
class TrackLayout {
 public:
  /// Expanded tracks show their curves. `steady`, where it is given, is a track whose keys are being dragged,
  /// as it was before: its scale stands still, so that the key stays under the pointer.
  struct Steady {
    std::size_t track = 0;
    const modeling::SceneTrack& before;
  };
  TrackLayout(const std::vector<modeling::SceneTrack>& tracks, const std::set<std::size_t>& expanded,
              const TimeAxis& axis, double width, const std::optional<Steady>& steady)
      : tracks_(tracks), expanded_(expanded), axis_(axis), width_(width), steady_(steady) {}

  const std::vector<modeling::SceneTrack>& tracks() const { return tracks_; }
  const TimeAxis& axis() const { return axis_; }
  double width() const { return width_; }
  bool isExpanded(std::size_t track) const { return expanded_.contains(track); }
  double height() const;
  QRectF rowOf(std::size_t track) const;
  std::optional<std::size_t> trackAt(double y) const;
  double xOf(double time) const;
  double yOf(std::size_t track, double value) const;
  double valueAtY(std::size_t track, double y) const;
  QPointF pointOf(const KeyHandle& handle) const;
  /// The one that can be caught from there.
  std::optional<KeyHandle> handleAt(const QPointF& at) const;
  /// How many handles each key of a track has.
  std::size_t handlesOf(std::size_t track) const;

  static constexpr int kRowHeight = 28;        ///< of a row that is closed
  static constexpr int kExpandedHeight = 104;  ///< of one that shows its curve

 private:
  ValueSpan shownSpan(std::size_t track) const;

  const std::vector<modeling::SceneTrack>& tracks_;
  const std::set<std::size_t>& expanded_;
  const TimeAxis& axis_;
  double width_;
  std::optional<Steady> steady_;
};

}  // namespace ui
