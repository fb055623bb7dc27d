#include "ui/editors/glue_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "ui/editors/problem_text.h"
#include "ui/panels/number_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kWidth = 272;      ///< logical pixels
constexpr int kMargin = 10;      ///< from the edge of the viewport
constexpr double kLeast = 0.02;  ///< cm, left end of the slider
constexpr double kMost = 5.0;    ///< cm, right end
constexpr int kSteps = 400;

int stepOf(double reach) {
  const double share = std::log(std::max(reach, kLeast) / kLeast) / std::log(kMost / kLeast);
  return static_cast<int>(std::lround(share * kSteps));
}

double reachOf(int step) {
  const double reach = kLeast * std::pow(kMost / kLeast, static_cast<double>(step) / kSteps);
  return std::round(reach * 1000.0) / 1000.0;
}

QLabel* wrapping(QWidget* parent, const QString& name) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

void tint(QLabel* label, const QColor& colour) {
  QPalette palette = label->palette();
  palette.setColor(QPalette::WindowText, colour);
  label->setPalette(palette);
}

}  // namespace

GluePanel::GluePanel(GlueEditing& editing, QWidget* parent) : QWidget(parent), editing_(editing) {
  setObjectName(QStringLiteral("glue-panel"));
  setFixedWidth(kWidth);
  title_ = wrapping(this, QStringLiteral("glue-title"));
  QFont bold = title_->font();
  bold.setWeight(QFont::DemiBold);
  title_->setFont(bold);
  swap_ = new QToolButton(this);
  swap_->setText(tr("Swap"));
  swap_->setToolTip(tr("Glue the other way round: the first part's nodes move onto the second's"));
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(swap_, 0, Qt::AlignTop);
  step_ = wrapping(this, QStringLiteral("glue-step"));
  adjust_ = makeReach();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(8);
  column->addLayout(head);
  column->addWidget(step_);
  column->addWidget(adjust_);
  column->addWidget(makeButtons());
  connect(swap_, &QToolButton::clicked, &editing_, &GlueEditing::swap);
  connect(&editing_, &GlueEditing::changed, this, &GluePanel::follow);
  follow();
}

QWidget* GluePanel::makeReach() {
  auto* box = new QWidget(this);
  slider_ = new QSlider(Qt::Horizontal, box);
  slider_->setObjectName(QStringLiteral("glue-reach-slider"));
  slider_->setRange(0, kSteps);
  slider_->setToolTip(tr("How near a node must be to be glued, cm; about half a cell is usual"));
  NumberFormat format;
  format.dimension = Dimension::length;
  format.least = 0.001;
  format.logarithmic = true;
  reach_ = new NumberField(format, box);
  reach_->setObjectName(QStringLiteral("glue-reach"));
  reach_->setFixedWidth(84);
  reach_->setToolTip(slider_->toolTip());
  counts_ = wrapping(box, QStringLiteral("glue-counts"));
  problem_ = wrapping(box, QStringLiteral("glue-problem"));
  everywhere_ = new QPushButton(tr("Glue Everywhere in Reach"), box);
  everywhere_->setObjectName(QStringLiteral("glue-everywhere"));
  everywhere_->setToolTip(tr("Not only inside the green box"));
  connect(everywhere_, &QPushButton::clicked, &editing_, [this] { editing_.setRegion(std::nullopt); });
  useNearest_ = new QPushButton(box);
  useNearest_->setObjectName(QStringLiteral("glue-use-nearest"));
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Reach"), box));
  row->addWidget(slider_, 1);
  row->addWidget(reach_);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(counts_);
  column->addWidget(problem_);
  column->addWidget(useNearest_);
  column->addWidget(everywhere_);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int step) { editing_.setReach(reachOf(step), !slider_->isSliderDown()); });
  connect(slider_, &QSlider::sliderReleased, this,
          [this] { editing_.setReach(editing_.gluing().reach, true); });
  connect(reach_, &NumberField::edited, this, [this](std::optional<double> value, bool finished) {
    if (value) editing_.setReach(*value, finished);
  });
  connect(useNearest_, &QPushButton::clicked, &editing_, &GlueEditing::reachNearest);
  return box;
}

QWidget* GluePanel::makeButtons() {
  auto* box = new QWidget(this);
  glue_ = new QPushButton(tr("Glue"), box);
  glue_->setObjectName(QStringLiteral("glue-glue"));
  glue_->setToolTip(tr("Put this gluing into the scene"));
  glue_->setDefault(true);
  remove_ = new QPushButton(tr("Delete"), box);
  remove_->setObjectName(QStringLiteral("glue-remove"));
  remove_->setToolTip(tr("Take this gluing out of the scene"));
  close_ = new QPushButton(tr("Cancel"), box);
  close_->setObjectName(QStringLiteral("glue-close"));
  close_->setToolTip(tr("Leave the glue tool (Esc)"));
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(remove_);
  row->addStretch();
  row->addWidget(close_);
  row->addWidget(glue_);
  connect(glue_, &QPushButton::clicked, &editing_, &GlueEditing::glue);
  connect(remove_, &QPushButton::clicked, &editing_, &GlueEditing::remove);
  connect(close_, &QPushButton::clicked, &editing_, &GlueEditing::end);
  return box;
}

