#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>
#include <optional>

#include "ui/session/picture_job.h"
#include "ui/session/session.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace ui {

class NumberField;
class Viewport;

/// Ray-traced pictures of what the window shows: a live preview of the choices, then a still, numbered
/// pictures or a film in a file, drawn while the window goes on.
class RenderDialog : public QDialog {
  Q_OBJECT

 public:
  RenderDialog(Session& session, Viewport& viewport, QWidget* parent);

  /// Draws into the file; without one only the preview is drawn.
  void render(const std::filesystem::path& out);
  bool isRendering() const { return rendering_; }
  /// What is drawn, or was drawn last.
  const PictureJob::View& view() const { return view_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeChoices();
  QComboBox* combo(const QString& name, const QStringList& items);
  void addStyle(QFormLayout& form);
  void askForEnvironment();
  modeling::PictureStyle styleFrom(modeling::PictureStyle style) const;
  QWidget* makeButtons();
  NumberField* numberField(const QString& name, double least, double most, double value, bool whole,
                           const QString& tip);
  std::optional<PictureJob::Order> order() const;
  void startPreview();
  void askForFile();
  void poll();
  void showState();
  void showImage();

  Session& session_;
  Viewport& viewport_;
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
  QLabel* picture_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* render_ = nullptr;
  std::unique_ptr<PictureJob> job_;
  PictureJob::View view_;
  bool rendering_ = false;
  bool stopped_ = false;
  QString file_;
  QTimer timer_;
  QTimer again_;  ///< begins the preview anew once choices have not changed for a moment
};

}  // namespace ui
