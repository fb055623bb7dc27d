#include "ui/editors/profile_editor.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>

#include "ui/editors/problem_text.h"
#include "ui/editors/profile_canvas.h"
#include "ui/panels/number_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

const QString kFieldGesture = QStringLiteral("profile field");

const modeling::RevolutionShape* revolution(const modeling::Scene& scene, std::size_t part) {
  return part < scene.parts.size() ? std::get_if<modeling::RevolutionShape>(&scene.parts[part].shape)
                                   : nullptr;
}

std::optional<std::size_t> indexOf(const modeling::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i)
    if (scene.parts[i].name == name && revolution(scene, i) != nullptr) return i;
  return std::nullopt;
}

NumberField* lengthField(QWidget* parent, const QString& name, const QString& tip, double least) {
  NumberFormat format;
  format.dimension = Dimension::length;
  format.least = least;
  format.step = 0.05;
  auto* field = new NumberField(format, parent);
  field->setObjectName(name);
  field->setToolTip(tip);
  field->setFixedWidth(88);
  return field;
}

}  // namespace

ProfileEditor::ProfileEditor(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("profile-editor"));
  canvas_ = new ProfileCanvas(this);
  auto* drawing = new QWidget(this);
  auto* column = new QVBoxLayout(drawing);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeToolBar());
  column->addWidget(canvas_, 1);
  column->addWidget(makeFields());
  pages_ = new QStackedWidget(this);
  pages_->addWidget(makeEmptyState());
  pages_->addWidget(drawing);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(pages_);

  connect(canvas_, &ProfileCanvas::edited, this, &ProfileEditor::write);
  connect(canvas_, &ProfileCanvas::gestureEnded, this, [this] { session_.document().endGesture(); });
  connect(canvas_, &ProfileCanvas::selectionChanged, this, &ProfileEditor::showSelected);
  connect(canvas_, &ProfileCanvas::refused, this, [this](const QString& why) {
    refusal_ = why;
    showMessage();
  });
  connect(canvas_, &ProfileCanvas::modeChanged, this, [this] {
    const bool inserts = canvas_->mode() == ProfileCanvas::Mode::insert;
    (inserts ? insertMode_ : selectMode_)->setChecked(true);
    showMessage();
  });
  connect(&session_.document(), &Document::sceneChanged, this, &ProfileEditor::follow);
  connect(&session_.selection(), &Selection::changed, this, &ProfileEditor::follow);
  connect(&session_, &Session::previewChanged, this, &ProfileEditor::showMessage);
  follow();
}

QWidget* ProfileEditor::makeEmptyState() {
  auto* page = new QWidget(this);
  auto* text = new QLabel(tr("Select a solid of revolution to draw its profile:\n"
                             "the outside and the inside of a cup, from the base to the rim."),
                          page);
  text->setAlignment(Qt::AlignCenter);
  text->setForegroundRole(QPalette::PlaceholderText);
  selectPart_ = new QPushButton(page);
  selectPart_->setObjectName(QStringLiteral("profile-select-part"));
  selectPart_->setIcon(Theme::icon(QStringLiteral("profile")));
  connect(selectPart_, &QPushButton::clicked, this, [this] {
    if (const auto part = anyPart()) session_.selection().select({ItemKind::part, *part});
  });
  auto* layout = new QVBoxLayout(page);
  layout->addStretch();
  layout->addWidget(text);
  layout->addSpacing(10);
  layout->addWidget(selectPart_, 0, Qt::AlignHCenter);
  layout->addStretch();
  return page;
}

QAction* ProfileEditor::addAction(QToolBar& bar, const QString& icon, const QString& text,
                                  const QString& tip) {
  QAction* action = bar.addAction(Theme::icon(icon), text);
  action->setToolTip(tip);
  return action;
}

QToolBar* ProfileEditor::makeToolBar() {
  auto* bar = new QToolBar(this);
  bar->setIconSize({18, 18});
  addModes(*bar);
  bar->addSeparator();
  addPointActions(*bar);
  bar->addSeparator();
  addEnds(*bar);
  addViewActions(*bar);
  return bar;
}

