#include "ui/timeline/time_axis.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

/// Left free on both sides, so that the first and the last moment can be seen and caught.
constexpr double kMargin = 12.0;
/// s a pixel: steps of a simulation are not shorter by much.
constexpr double kFinest = 1e-7;

}  // namespace

double TimeAxis::widestScale() const {
  return end_ / std::max(width_ - 2.0 * kMargin, 1.0);
}

void TimeAxis::place(double from, double secondsPerPixel) {
  secondsPerPixel_ = std::clamp(secondsPerPixel, std::min(kFinest, widestScale()), widestScale());
  showsAll_ = secondsPerPixel_ >= widestScale() * (1.0 - 1e-9);
  const double margin = kMargin * secondsPerPixel_;
  const double last = end_ + margin - width_ * secondsPerPixel_;
  from_ = std::clamp(from, -margin, std::max(last, -margin));
  emit changed();
}

void TimeAxis::setWidth(double pixels) {
  if (pixels == width_) return;
  width_ = std::max(pixels, 1.0);
  if (showsAll_) {
    showAll();
  } else {
    place(from_, secondsPerPixel_);
  }
}

void TimeAxis::setEnd(double end) {
  const double wanted = end > 0.0 ? end : 1.0;
  if (wanted == end_) return;
  end_ = wanted;
  if (showsAll_) {
    showAll();
  } else {
    place(from_, secondsPerPixel_);
  }
}

void TimeAxis::zoom(double factor, double x) {
  const double held = timeAt(x);
  const double scale = std::clamp(secondsPerPixel_ * factor, std::min(kFinest, widestScale()), widestScale());
  place(held - x * scale, scale);
}

void TimeAxis::pan(double pixels) {
  place(from_ + pixels * secondsPerPixel_, secondsPerPixel_);
}

void TimeAxis::showAll() {
  place(-kMargin * widestScale(), widestScale());
}

void TimeAxis::show(double from, double to) {
  const double scale = (to - from) / std::max(width_ - 2.0 * kMargin, 1.0);
  place(from - kMargin * scale, scale);
}

double TimeAxis::labelStep(double pixels) const {
  const double least = pixels * secondsPerPixel_;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

QString timeLabel(double time, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 7);
  return QString::number(time, 'f', digits);
}

}  // namespace ui
