#pragma once

#include <QWidget>
#include <optional>

#include "ui/editors/profile_model.h"
#include "ui/editors/profile_view.h"

namespace ui {

/// The drawing of a profile, and the pointer and keys on it. Knows no document: what is done is told by
/// edited(), and shown when the model comes back.
class ProfileCanvas : public QWidget {
  Q_OBJECT

 public:
  enum class Mode { select, insert };

  explicit ProfileCanvas(QWidget* parent = nullptr);

  /// Nothing: no part to draw. Keeps what is selected where it is still there.
  void setModel(std::optional<ProfileModel> model);
  const std::optional<ProfileModel>& model() const { return model_; }
  const ControlSet& selected() const { return selected_; }
  void setSelected(ControlSet controls);
  Mode mode() const { return mode_; }
  void setMode(Mode mode);
  bool snaps() const { return snaps_; }
  void setSnaps(bool snaps) { snaps_ = snaps; }
  const ProfileView& view() const { return view_; }
  void frame();

  /// One change as one step of the history.
  void apply(const QString& name, const std::function<sim::Status(ProfileModel&)>& change);
  void deleteSelected();
  void smoothSelected();
  void cornerSelected();
  void straightenSelected();

  QSize sizeHint() const override { return {560, 340}; }
  QSize minimumSizeHint() const override { return {260, 160}; }

 signals:
  /// Changes with the same gesture (not "") are one step.
  void edited(const QString& name, const modeling::RevolutionShape& shape, const QString& gesture);
  void gestureEnded();
  void selectionChanged();
  void modeChanged();
  /// Why something was not done; empty: no more.
  void refused(const QString& why);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { none, waiting, controls, box, pan };
  struct CurvePlace {
    ProfileSide side = ProfileSide::outside;
    std::size_t segment = 0;
    double t = 0.0;
  };

  std::optional<ControlId> controlAt(const QPointF& pixel) const;
  std::optional<CurvePlace> curveAt(const QPointF& pixel) const;
  bool showsHandle(const ControlId& handle) const;
  std::vector<ControlId> shownControls() const;
  modeling::Vec2 snapped(const modeling::Vec2& at);
  void insertAt(const CurvePlace& place);
  void dragControls(const QPointF& pixel, Qt::KeyboardModifiers modifiers);
  void selectBox();
  void cancelDrag();
  void letGo();
  void nudge(int key, Qt::KeyboardModifiers modifiers);
  bool act(int key);

  std::optional<ProfileModel> model_;
  ProfileView view_;
  bool framed_ = false;
  ControlSet selected_;
  Mode mode_ = Mode::select;
  bool snaps_ = true;

  Drag drag_ = Drag::none;
  QPointF pressed_;
  QPointF pointer_;
  std::optional<ControlId> grabbed_;
  std::optional<ProfileModel> dragBase_;
  ControlSet boxBase_;
  std::optional<ControlId> hovered_;
  std::optional<CurvePlace> hoveredCurve_;
  std::optional<modeling::Vec2> snapMark_;
};

}  // namespace ui