void ProfileEditor::addModes(QToolBar& bar) {
  auto* modes = new QActionGroup(this);
  selectMode_ =
      addAction(bar, QStringLiteral("select-points"), tr("Select"),
                tr("Select and drag points (Esc)\nShift adds to the selection, Alt moves one handle "
                   "by itself,\nCtrl turns snapping round, double click on a curve adds a point"));
  insertMode_ = addAction(bar, QStringLiteral("insert-point"), tr("Insert"),
                          tr("Insert a point where a curve is clicked (I)"));
  for (QAction* action : {selectMode_, insertMode_}) {
    action->setCheckable(true);
    modes->addAction(action);
  }
  selectMode_->setChecked(true);
  connect(selectMode_, &QAction::triggered, this, [this] { canvas_->setMode(ProfileCanvas::Mode::select); });
  connect(insertMode_, &QAction::triggered, this, [this] { canvas_->setMode(ProfileCanvas::Mode::insert); });
}

void ProfileEditor::addPointActions(QToolBar& bar) {
  const auto add = [&](const QString& icon, const QString& text, const QString& tip, auto act) {
    QAction* action = addAction(bar, icon, text, tip);
    connect(action, &QAction::triggered, canvas_, act);
    pointActions_.push_back(action);
  };
  add(QStringLiteral("point-smooth"), tr("Smooth"), tr("Smooth: both handles in one line (S)"),
      &ProfileCanvas::smoothSelected);
  add(QStringLiteral("point-corner"), tr("Corner"), tr("Corner: handles towards the neighbours (C)"),
      &ProfileCanvas::cornerSelected);
  add(QStringLiteral("straight-segment"), tr("Straight"), tr("Straight line between the selected points (L)"),
      &ProfileCanvas::straightenSelected);
  add(QStringLiteral("delete"), tr("Delete"), tr("Delete the selected points (Del)"),
      &ProfileCanvas::deleteSelected);
}

void ProfileEditor::addEnds(QToolBar& bar) {
  auto* ends = new QMenu(this);
  lowerClosed_ = ends->addAction(tr("Lower end closed on the axis"));
  upperClosed_ = ends->addAction(tr("Upper end closed on the axis"));
  for (QAction* action : {lowerClosed_, upperClosed_}) action->setCheckable(true);
  connect(lowerClosed_, &QAction::triggered, this, [this](bool closed) { closeEnd(false, closed); });
  connect(upperClosed_, &QAction::triggered, this, [this](bool closed) { closeEnd(true, closed); });
  auto* button = new QToolButton(&bar);
  button->setIcon(Theme::icon(QStringLiteral("closed-end")));
  button->setToolTip(tr("Ends: closed over the axis, or a rim"));
  button->setMenu(ends);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setObjectName(QStringLiteral("profile-ends"));
  bar.addWidget(button);
}

void ProfileEditor::addViewActions(QToolBar& bar) {
  snap_ = addAction(bar, QStringLiteral("magnet"), tr("Snap"),
                    tr("Snap to the grid, the axis and the other profile's ends (Ctrl: the other way)"));
  snap_->setCheckable(true);
  snap_->setChecked(canvas_->snaps());
  connect(snap_, &QAction::toggled, canvas_, &ProfileCanvas::setSnaps);
  QAction* frame =
      addAction(bar, QStringLiteral("profile-frame"), tr("Frame"), tr("Show the whole profile (F, Home)"));
  connect(frame, &QAction::triggered, canvas_, &ProfileCanvas::frame);
  bar.addSeparator();
  auto* presets = new QMenu(this);
  for (const ProfilePreset preset : kProfilePresets)
    connect(presets->addAction(nameOf(preset)), &QAction::triggered, this,
            [this, preset] { usePreset(preset); });
  auto* button = new QToolButton(&bar);
  button->setText(tr("Preset"));
  button->setToolTip(tr("Start from the profile of a dish"));
  button->setMenu(presets);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setObjectName(QStringLiteral("profile-preset"));
  bar.addWidget(button);
}

