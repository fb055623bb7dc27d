#include "ui/panels/long_run_notice.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "ui/panels/preflight_dialog.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr double kLongRun = 120.0;   // s of the clock
constexpr qint64 kJudgement = 2500;  // ms: before, the speed is a guess

}  // namespace

LongRunNotice::LongRunNotice(Session& session, QWidget* over) : QWidget(over), session_(session) {
  setObjectName(QStringLiteral("long-run"));
  text_ = new QLabel(this);
  auto* goOn = new QPushButton(tr("Go On"), this);
  auto* stop = new QPushButton(tr("Stop"), this);
  auto* look = new QPushButton(tr("Pre-flight"), this);
  look->setToolTip(tr("Stop, and see what makes it long"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 9, 10, 9);
  row->setSpacing(8);
  row->addWidget(text_);
  row->addSpacing(8);
  row->addWidget(look);
  row->addWidget(stop);
  row->addWidget(goOn);
  const auto answer = [this] {
    answered_ = true;
    hide();
  };
  connect(goOn, &QPushButton::clicked, this, answer);
  connect(stop, &QPushButton::clicked, this, [this, answer] {
    answer();
    session_.stopRun();
  });
  connect(look, &QPushButton::clicked, this, [this, answer] {
    answer();
    session_.stopRun();
    emit preflightWanted();
  });
  over->installEventFilter(this);
  connect(&session_, &Session::runChanged, this, &LongRunNotice::showRun);
  hide();
}

void LongRunNotice::showRun() {
  const RunView& run = *session_.run();
  if (run.run != run_) {
    run_ = run.run;
    answered_ = false;
    running_.invalidate();
  }
  if (run.phase != RunPhase::running) {
    if (!session_.hasRun()) hide();
    return;
  }
  if (!running_.isValid()) running_.start();
  const bool judged = running_.elapsed() > kJudgement;
  if (answered_ || !judged || run.secondsLeft < kLongRun)
    return setVisible(isVisible() && !answered_ && run.secondsLeft > 5.0);
  text_->setText(tr("This run will take about %1 more.").arg(roughTime(run.secondsLeft)));
  show();
  place();
}

void LongRunNotice::place() {
  constexpr int kMargin = 10;
  const QRect over = parentWidget()->rect();
  // The words go over to a second line where the picture is narrow.
  const int room = over.width() - 2 * kMargin;
  text_->setWordWrap(false);
  layout()->invalidate();
  const int wanted = sizeHint().width();
  text_->setWordWrap(wanted > room);
  setFixedWidth(std::min(wanted, room));
  adjustSize();
  move(over.center().x() - width() / 2, over.bottom() - height() - 16);
  raise();
}

bool LongRunNotice::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) place();
  return QWidget::eventFilter(watched, event);
}

void LongRunNotice::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(colours.warning);
  painter.setBrush(colours.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
}

}  // namespace ui
