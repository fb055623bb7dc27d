#include "ui/panels/live_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

#include "modeling/scene/perform.h"
#include "ui/document/track_titles.h"
#include "ui/panels/direction_pad.h"
#include "ui/panels/live_slider.h"
#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

using sim::TrackTarget;

/// A picture's time.
constexpr int kChangeMilliseconds = 30;

TouchedSize sizeOf(const Shown& shown, const sim::Vec3& point) {
  Eigen::AlignedBox3d box;
  double nearest = std::numeric_limits<double>::infinity();
  if (shown.moment) {
    for (const sim::Vec3& position : shown.moment->positions) {
      box.extend(position);
      nearest = std::min(nearest, (position - point).norm());
    }
  }
  return box.isEmpty() ? TouchedSize{10.0, 0.0} : TouchedSize{box.diagonal().norm(), nearest};
}

QLabel* headingOf(const QString& text, QWidget* parent) {
  auto* heading = new QLabel(text, parent);
  QFont font = heading->font();
  font.setWeight(QFont::DemiBold);
  heading->setFont(font);
  return heading;
}

}  // namespace

LivePanel::LivePanel(Session& session, Viewport& viewport, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), viewport_(viewport), actions_(actions) {
  setObjectName(QStringLiteral("livePanel"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(scroll);
  scroll->setWidget(content);
  outer->addWidget(scroll);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(10);
  makeActs(*column);
  makeGravity(*column);
  makeScales(*column);
  makePace(*column);
  column->addStretch(1);
  changeTimer_.setSingleShot(true);
  changeTimer_.setInterval(kChangeMilliseconds);
  connect(&changeTimer_, &QTimer::timeout, this, &LivePanel::sendChange);
  connect(&session_, &Session::shownChanged, this, &LivePanel::showValues);
  connect(&session_, &Session::runChanged, this, &LivePanel::showState);
  connect(&session_.document(), &Document::sceneChanged, this, &LivePanel::showValues);
  connect(&session_.document(), &Document::replaced, this, [this] {
    changeTimer_.stop();
    pendingChange_ = nullptr;
  });
  connect(&viewport_, &Viewport::toolChanged, this, &LivePanel::showTool);
  showValues();
  showState();
}

QToolButton* LivePanel::addAct(QGridLayout& grid, int place, const QString& icon, const QString& text,
                               const QString& tip, const QString& shortcut) {
  auto* button = new QToolButton(this);
  auto* action = new QAction(Theme::icon(icon), text, this);
  action->setShortcut(QKeySequence(shortcut));
  action->setToolTip(tip +
                     QStringLiteral("  (%1)").arg(action->shortcut().toString(QKeySequence::NativeText)));
  button->setObjectName(icon);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize({20, 20});
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFixedHeight(36);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setStyleSheet(
      QStringLiteral("QToolButton { background: palette(button); border: 1px solid palette(mid); text-align: "
                     "left; padding: 2px 10px; }"
                     "QToolButton:hover, QToolButton:focus { border-color: palette(highlight); }"
                     "QToolButton:pressed, QToolButton:checked { background: palette(base); border-color: "
                     "palette(highlight); }"));
  grid.addWidget(button, place / 2, place % 2);
  return button;
}

void LivePanel::makeActs(QBoxLayout& column) {
  auto* head = new QHBoxLayout;
  head->addWidget(headingOf(tr("Perform"), this));
  head->addStretch(1);
  auto* record = new QToolButton(this);
  record->setDefaultAction(actions_.record);
  record->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  record->setText(tr("Record"));
  head->addWidget(record);
  column.addLayout(head);
  auto* grid = new QGridLayout;
  grid->setSpacing(6);
  QToolButton* hiccup = addAct(*grid, 0, QStringLiteral("hiccup"), tr("Hiccup"),
                               tr("Gravity jumps to 5 g for a tenth of a second"), QStringLiteral("Shift+H"));
  QToolButton* sneeze =
      addAct(*grid, 1, QStringLiteral("sneeze"), tr("Sneeze"),
             tr("Springs go soft for a tenth of a second, sag, and tighten"), QStringLiteral("Shift+N"));
  poke_ = addAct(*grid, 2, QStringLiteral("poke"), tr("Poke"), tr("Click where an unseen finger is to push"),
                 QStringLiteral("Shift+P"));
  knock_ = addAct(*grid, 3, QStringLiteral("knock"), tr("Knock"),
                  tr("Click where an unseen ball is to fly through"), QStringLiteral("Shift+K"));
  connect(hiccup->defaultAction(), &QAction::triggered, this, &LivePanel::hiccupNow);
  connect(sneeze->defaultAction(), &QAction::triggered, this, &LivePanel::sneezeNow);
  for (QToolButton* button : {poke_, knock_}) {
    const auto kind = button == poke_ ? TouchTool::Kind::poke : TouchTool::Kind::knock;
    button->defaultAction()->setCheckable(true);
    connect(button->defaultAction(), &QAction::triggered, this, [this, kind](bool on) { useTool(kind, on); });
  }
  column.addLayout(grid);
  state_ = new QLabel(this);
  state_->setWordWrap(true);
  // Two lines, so that nothing jumps when it says more.
  state_->setMinimumHeight(2 * state_->fontMetrics().lineSpacing());
  state_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  state_->setForegroundRole(QPalette::PlaceholderText);
  column.addWidget(state_);
}

void LivePanel::makeGravity(QBoxLayout& column) {
  gravity_ = new LiveSlider(tr("Gravity"), tr(" g"), {-2.0, 10.0, LiveSlider::Scale::linear}, this);
  gravity_->setObjectName(QStringLiteral("gravity"));
  gravity_->setUsual(1.0);
  direction_ = new DirectionPad(this);
  direction_->setObjectName(QStringLiteral("direction"));
  auto* presets = new QVBoxLayout;
  presets->setSpacing(4);
  const std::pair<QString, sim::Vec3> ways[] = {{tr("Down"), -sim::Vec3::UnitZ()},
                                                {tr("Along X"), sim::Vec3::UnitX()},
                                                {tr("Along Y"), sim::Vec3::UnitY()}};
  for (const auto& [name, way] : ways) {
    auto* button = new QPushButton(name, this);
    button->setFixedHeight(28);
    presets->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, towards = way] {
      direction_->setDirection(towards);
      changeGravity();
      endChange();
    });
  }
  connect(gravity_, &LiveSlider::changed, this, &LivePanel::changeGravity);
  connect(gravity_, &LiveSlider::released, this, &LivePanel::endChange);
  connect(direction_, &DirectionPad::changed, this, &LivePanel::changeGravity);
  connect(direction_, &DirectionPad::released, this, &LivePanel::endChange);
  column.addWidget(gravity_);
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(direction_);
  row->addLayout(presets, 1);
  column.addLayout(row);
}