QString GluePanel::countsText() const {
  const auto& outcome = editing_.outcome();
  if (!outcome || outcome->problem) return {};
  const modeling::GlueReport& report = outcome->report;
  const std::size_t pairs = outcome->links.size();
  QStringList lines;
  lines << (pairs == 1 ? tr("1 pair, %1 cm apart") : tr("%1 pairs, the farthest %2 cm apart").arg(pairs))
               .arg(report.worstDistance, 0, 'g', 3);
  if (!outcome->freed.empty()) lines << tr("%1 taken out").arg(outcome->freed.size());
  if (report.nodesReleased > 0) lines << tr("%1 let go, lest a cell be twisted").arg(report.nodesReleased);
  if (report.nodesTaken > 0) lines << tr("%1 glued elsewhere already").arg(report.nodesTaken);
  if (report.cellsDropped > 0)
    lines << (report.cellsDropped == 1 ? tr("1 cell dropped")
                                       : tr("%1 cells dropped").arg(report.cellsDropped));
  if (report.wedges > 0)
    lines << (report.wedges == 1 ? tr("1 cell became a wedge")
                                 : tr("%1 cells became wedges").arg(report.wedges));
  if (report.bent > 0)
    lines << (report.bent == 1 ? tr("1 cell has a flat corner")
                               : tr("%1 cells have a flat corner").arg(report.bent));
  return lines.join(u'\n');
}

QString GluePanel::problemText() const {
  const auto& outcome = editing_.outcome();
  if (!outcome || !outcome->problem) return {};
  return textOf(*outcome->problem);
}

void GluePanel::follow() {
  using Stage = GlueEditing::Stage;
  const Stage stage = editing_.stage();
  setVisible(stage != Stage::off);
  if (stage == Stage::off) return;
  const modeling::Gluing& gluing = editing_.gluing();
  const bool adjusts = stage == Stage::adjust;
  const QString a = QString::fromStdString(gluing.a);
  title_->setText(adjusts ? tr("%1 to %2").arg(a, QString::fromStdString(gluing.b)) : tr("Glue"));
  step_->setVisible(!adjusts);
  step_->setText(stage == Stage::chooseA ? tr("1. Click the part to glue, such as a handle.")
                                         : tr("2. Click the part to glue %1 to.").arg(a));
  adjust_->setVisible(adjusts);
  swap_->setVisible(adjusts);
  glue_->setVisible(adjusts && !editing_.isExisting());
  remove_->setVisible(adjusts && editing_.isExisting());
  close_->setText(editing_.isExisting() ? tr("Done") : tr("Cancel"));
  {
    const QSignalBlocker blocker(slider_);
    if (!slider_->isSliderDown()) slider_->setValue(stepOf(gluing.reach));
  }
  reach_->setValue(gluing.reach);
  const Colours& colours = Theme::instance().colours();
  const QString problem = problemText();
  tint(counts_, colours.text);
  tint(problem_, colours.bad);
  counts_->setText(editing_.outcome() ? countsText() : tr("Looking for pairs"));
  counts_->setVisible(!counts_->text().isEmpty());
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  glue_->setEnabled(problem.isEmpty());
  const bool offers = editing_.outcome() && editing_.outcome()->nearest;
  everywhere_->setVisible(gluing.region.has_value());
  useNearest_->setVisible(offers);
  if (offers)
    useNearest_->setText(
        tr("Reach the nearest: %1 cm").arg(editing_.outcome()->nearest->distance(), 0, 'g', 3));
  placeInCorner();
}

void GluePanel::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.line, 1.0));
  painter.setBrush(colours.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6.0, 6.0);
}

void GluePanel::placeInCorner() {
  layout()->activate();
  resize(kWidth, layout()->totalHeightForWidth(kWidth));
  // Beside the bar of tools, and below that of what is shown where the picture is narrow.
  QRect place(kMargin, kMargin, width(), height());
  for (const QWidget* bar : parentWidget()->findChildren<QWidget*>(QStringLiteral("viewBar"))) {
    const QRect taken = bar->geometry();
    if (taken.left() <= kMargin) place.moveLeft(taken.right() + kMargin);
    if (taken.left() > kMargin && taken.intersects(place)) place.moveTop(taken.bottom() + kMargin);
  }
  move(place.topLeft());
}

}  // namespace ui
