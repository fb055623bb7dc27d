#include "ui/panels/inspector_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme/theme.h"
#include "ui/viewport/break_history.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

/// Until one looks again whether a take on the disk has been read.
constexpr int kLookAgainMilliseconds = 150;

}  // namespace

InspectorPanel::InspectorPanel(Session& session, Viewport& viewport, QWidget* parent)
    : QWidget(parent), session_(session), breaks_(std::make_unique<BreakHistory>()) {
  setObjectName(QStringLiteral("inspector"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  stack_ = new QStackedWidget(this);
  auto* empty = new QLabel(tr("Click a piece, a bond or a node in the view to see what it does."), this);
  empty->setAlignment(Qt::AlignCenter);
  empty->setWordWrap(true);
  empty->setMargin(20);
  empty->setForegroundRole(QPalette::PlaceholderText);
  stack_->addWidget(empty);
  makePage();
  column->addWidget(stack_);
  connect(&viewport, &Viewport::clicked, this, &InspectorPanel::lookAt);
  connect(&session_, &Session::shownChanged, this, &InspectorPanel::look);
}

InspectorPanel::~InspectorPanel() = default;

void InspectorPanel::makePage() {
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  auto* page = new QWidget(scroll);
  scroll->setWidget(page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(8);
  auto* head = new QHBoxLayout;
  title_ = new QLabel(page);
  QFont strong = title_->font();
  strong.setWeight(QFont::DemiBold);
  title_->setFont(strong);
  title_->setObjectName(QStringLiteral("inspected"));
  head->addWidget(title_);
  head->addStretch(1);
  fragment_ = new QToolButton(page);
  fragment_->setText(tr("Its Fragment"));
  fragment_->setToolTip(tr("Look at the fragment that this belongs to"));
  connect(fragment_, &QToolButton::clicked, this, [this] {
    if (!found_.fragment) return;
    Pick fragment;
    fragment.kind = Pick::Kind::fragment;
    fragment.index = *found_.fragment;
    lookAt(fragment);
  });
  head->addWidget(fragment_);
  column->addLayout(head);
  strain_ = new QProgressBar(page);
  strain_->setRange(0, 1000);
  strain_->setTextVisible(false);
  strain_->setFixedHeight(6);
  strain_->setToolTip(tr("Strain as a share of the threshold: when full, it breaks"));
  column->addWidget(strain_);
  facts_ = new QGridLayout;
  facts_->setHorizontalSpacing(14);
  facts_->setVerticalSpacing(4);
  facts_->setColumnStretch(1, 1);
  column->addLayout(facts_);
  column->addStretch(1);
  stack_->addWidget(scroll);
}

void InspectorPanel::lookAt(const Pick& pick) {
  pick_ = pick;
  look();
}

void InspectorPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  look();
}

std::optional<sim::BreakEvent> InspectorPanel::breakOf(const Pick& pick) {
  const Shown& shown = session_.shown();
  if (!isBroken(pick, shown)) return std::nullopt;
  const std::shared_ptr<Footage>& footage =
      shown.live ? session_.run()->footage : session_.playback().footage();
  if (!footage) return std::nullopt;
  std::optional<sim::BreakEvent> event = breaks_->of(footage, pick.index);
  if (!event && breaks_->isReading()) QTimer::singleShot(kLookAgainMilliseconds, this, &InspectorPanel::look);
  return event;
}

void InspectorPanel::look() {
  if (!isVisible()) return;
  found_ = inspect(pick_, session_.shown(), breakOf(pick_));
  display();
}

void InspectorPanel::display() {
  stack_->setCurrentIndex(found_.title.isEmpty() ? 0 : 1);
  if (found_.title.isEmpty()) return;
  title_->setText(found_.title);
  fragment_->setVisible(found_.fragment && pick_.kind != Pick::Kind::fragment &&
                        pick_.kind != Pick::Kind::part);
  strain_->setVisible(found_.strainOfThreshold.has_value());
  if (found_.strainOfThreshold)
    strain_->setValue(static_cast<int>(1000.0 * std::clamp(*found_.strainOfThreshold, 0.0, 1.0)));
  // Labels are kept: a run shows another moment sixty times a second.
  while (labels_.size() < 2 * found_.facts.size()) {
    const int row = static_cast<int>(labels_.size() / 2);
    auto* name = new QLabel(this);
    name->setForegroundRole(QPalette::PlaceholderText);
    auto* value = new QLabel(this);
    value->setFont(Theme::numberFont(-0.5));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    facts_->addWidget(name, row, 0, Qt::AlignTop);
    facts_->addWidget(value, row, 1, Qt::AlignTop);
    labels_.push_back(name);
    labels_.push_back(value);
  }
  for (std::size_t place = 0; place < labels_.size(); ++place) {
    const bool used = place / 2 < found_.facts.size();
    labels_[place]->setVisible(used);
    if (!used) continue;
    const Fact& fact = found_.facts[place / 2];
    labels_[place]->setText(place % 2 == 0 ? fact.name : fact.value);
  }
}

}  // namespace ui
