#pragma once

#include <QDialog>
#include <QTimer>
#include <memory>

#include "ui/editors/calibration_run.h"
#include "ui/session/session.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

class CalibrationChart;
class NumberField;

/// Tunes the threshold of a material as the paper did: small cylinders are dropped, the results are plotted
/// as they come, and the threshold at which they break well is offered.
class ThresholdDialog : public QDialog {
  Q_OBJECT

 public:
  /// Of that material of the scene.
  ThresholdDialog(Session& session, std::size_t material, QWidget* parent);

  void start();
  void use();
  const CalibrationProgress& progress() const { return progress_; }

 private:
  QWidget* makeSettings(std::size_t material);
  QWidget* makeButtons();
  void listMaterials();
  bool isThere(const std::string& name) const;
  const modeling::SceneMaterial* material() const;
  void proposeCellSize();
  void poll();
  void showState();
  QString stateText() const;

  Session& session_;
  QComboBox* material_ = nullptr;
  NumberField* speed_ = nullptr;
  NumberField* cellSize_ = nullptr;
  CalibrationChart* chart_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* busy_ = nullptr;
  QPushButton* start_ = nullptr;
  QPushButton* use_ = nullptr;
  std::string tuned_;  ///< the material the samples are of
  CalibrationProgress progress_;
  std::unique_ptr<CalibrationRun> run_;
  QTimer timer_;
};

}  // namespace ui
