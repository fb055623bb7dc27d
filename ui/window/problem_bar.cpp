#include "ui/window/problem_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/theme/theme.h"

namespace ui {
namespace {

QString sentence(const std::string& words) {
  QString text = QString::fromStdString(words);
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  return text + '.';
}

}  // namespace

ProblemBar::ProblemBar(QWidget* parent) : QFrame(parent) {
  setObjectName("problemBar");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 8, 8, 8);
  layout->setSpacing(10);
  icon_ = new QLabel(this);
  label_ = new QLabel(this);
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label_->setTextFormat(Qt::PlainText);
  auto* close = new QToolButton(this);
  close->setIcon(Theme::icon("close"));
  close->setToolTip(tr("Put away"));
  close->setAutoRaise(true);
  connect(close, &QToolButton::clicked, this, &ProblemBar::putAway);
  layout->addWidget(icon_, 0, Qt::AlignTop);
  layout->addWidget(label_, 1);
  layout->addWidget(close, 0, Qt::AlignTop);
  connect(&Theme::instance(), &Theme::changed, this, &ProblemBar::dress);
  dress();
  hide();
}

void ProblemBar::dress() {
  const Colours& colours = Theme::instance().colours();
  icon_->setPixmap(Theme::icon("warning").pixmap(QSize(18, 18), devicePixelRatioF()));
  setStyleSheet(QStringLiteral("#problemBar { background: %1; border-bottom: 2px solid %2; }")
                    .arg(colours.panel.name(), colours.bad.name()));
}

void ProblemBar::show(const sim::Problem& problem, const QString& place) {
  QStringList parts;
  if (!place.isEmpty()) parts.append(place + ':');
  parts.append(sentence(problem.what));
  if (!problem.remedy.empty()) parts.append(sentence(problem.remedy));
  text_ = parts.join(' ');
  label_->setText(text_);
  setVisible(true);
}

}  // namespace ui
