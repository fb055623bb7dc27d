#include "ui/panels/preflight_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/panels/quantity.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

/// Cells worse than these make the step short, or fold.
constexpr double kBadSkew = 0.3;
constexpr double kBadStretch = 4.0;
constexpr double kLongRun = 120.0;  // s
/// As often are parts moved by one click: as many as lie one on the other.
constexpr int kMostMoves = 20;
/// As many overlaps are told of; the rest is counted.
constexpr std::size_t kMostOverlaps = 6;

QString colouredBy(const QColor& colour) {
  return QStringLiteral("color: %1;").arg(colour.name());
}

/// cm: all of them together
double depthOf(const std::vector<modeling::Overlap>& overlaps) {
  double depth = 0.0;
  for (const modeling::Overlap& overlap : overlaps) depth += overlap.depth;
  return depth;
}

QString overlapLines(const std::vector<modeling::Overlap>& overlaps) {
  QStringList lines;
  for (const modeling::Overlap& overlap : overlaps) {
    if (static_cast<std::size_t>(lines.size()) == kMostOverlaps) {
      lines << PreflightDialog::tr("… and %L1 more").arg(overlaps.size() - kMostOverlaps);
      break;
    }
    QString line = QString::fromStdString(modeling::sentence(overlap));
    line[0] = line[0].toUpper();
    lines << QStringLiteral("• ") + line + QStringLiteral(".");
  }
  return lines.join(QStringLiteral("\n"));
}

}  // namespace

QString roughTime(double seconds) {
  if (seconds < 1.0) return PreflightDialog::tr("under a second");
  if (seconds < 90.0) return PreflightDialog::tr("%L1 s").arg(std::ceil(seconds), 0, 'f', 0);
  if (seconds < 90.0 * 60.0) return PreflightDialog::tr("%L1 min").arg(std::ceil(seconds / 60.0), 0, 'f', 0);
  if (seconds < 48.0 * 3600.0) return PreflightDialog::tr("%L1 h").arg(seconds / 3600.0, 0, 'f', 1);
  return PreflightDialog::tr("%L1 days").arg(seconds / 86400.0, 0, 'f', 1);
}

QString roughSize(double bytes) {
  if (bytes < 1e6) return PreflightDialog::tr("%L1 kB").arg(std::ceil(bytes / 1e3), 0, 'f', 0);
  if (bytes < 1e9) return PreflightDialog::tr("%L1 MB").arg(std::ceil(bytes / 1e6), 0, 'f', 0);
  return PreflightDialog::tr("%L1 GB").arg(bytes / 1e9, 0, 'f', 1);
}

PreflightDialog::PreflightDialog(Session& session, QWidget* parent) : QDialog(parent), session_(session) {
  setObjectName(QStringLiteral("preflight"));
  setWindowTitle(tr("Pre-flight"));
  setMinimumWidth(500);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 12);
  column->setSpacing(12);
  verdict_ = new QLabel(this);
  verdict_->setWordWrap(true);
  QFont font = verdict_->font();
  font.setPointSizeF(font.pointSizeF() + 2.0);
  font.setWeight(QFont::DemiBold);
  verdict_->setFont(font);
  busy_ = new QProgressBar(this);
  busy_->setRange(0, 0);
  busy_->setTextVisible(false);
  busy_->setFixedHeight(6);
  column->addWidget(verdict_);
  column->addWidget(busy_);
  column->addLayout(makeRows());
  overlaps_ = new QLabel(this);
  overlaps_->setObjectName(QStringLiteral("overlaps"));
  overlaps_->setWordWrap(true);
  overlaps_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  overlaps_->hide();
  column->addWidget(overlaps_);
  moveOut_ = new QPushButton(tr("&Move Them Out"), this);
  moveOut_->setObjectName(QStringLiteral("moveOut"));
  moveOut_->setToolTip(tr("Moves each part by what is said, with what is glued to it, and looks again"));
  moveOut_->hide();
  connect(moveOut_, &QPushButton::clicked, this, &PreflightDialog::moveOut);
  column->addWidget(moveOut_, 0, Qt::AlignLeft);
  makeParts();
  column->addWidget(parts_, 1);
  column->addWidget(makeButtons());
  timer_.setInterval(60);
  connect(&timer_, &QTimer::timeout, this, &PreflightDialog::tick);
  connect(&Theme::instance(), &Theme::changed, this, [this] {
    if (shown_) showResult();
  });
  connect(&session_.document(), &Document::replaced, this, &QDialog::close);
  connect(&session_.document(), &Document::sceneChanged, this, &PreflightDialog::noteChange);
}