void LivePanel::makeScales(QBoxLayout& column) {
  const LiveSlider::Range range{1e-3, 10.0, LiveSlider::Scale::logarithmic};
  const QString times = QStringLiteral(" \u00d7");
  stiffness_ = new LiveSlider(tr("Stiffness"), times, range, this);
  stiffness_->setObjectName(QStringLiteral("stiffness"));
  damping_ = new LiveSlider(tr("Damping"), times, range, this);
  damping_->setObjectName(QStringLiteral("damping"));
  for (LiveSlider* slider : {stiffness_, damping_}) {
    const TrackTarget target = slider == stiffness_ ? TrackTarget::stiffnessScale : TrackTarget::dampingScale;
    connect(slider, &LiveSlider::changed, this, [this, target](double value) { change(target, value); });
    connect(slider, &LiveSlider::released, this, &LivePanel::endChange);
    column.addWidget(slider);
  }
}

void LivePanel::makePace(QBoxLayout& column) {
  pace_ = new LiveSlider(tr("Time scale"), QStringLiteral(" \u00d7"),
                         {0.01, 1.0, LiveSlider::Scale::logarithmic}, this);
  pace_->setObjectName(QStringLiteral("pace"));
  pace_->setValue(1.0);
  pace_->setToolTip(tr("Seconds of the simulation in one of the clock, where the computer is fast enough"));
  asFastAsPossible_ = new QCheckBox(tr("As fast as possible"), this);
  asFastAsPossible_->setChecked(true);
  pace_->setEnabled(false);
  connect(pace_, &LiveSlider::changed, this, &LivePanel::sendPace);
  connect(asFastAsPossible_, &QCheckBox::toggled, this, &LivePanel::sendPace);
  column.addWidget(pace_);
  column.addWidget(asFastAsPossible_);
}

void LivePanel::sendPace() {
  pace_->setEnabled(!asFastAsPossible_->isChecked());
  Pace pace;
  if (!asFastAsPossible_->isChecked()) pace.timeScale = pace_->value();
  session_.setPace(pace);
}

const modeling::Scene& LivePanel::presentScene() const {
  const RunView& run = *session_.run();
  if (!session_.hasRun() || !run.footage) return session_.document().scene();
  scene_ = *run.footage->scene();
  return scene_;
}

