#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/session/sample_run.h"

namespace ui {

/// A small film of what a material does when it hits a rod, slowed down; computed anew a moment after the
/// material has changed, and only while it can be seen.
class SamplePreview : public QWidget {
  Q_OBJECT

 public:
  explicit SamplePreview(QWidget* parent = nullptr);
  void setMaterial(const modeling::Material& material);
  const SampleRun::View& view() const { return view_; }
  QSize sizeHint() const override { return {220, 150}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void start();
  void tick();
  void paintMesh(QPainter& painter, const sim::SurfaceMesh& mesh) const;
  void paintRod(QPainter& painter) const;
  QString caption() const;

  modeling::Material material_;
  SampleRun run_;
  SampleRun::View view_;
  QTimer settling_;  ///< until the material has stopped changing
  QTimer frames_;
  int frame_ = 0;
};

}  // namespace ui