QFormLayout* PreflightDialog::makeRows() {
  auto* rows = new QFormLayout;
  rows->setHorizontalSpacing(20);
  rows->setVerticalSpacing(7);
  const auto row = [&](const QString& name, const QString& help) {
    auto* value = new QLabel(this);
    value->setFont(Theme::numberFont());
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setToolTip(help);
    rows->addRow(name, value);
    return value;
  };
  size_ = row(tr("Size"), tr("After gluing"));
  step_ = row(tr("Step"), tr("The longest that is stable, and the one that is used"));
  second_ = row(tr("A simulated second"), tr("On this machine, measured by some steps just now"));
  clock_ = row(tr("The whole run"), tr("As long as nothing breaks, which makes it slower or faster"));
  memory_ = row(tr("Memory"), tr("While it runs"));
  take_ = row(tr("Take"), tr("What the recording will need on the disk, about"));
  breaking_ = row(tr("Bonds breaking at rest"), tr("Stretched past their threshold before anything moves"));
  return rows;
}

void PreflightDialog::makeParts() {
  parts_ = new QTreeWidget(this);
  parts_->setColumnCount(4);
  parts_->setHeaderLabels({tr("Part"), tr("Nodes"), tr("Worst skew"), tr("Worst stretch")});
  parts_->setRootIsDecorated(false);
  parts_->setToolTip(
      tr("Click to select the part. Skew is 1 for a cube, 0 for a flat cell; stretch is the longest over "
         "the shortest edge."));
  parts_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  parts_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  parts_->header()->setStretchLastSection(false);
  parts_->setMinimumHeight(140);
  connect(parts_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    // By its name: the scene may have been edited since.
    const auto& parts = session_.document().scene().parts;
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (parts[part].name == item->text(0).toStdString())
        session_.selection().select({ItemKind::part, part});
  });
}

QDialogButtonBox* PreflightDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  // The style's own icon is dark on dark.
  buttons->button(QDialogButtonBox::Close)->setIcon({});
  auto* again = buttons->addButton(tr("Look Again"), QDialogButtonBox::ActionRole);
  auto* simulate = buttons->addButton(tr("Simulate"), QDialogButtonBox::ApplyRole);
  simulate->setIcon(Theme::icon(QStringLiteral("play")));
  simulate->setDefault(true);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(again, &QPushButton::clicked, this, &PreflightDialog::look);
  connect(simulate, &QPushButton::clicked, this, [this] {
    close();
    session_.simulate();
  });
  return buttons;
}

void PreflightDialog::look() {
  shown_ = false;
  preview_.reset();
  verdict_->setStyleSheet({});
  verdict_->setText(tr("Making some steps to see…"));
  busy_->show();
  overlaps_->hide();
  moveOut_->hide();
  for (QLabel* label : {size_, step_, clock_, second_, memory_, take_, breaking_}) label->clear();
  timer_.start();
}

void PreflightDialog::tick() {
  if (session_.isBuilding()) return;
  if (preview_ != session_.preview()) {
    preview_ = session_.preview();
    run_.start(preview_);
    showParts();
  }
  if (!run_.isDone()) return;
  timer_.stop();
  busy_->hide();
  shown_ = true;
  showResult();
}

/// What it says is of the scene as it was.
void PreflightDialog::noteChange() {
  if (!isVisible() || !shown_ || !preview_ || movesAlike(preview_->scene, session_.document().scene()))
    return;
  verdict_->setStyleSheet(colouredBy(Theme::instance().colours().warning));
  verdict_->setText(tr("The scene has been changed since: look again."));
  moveOut_->hide();
}

void PreflightDialog::showResult() {
  showParts();
  if (const std::optional<modeling::Preflight> flight = run_.result()) showFlight(*flight);
  if (const std::optional<sim::Problem> problem = run_.problem()) showProblem(*problem);
}

