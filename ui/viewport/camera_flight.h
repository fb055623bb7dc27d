#pragma once

#include <QVariantAnimation>

#include "ui/viewport/view_camera.h"

namespace ui {

/// A short, smooth way of the camera to another view.
class CameraFlight : public QVariantAnimation {
  Q_OBJECT

 public:
  CameraFlight(ViewCamera& camera, QObject* parent);

  void flyTo(const ViewCamera& end);

 signals:
  void moved();

 protected:
  void updateCurrentValue(const QVariant& value) override;

 private:
  ViewCamera& camera_;
  ViewCamera start_;
  ViewCamera end_;
};

}  // namespace ui