QWidget* ProfileEditor::makeFields() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(6);
  radius_ = lengthField(row, QStringLiteral("profile-r"),
                        tr("Distance of the selected point from the axis, cm"), 0.0);
  height_ = lengthField(row, QStringLiteral("profile-z"), tr("Height of the selected point, cm"), -1e300);
  thickness_ = lengthField(row, QStringLiteral("profile-thickness"), tr("Thickness of the wall, cm"), 0.01);
  auto* offset = new QPushButton(Theme::icon(QStringLiteral("offset-inside")), tr("Offset inside"), row);
  offset->setObjectName(QStringLiteral("profile-offset"));
  offset->setToolTip(tr("Draw the inside anew, one thickness from the outside everywhere"));
  message_ = new QLabel(row);
  message_->setObjectName(QStringLiteral("profile-message"));
  message_->setWordWrap(true);
  message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(new QLabel(QStringLiteral("r"), row));
  layout->addWidget(radius_);
  layout->addWidget(new QLabel(QStringLiteral("z"), row));
  layout->addWidget(height_);
  layout->addSpacing(10);
  layout->addWidget(new QLabel(tr("Wall"), row));
  layout->addWidget(thickness_);
  layout->addWidget(offset);
  layout->addSpacing(10);
  layout->addWidget(message_, 1);
  connect(radius_, &NumberField::edited, this, [this](std::optional<double> value, bool finished) {
    placeSelected(0, value.value_or(0.0), finished);
  });
  connect(height_, &NumberField::edited, this, [this](std::optional<double> value, bool finished) {
    placeSelected(1, value.value_or(0.0), finished);
  });
  connect(thickness_, &NumberField::edited, this, [this] {
    if (!session_.document().isRehearsing()) thicknessTyped_ = true;
  });
  connect(offset, &QPushButton::clicked, this, &ProfileEditor::offsetInside);
  return row;
}

std::optional<std::size_t> ProfileEditor::anyPart() const {
  const modeling::Scene& scene = session_.document().scene();
  for (std::size_t i = 0; i < scene.parts.size(); ++i)
    if (revolution(scene, i) != nullptr) return i;
  return std::nullopt;
}

std::optional<std::size_t> ProfileEditor::findPart() {
  const modeling::Scene& scene = session_.document().scene();
  const Item current = session_.selection().current();
  if (current.kind == ItemKind::part) {
    if (revolution(scene, current.index) == nullptr) return std::nullopt;
    return current.index;
  }
  return indexOf(scene, partName_);
}

void ProfileEditor::follow() {
  const modeling::Scene& scene = session_.document().scene();
  const std::optional<std::size_t> part = findPart();
  const std::string name = part ? scene.parts[*part].name : std::string();
  if (name != partName_) {
    canvas_->setModel(std::nullopt);
    thicknessTyped_ = false;
    refusal_.clear();
  }
  partName_ = name;
  pages_->setCurrentIndex(part ? 1 : 0);
  if (!part) {
    canvas_->setModel(std::nullopt);
    const auto other = anyPart();
    selectPart_->setVisible(other.has_value());
    if (other) selectPart_->setText(tr("Draw %1").arg(QString::fromStdString(scene.parts[*other].name)));
    return;
  }
  const modeling::RevolutionShape& shape = *revolution(scene, *part);
  if (!canvas_->model() || canvas_->model()->shape() != shape) canvas_->setModel(ProfileModel(shape));
  showSelected();
  showMessage();
}

ProfileEnd ProfileEditor::endOf(bool upper) const {
  const modeling::ProfileChain& outside = canvas_->model()->chain(ProfileSide::outside);
  const bool rises = outside.back()[3].y() >= outside.front()[0].y();
  return rises == upper ? ProfileEnd::end : ProfileEnd::start;
}

