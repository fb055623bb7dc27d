#pragma once

#include <QDialog>
#include <QTimer>

#include "ui/session/preflight_run.h"
#include "ui/session/session.h"

class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace ui {

/// What the run will cost, and what looks wrong before it begins. Stays open beside the window; a click on a
/// part with bad cells selects it, and a button moves out what begins inside something.
class PreflightDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PreflightDialog(Session& session, QWidget* parent = nullptr);
  /// Looks again at the scene as it is now.
  void look();
  bool isDone() const { return shown_; }

 private:
  QFormLayout* makeRows();
  void makeParts();
  QDialogButtonBox* makeButtons();
  void tick();
  void noteChange();
  void showResult();
  void showFlight(const modeling::Preflight& flight);
  void showOverlaps(const modeling::Preflight& flight);
  void moveOut();
  void moveOn();
  void showProblem(const sim::Problem& problem);
  void showParts();

  Session& session_;
  PreflightRun run_;
  QTimer timer_;
  bool shown_ = false;
  std::shared_ptr<const Preview> preview_;
  QLabel* verdict_;
  QProgressBar* busy_;
  QLabel* size_;
  QLabel* step_;
  QLabel* clock_;
  QLabel* second_;
  QLabel* memory_;
  QLabel* take_;
  QLabel* breaking_;
  QLabel* overlaps_;  ///< a line each
  QPushButton* moveOut_;
  std::vector<modeling::Overlap> found_;  ///< what the lines are about
  int movesLeft_ = 0;  ///< what moves out of one thing may come into the next, and is moved on
  double depthMoved_ =
      0.0;  ///< cm: all depths before the parts were moved, until the next look; zero: they were not
  QTreeWidget* parts_;
};

/// "3 minutes", "1.5 hours": as exact as anybody wants to know.
QString roughTime(double seconds);
QString roughSize(double bytes);

}  // namespace ui
