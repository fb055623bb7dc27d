#pragma once

#include <QWidget>
#include <optional>

#include "ui/session/picture_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace ui {

class NumberField;
class Session;
class Viewport;

/// What a ray-traced picture is to be like, as a form.
class RenderChoices : public QWidget {
  Q_OBJECT

 public:
  explicit RenderChoices(QWidget* parent);

  bool wantsAllFrames() const;
  /// Rather than the scene's camera.
  bool wantsViewportCamera() const;
  /// Of what the session shows, in full size, without a file to write to. Nothing where nothing is shown.
  std::optional<PictureJob::Order> order(Session& session, const Viewport& viewport) const;

 signals:
  void changed();

 private:
  void addNumbers(QFormLayout& form);
  void addLooks(QFormLayout& form);
  void askForEnvironment();
  modeling::PictureStyle styleFrom(modeling::PictureStyle style) const;

  QComboBox* what_ = nullptr;
  QComboBox* camera_ = nullptr;
  QComboBox* looseNodes_ = nullptr;
  QComboBox* surface_ = nullptr;
  QComboBox* ground_ = nullptr;
  QComboBox* backdrop_ = nullptr;
  QComboBox* light_ = nullptr;
  QString environment_;  ///< image that was chosen
  NumberField* width_ = nullptr;
  NumberField* height_ = nullptr;
  NumberField* samples_ = nullptr;
  NumberField* aperture_ = nullptr;
  NumberField* shutter_ = nullptr;
  QCheckBox* sixteenBit_ = nullptr;
};

}  // namespace ui
