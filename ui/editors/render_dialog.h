#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>

#include "ui/session/picture_job.h"
#include "ui/session/session.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

class RenderChoices;
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
  QWidget* makeButtons();
  void startPreview();
  void askForFile();
  void poll();
  void showState();
  void showImage();

  Session& session_;
  Viewport& viewport_;
  RenderChoices* choices_ = nullptr;
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
