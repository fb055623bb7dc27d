#pragma once

#include <QObject>

#include "ui/session/session.h"

class QAction;

namespace ui {

class GlueEditing;
class Viewport;

/// What starts and ends the editors: points of the selected part (Tab), glue, the tuning of thresholds, and
/// ray-traced pictures.
class EditorActions : public QObject {
  Q_OBJECT

 public:
  EditorActions(Session& session, Viewport& viewport, QObject* parent);

  QAction* editPoints() { return editPoints_; }
  QAction* glue() { return glue_; }
  QAction* tuneThreshold() { return tuneThreshold_; }
  QAction* render() { return render_; }
  GlueEditing& glueEditing() { return *gluing_; }

  void openThresholdDialog(std::size_t material);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  /// The selected part is drawn by its profile.
  void profileWanted();

 private:
  QAction* makeAction(const QString& icon, const QString& text, const QString& tip, const QKeySequence& key);
  void togglePoints();
  void toggleGlue(bool on);
  void toolChanged();
  void show();
  const modeling::Part* selectedPart() const;

  Session& session_;
  Viewport& viewport_;
  GlueEditing* gluing_ = nullptr;
  QAction* editPoints_ = nullptr;
  QAction* glue_ = nullptr;
  QAction* tuneThreshold_ = nullptr;
  QAction* render_ = nullptr;
};

}  // namespace ui