void PreflightDialog::showFlight(const modeling::Preflight& flight) {
  const Colours& colours = Theme::instance().colours();
  size_->setText(tr("%L1 nodes, %L2 bonds, %L3 cells").arg(flight.nodes).arg(flight.bonds).arg(flight.cells));
  const QString used = quantityText(flight.step, Dimension::time, 3);
  const QString stable = quantityText(flight.stableStep, Dimension::time, 3);
  step_->setText(flight.step == flight.stableStep ? tr("%1, stable").arg(used)
                                                  : tr("%1, stable up to %2").arg(used, stable));
  second_->setText(roughTime(flight.wallSecondsPerSecond));
  clock_->setText(tr("%1, %L2 steps").arg(roughTime(flight.wallSeconds)).arg(flight.steps, 0, 'f', 0));
  memory_->setText(roughSize(static_cast<double>(flight.memoryBytes)));
  take_->setText(tr("about %1").arg(roughSize(flight.takeBytes)));
  breaking_->setText(flight.brokenAtRestCount == 0 ? tr("none") : QString::number(flight.brokenAtRestCount));
  showOverlaps(flight);
  const bool wrong =
      flight.brokenAtRestCount > 0 || flight.step > flight.stableStep || !flight.overlaps.empty();
  const bool slow = flight.wallSeconds > kLongRun;
  verdict_->setStyleSheet(colouredBy(wrong ? colours.bad : slow ? colours.warning : colours.good));
  if (flight.step > flight.stableStep)
    verdict_->setText(tr("The step is too long to be stable: set it to auto."));
  else if (flight.brokenAtRestCount > 0)
    verdict_->setText(
        tr("Something breaks before it moves: raise the threshold, or let parts meet without strain."));
  else if (wrong)
    verdict_->setText(tr("Things begin inside each other: move them apart, or glue them."));
  else if (slow)
    verdict_->setText(tr("This will take %1. Larger cells or a softer material make it faster.")
                          .arg(roughTime(flight.wallSeconds)));
  else
    verdict_->setText(tr("Ready: done in %1.").arg(roughTime(flight.wallSeconds)));
}

void PreflightDialog::showOverlaps(const modeling::Preflight& flight) {
  overlaps_->setTextFormat(Qt::PlainText);
  overlaps_->setText(overlapLines(flight.overlaps));
  overlaps_->setStyleSheet(colouredBy(Theme::instance().colours().bad));
  overlaps_->setVisible(!flight.overlaps.empty());
  found_ = flight.overlaps;
  moveOut_->setVisible(
      std::ranges::any_of(found_, [](const modeling::Overlap& overlap) { return overlap.mend.has_value(); }));
  const double before = std::exchange(depthMoved_, 0.0);
  const bool helped = depthOf(found_) < before;
  if (helped && !found_.empty() && movesLeft_ > 0) return moveOn();
  if (before > 0.0 && !helped)
    overlaps_->setText(tr("They do not come free by being moved like this: move them by hand.") +
                       QStringLiteral("\n") + overlapLines(found_));
  // The lines wrap, and a layout asks for their height only once it knows the width.
  layout()->activate();
  const int missing = layout()->heightForWidth(width()) - height();
  if (missing > 0) resize(width(), height() + missing);
}

void PreflightDialog::moveOut() {
  movesLeft_ = kMostMoves;
  session_.document().endGesture();
  moveOn();
}

void PreflightDialog::moveOn() {
  --movesLeft_;
  depthMoved_ = depthOf(found_);
  session_.document().edit(
      tr("Move Out"), [&](modeling::Scene& scene) { modeling::applyMends(found_, scene); },
      QStringLiteral("move out"));
  look();
}

void PreflightDialog::showProblem(const sim::Problem& problem) {
  verdict_->setStyleSheet(colouredBy(Theme::instance().colours().bad));
  verdict_->setText(QString::fromStdString(problem.line()));
}

void PreflightDialog::showParts() {
  parts_->clear();
  if (!preview_->built) return;
  const Colours& colours = Theme::instance().colours();
  for (const modeling::PartReport& part : preview_->built->parts) {
    const modeling::LatticeQuality& quality = part.quality;
    auto* row = new QTreeWidgetItem(parts_);
    row->setText(0, QString::fromStdString(part.name));
    row->setText(1, QStringLiteral("%L1").arg(part.nodes));
    if (quality.volume > 0.0) {
      row->setText(2, QString::number(quality.minScaledJacobian, 'f', 2));
      row->setText(3, QString::number(quality.maxAspect, 'f', 1));
      if (quality.minScaledJacobian < kBadSkew) row->setForeground(2, colours.warning);
      if (quality.maxAspect > kBadStretch) row->setForeground(3, colours.warning);
    }
    for (int i = 1; i < 4; ++i) {
      row->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
      row->setFont(i, Theme::numberFont());
    }
  }
}

}  // namespace ui