double LivePanel::presentTime() const {
  const RunView& run = *session_.run();
  if (session_.hasRun()) return run.newest ? run.newest->time : 0.0;
  const Shown& shown = session_.shown();
  return shown.recorded && shown.moment ? shown.moment->time : 0.0;
}

void LivePanel::beginRun() {
  if (!session_.hasRun()) {
    session_.simulate();
  } else if (session_.run()->phase == RunPhase::paused) {
    session_.pauseRun(false);
  }
  if (session_.hasRun() && !session_.followsRun()) session_.followRun();
}

void LivePanel::hiccupNow() {
  beginRun();
  LiveKeys keys = hiccup(presentScene(), presentTime());
  session_.perform(keys.target, std::move(keys.keys));
}

void LivePanel::sneezeNow() {
  beginRun();
  LiveKeys keys = sneeze(presentScene(), presentTime());
  session_.perform(keys.target, std::move(keys.keys));
}

void LivePanel::touchNow(TouchTool::Kind kind, const sim::Vec3& point, const sim::Vec3& direction) {
  const TouchedSize size = sizeOf(session_.shown(), point);
  beginRun();
  LiveTouch touch =
      kind == TouchTool::Kind::poke ? poke(point, direction, size) : knock(point, direction, size);
  session_.performCollider(touch.collider, std::move(touch.path));
}

void LivePanel::useTool(TouchTool::Kind kind, bool on) {
  if (!on) {
    viewport_.setTool(nullptr);
    return;
  }
  viewport_.setTool(
      std::make_unique<TouchTool>(kind, [this, kind](const sim::Vec3& point, const sim::Vec3& direction) {
        touchNow(kind, point, direction);
      }));
  viewport_.setFocus();
}

void LivePanel::showTool() {
  const auto* touch = dynamic_cast<const TouchTool*>(viewport_.tool());
  poke_->defaultAction()->setChecked(touch != nullptr && touch->kind() == TouchTool::Kind::poke);
  knock_->defaultAction()->setChecked(touch != nullptr && touch->kind() == TouchTool::Kind::knock);
}

void LivePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showValues();
}

/// The value goes out with the next picture; those that were passed in between nobody sees.
void LivePanel::change(TrackTarget target, const modeling::TrackValue& value) {
  pendingChange_ = [this, target, value] {
    const modeling::TargetName all{target, {}};
    const double time = presentTime();
    if (!session_.hasRun()) {
      session_.document().edit(
          titleOf(all), [&](modeling::Scene& scene) { setLiveValue(scene, target, time, value); },
          QStringLiteral("live %1").arg(static_cast<int>(target)));
      return;
    }
    modeling::TrackValue written = value;
    if (target != TrackTarget::gravity)
      written = modeling::performedScale(presentScene(), all, time, std::get<double>(value));
    session_.perform(all, {{0.0, written}});
  };
  if (!changeTimer_.isActive()) changeTimer_.start();
}

/// The slider shows gravity with its scale; the scale stays what it is.
void LivePanel::changeGravity() {
  const double scale = liveValuesAt(presentScene(), presentTime()).gravityScale;
  const double strength = gravity_->value() * kStandardGravity / (scale == 0.0 ? 1.0 : scale);
  change(TrackTarget::gravity, sim::Vec3(strength * direction_->direction()));
}

void LivePanel::sendChange() {
  if (!pendingChange_) return;
  const std::function<void()> pending = std::exchange(pendingChange_, nullptr);
  pending();
}

void LivePanel::endChange() {
  changeTimer_.stop();
  sendChange();
  if (!session_.hasRun()) session_.document().endGesture();
}

void LivePanel::showValues() {
  if (pendingChange_ || !isVisibleTo(window())) return;
  const Shown& shown = session_.shown();
  const bool recorded = shown.recorded && shown.scene && shown.moment;
  const LiveValues values =
      liveValuesAt(recorded ? *shown.scene : session_.document().scene(), presentTime());
  const sim::Vec3 gravity = values.gravityScale * values.gravity;
  const bool upwards = gravity.z() > 1e-9;
  gravity_->setValue((upwards ? -1.0 : 1.0) * gravity.norm() / kStandardGravity);
  direction_->setDirection(values.gravity);
  stiffness_->setValue(values.stiffness);
  damping_->setValue(values.damping);
}

void LivePanel::showState() {
  const QString text = !session_.hasRun()
                           ? tr("No run is on: the buttons begin one, the sliders edit the scene.")
                       : session_.records() ? tr("Running: what you do becomes keys in the tracks.")
                                            : tr("Running: what you do is not kept in the scene.");
  if (state_->text() != text) state_->setText(text);
}

}  // namespace ui
