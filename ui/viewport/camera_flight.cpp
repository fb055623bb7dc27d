#include "ui/viewport/camera_flight.h"

#include <cmath>
#include <numbers>

namespace ui {
namespace {

/// Long enough to see which way it turns, too short to wait for.
constexpr int kMilliseconds = 180;

}  // namespace

CameraFlight::CameraFlight(ViewCamera& camera, QObject* parent) : QVariantAnimation(parent), camera_(camera) {
  setStartValue(0.0);
  setEndValue(1.0);
  setDuration(kMilliseconds);
  setEasingCurve(QEasingCurve::InOutCubic);
}

void CameraFlight::flyTo(const ViewCamera& end) {
  stop();
  start_ = camera_;
  end_ = end;
  start();
}

void CameraFlight::updateCurrentValue(const QVariant& value) {
  if (state() != Running) return;
  const double share = value.toDouble();
  if (share >= 1.0) {
    camera_ = end_;
  } else {
    const double turn = std::remainder(end_.azimuth() - start_.azimuth(), 2.0 * std::numbers::pi);
    const double lift = end_.elevation() - start_.elevation();
    camera_ = end_;
    camera_.look(start_.target() + share * (end_.target() - start_.target()),
                 start_.distance() * std::pow(end_.distance() / start_.distance(), share),
                 start_.azimuth() + share * turn, start_.elevation() + share * lift);
  }
  emit moved();
}

}  // namespace ui