void ProfileEditor::showSelected() {
  const std::optional<ProfileModel>& model = canvas_->model();
  const ControlSet& selected = canvas_->selected();
  const bool one = model && selected.size() == 1;
  for (QAction* action : pointActions_) action->setEnabled(model && !selected.empty());
  radius_->setEnabled(one);
  height_->setEnabled(one);
  if (one) {
    const modeling::Vec2 at = model->position(*selected.begin());
    radius_->setValue(at.x());
    height_->setValue(at.y());
  } else {
    radius_->setValue(std::nullopt);
    height_->setValue(std::nullopt);
  }
  if (!model) return;
  if (!thicknessTyped_)
    if (const double thickness = model->meanThickness(); thickness > 0.0 && !model->isSolid())
      thickness_->setValue(std::round(thickness * 100.0) / 100.0);
  for (const bool upper : {false, true}) {
    QAction* action = upper ? upperClosed_ : lowerClosed_;
    action->setEnabled(!model->isSolid());
    action->setChecked(model->isClosed(endOf(upper)));
  }
}

void ProfileEditor::showMessage() {
  if (!canvas_->model()) return;
  QString text = refusal_;
  if (text.isEmpty())
    if (const auto problem = canvas_->model()->problem()) text = textOf(*problem);
  const auto part = indexOf(session_.document().scene(), partName_);
  const auto& built = session_.preview()->problem;
  if (text.isEmpty() && built && part && built->place.rfind("parts[" + std::to_string(*part) + "]", 0) == 0)
    text = textOf(*built);
  const bool wrong = !text.isEmpty();
  if (!wrong && canvas_->mode() == ProfileCanvas::Mode::insert) text = tr("Click on a curve to add a point");
  QPalette palette = this->palette();
  const Colours& colours = Theme::instance().colours();
  palette.setColor(QPalette::WindowText, wrong ? colours.bad : colours.dimText);
  message_->setPalette(palette);
  message_->setText(text);
  message_->setToolTip(text);
}

void ProfileEditor::write(const QString& name, const modeling::RevolutionShape& shape,
                          const QString& gesture) {
  const auto part = indexOf(session_.document().scene(), partName_);
  if (!part) return;
  session_.document().edit(
      name, [&](modeling::Scene& scene) { scene.parts[*part].shape = shape; }, gesture);
}

void ProfileEditor::placeSelected(std::size_t axis, double value, bool finished) {
  if (!canvas_->model() || canvas_->selected().size() != 1) return;
  ProfileModel model = *canvas_->model();
  const ControlId control = *canvas_->selected().begin();
  modeling::Vec2 at = model.position(control);
  at[static_cast<Eigen::Index>(axis)] = value;
  model.place(control, at);
  write(tr("Place profile point"), model.shape(), kFieldGesture);
  if (finished) session_.document().endGesture();
}

void ProfileEditor::closeEnd(bool upper, bool closed) {
  if (!canvas_->model()) return;
  const ProfileEnd end = endOf(upper);
  canvas_->apply(closed ? tr("Close profile") : tr("Open profile"), [&](ProfileModel& model) {
    if (closed) {
      model.close(end);
    } else {
      model.open(end);
    }
    return sim::Done{};
  });
  showSelected();
}

void ProfileEditor::usePreset(ProfilePreset preset) {
  if (!canvas_->model()) return;
  modeling::RevolutionShape shape = shapeOf(preset);
  const modeling::RevolutionShape& before = canvas_->model()->shape();
  shape.startAngle = before.startAngle;
  shape.turnAngle = before.turnAngle;
  canvas_->setSelected({});
  thicknessTyped_ = false;
  write(tr("Profile of a preset"), shape, {});
  canvas_->frame();
}

void ProfileEditor::offsetInside() {
  const double thickness = thickness_->value().value_or(0.0);
  canvas_->apply(tr("Offset inside"), [&](ProfileModel& model) { return model.offsetInside(thickness); });
}

}  // namespace ui
