#include "ui/timeline/track_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

constexpr double kReach = 7.0;  ///< px: a key is caught from so far
constexpr double kRowMargin = 14.0;

}  // namespace

ValueSpan spanOf(const modeling::SceneTrack& track) {
  ValueSpan span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const modeling::SceneTrackKey& key : track.keys) {
    const sim::Vec3 value = modeling::asVector(key.value);
    for (std::size_t c = 0; c < componentsOf(track.target); ++c) {
      span.least = std::min(span.least, value[static_cast<Eigen::Index>(c)]);
      span.most = std::max(span.most, value[static_cast<Eigen::Index>(c)]);
    }
  }
  if (span.most - span.least < 1e-9 * std::max(std::abs(span.most), 1.0)) {
    const double room = std::max(0.5 * std::abs(span.most), 0.5);
    return {span.least - room, span.most + room};
  }
  return span;
}

double TrackLayout::height() const {
  return tracks_.empty() ? kRowHeight : rowOf(tracks_.size() - 1).bottom();
}

QRectF TrackLayout::rowOf(std::size_t track) const {
  double top = 0.0;
  for (std::size_t before = 0; before < track; ++before)
    top += isExpanded(before) ? kExpandedHeight : kRowHeight;
  return {0.0, top, width_, static_cast<double>(isExpanded(track) ? kExpandedHeight : kRowHeight)};
}

std::optional<std::size_t> TrackLayout::trackAt(double y) const {
  for (std::size_t track = 0; track < tracks_.size(); ++track) {
    const QRectF row = rowOf(track);
    if (y >= row.top() && y < row.bottom()) return track;
  }
  return std::nullopt;
}

double TrackLayout::xOf(double time) const {
  return kTimelineHeader + axis_.xOf(time);
}

ValueSpan TrackLayout::shownSpan(std::size_t track) const {
  return spanOf(steady_ && steady_->track == track ? steady_->before : tracks_[track]);
}

double TrackLayout::yOf(std::size_t track, double value) const {
  const QRectF row = rowOf(track);
  if (!isExpanded(track)) return row.center().y();
  const ValueSpan span = shownSpan(track);
  const double share = (value - span.least) / (span.most - span.least);
  return row.bottom() - kRowMargin - share * (row.height() - 2.0 * kRowMargin);
}

double TrackLayout::valueAtY(std::size_t track, double y) const {
  const QRectF row = rowOf(track);
  const ValueSpan span = shownSpan(track);
  const double share = (row.bottom() - kRowMargin - y) / (row.height() - 2.0 * kRowMargin);
  return span.least + share * (span.most - span.least);
}

QPointF TrackLayout::pointOf(const KeyHandle& handle) const {
  const auto [track, index] = handle.place;
  const modeling::SceneTrackKey& key = tracks_.at(track).keys.at(index);
  const sim::Vec3 value = modeling::asVector(key.value);
  return {xOf(key.time), yOf(track, value[static_cast<Eigen::Index>(handle.component)])};
}

std::size_t TrackLayout::handlesOf(std::size_t track) const {
  return isExpanded(track) ? componentsOf(tracks_[track].target) : 1;
}

std::optional<KeyHandle> TrackLayout::handleAt(const QPointF& at) const {
  const std::optional<std::size_t> track = trackAt(at.y());
  if (!track || at.x() < kTimelineHeader) return std::nullopt;
  std::optional<KeyHandle> nearest;
  double distance = kReach;
  for (std::size_t key = 0; key < tracks_[*track].keys.size(); ++key) {
    for (std::size_t c = 0; c < handlesOf(*track); ++c) {
      const KeyHandle handle{{*track, key}, c};
      const QPointF apart = pointOf(handle) - at;
      const double length = std::max(std::abs(apart.x()), std::abs(apart.y()));
      if (length > distance) continue;
      distance = length;
      nearest = handle;
    }
  }
  return nearest;
}

}  // namespace ui
