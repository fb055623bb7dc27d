#include "ui/viewport/view_bars.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QToolButton>

#include "ui/theme/theme.h"
#include "ui/viewport/view_actions.h"
#include "ui/viewport/view_choices.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

constexpr int kMargin = 10;

QFrame* makeBar(Viewport& viewport, QBoxLayout::Direction direction) {
  auto* bar = new QFrame(&viewport);
  bar->setObjectName(QStringLiteral("viewBar"));
  auto* layout = new QBoxLayout(direction, bar);
  layout->setContentsMargins(3, 3, 3, 3);
  layout->setSpacing(2);
  return bar;
}

}  // namespace

ViewBars::ViewBars(Viewport& viewport, const ViewActions& actions) : QObject(&viewport), viewport_(viewport) {
  tools_ = makeBar(viewport_, QBoxLayout::TopToBottom);
  for (QAction* action : actions.tools()) addButton(*tools_, action);
  addButton(*tools_, actions.snap());
  shows_ = makeBar(viewport_, QBoxLayout::LeftToRight);
  for (QAction* action : actions.shows()) addButton(*shows_, action);
  more_ = addButton(*shows_, nullptr);
  more_->setIcon(Theme::icon(QStringLiteral("view-choices")));
  more_->setToolTip(tr("<b>What is shown, and how</b>"));
  more_->setAccessibleName(tr("What is shown"));
  connect(more_, &QToolButton::clicked, this, &ViewBars::showChoices);
  viewport_.installEventFilter(this);
  place();
}

QToolButton* ViewBars::addButton(QFrame& bar, QAction* action) {
  auto* button = new QToolButton(&bar);
  button->setAutoRaise(true);
  button->setIconSize(QSize(18, 18));
  button->setFocusPolicy(Qt::TabFocus);
  if (action != nullptr) button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  bar.layout()->addWidget(button);
  return button;
}

void ViewBars::place() {
  tools_->adjustSize();
  shows_->adjustSize();
  tools_->move(kMargin, kMargin);
  shows_->move(viewport_.width() - shows_->width() - kMargin, kMargin);
}

bool ViewBars::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) place();
  return QObject::eventFilter(object, event);
}

void ViewBars::showChoices() {
  auto* choices = new ViewChoices(viewport_);
  choices->setAttribute(Qt::WA_DeleteOnClose);
  choices->adjustSize();
  const QPoint below = shows_->mapToGlobal(QPoint(shows_->width() - choices->width(), shows_->height() + 4));
  choices->move(below);
  choices->show();
}

}  // namespace ui
