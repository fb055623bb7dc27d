#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>

#include "ui/panels/live_values.h"
#include "ui/panels/touch_tool.h"

class QBoxLayout;
class QCheckBox;
class QGridLayout;
class QLabel;
class QToolButton;

namespace ui {

class DirectionPad;
class LiveSlider;
class PlayActions;
class Session;
class Viewport;

/// What can be done to a simulation while it runs. Without a run the sliders edit the scene, and the buttons
/// begin a run.
class LivePanel : public QWidget {
  Q_OBJECT

 public:
  LivePanel(Session& session, Viewport& viewport, PlayActions& actions, QWidget* parent = nullptr);

  void hiccupNow();
  void sneezeNow();
  /// Pushes at a point along a direction.
  void touchNow(TouchTool::Kind kind, const sim::Vec3& point, const sim::Vec3& direction);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void makeActs(QBoxLayout& column);
  void makeGravity(QBoxLayout& column);
  void makeScales(QBoxLayout& column);
  void makePace(QBoxLayout& column);
  QToolButton* addAct(QGridLayout& grid, int place, const QString& icon, const QString& text,
                      const QString& tip, const QString& shortcut);
  void useTool(TouchTool::Kind kind, bool on);
  void showTool();
  void showValues();
  void showState();

  /// Begins a run where there is none, and lets a paused one go on.
  void beginRun();
  const modeling::Scene& presentScene() const;
  double presentTime() const;
  void change(sim::TrackTarget target, const modeling::TrackValue& value);
  void sendChange();
  void endChange();
  void changeGravity();
  void sendPace();

  Session& session_;
  Viewport& viewport_;
  PlayActions& actions_;
  LiveSlider* gravity_ = nullptr;
  DirectionPad* direction_ = nullptr;
  LiveSlider* stiffness_ = nullptr;
  LiveSlider* damping_ = nullptr;
  LiveSlider* pace_ = nullptr;
  QCheckBox* asFastAsPossible_ = nullptr;
  QToolButton* poke_ = nullptr;
  QToolButton* knock_ = nullptr;
  QLabel* state_ = nullptr;
  /// A hand moves a slider more often than a picture is drawn: the newest value goes out then.
  QTimer changeTimer_;
  std::function<void()> pendingChange_;
  mutable modeling::Scene scene_;  ///< of the run, as performed so far
};

}  // namespace ui
