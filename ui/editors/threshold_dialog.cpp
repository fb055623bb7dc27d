#include "ui/editors/threshold_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/editors/calibration_chart.h"
#include "ui/editors/problem_text.h"
#include "ui/panels/number_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kPollMilliseconds = 60;

NumberField* field(Dimension dimension, double least, double value, const QString& tip, QWidget* parent) {
  NumberFormat format;
  format.dimension = dimension;
  format.least = least;
  format.logarithmic = true;
  auto* made = new NumberField(format, parent);
  made->setValue(value);
  made->setDefault(value);
  made->setToolTip(tip);
  return made;
}

QString number(double value) {
  return QString::number(value, 'g', 2);
}

}  // namespace

ThresholdDialog::ThresholdDialog(Session& session, std::size_t material, QWidget* parent)
    : QDialog(parent), session_(session) {
  setObjectName(QStringLiteral("threshold-dialog"));
  setWindowTitle(tr("Tune Threshold"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(680, 520);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 14, 16, 14);
  layout->setSpacing(10);
  auto* what =
      new QLabel(tr("Drops small hollow cylinders of the material with ever lower thresholds, from where "
                    "nothing breaks down to where they crumble. Between the two lies the threshold at "
                    "which things break well."),
                 this);
  what->setWordWrap(true);
  layout->addWidget(what);
  layout->addWidget(makeSettings(material));
  chart_ = new CalibrationChart(this);
  layout->addWidget(chart_, 1);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("threshold-state"));
  state_->setWordWrap(true);
  layout->addWidget(state_);
  layout->addWidget(makeButtons());
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &ThresholdDialog::poll);
  connect(&session_.document(), &Document::sceneChanged, this, &ThresholdDialog::listMaterials);
  connect(&session_.document(), &Document::replaced, this, &QDialog::reject);
  showState();
}

QWidget* ThresholdDialog::makeSettings(std::size_t material) {
  auto* box = new QWidget(this);
  material_ = new QComboBox(box);
  material_->setObjectName(QStringLiteral("threshold-material"));
  speed_ = field(Dimension::velocity, 1.0, modeling::CalibrationSettings{}.speed,
                 tr("How fast a sample meets the floor, cm/s; 400 is a fall from 80 cm"), box);
  speed_->setObjectName(QStringLiteral("threshold-speed"));
  cellSize_ =
      field(Dimension::length, 0.05, modeling::CalibrationSettings{}.cellSize,
            tr("Size of the samples' cells, cm; that of the parts made of the material, for which the "
               "threshold will be right"),
            box);
  cellSize_->setObjectName(QStringLiteral("threshold-cell-size"));
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Material"), box));
  row->addWidget(material_, 1);
  row->addSpacing(8);
  row->addWidget(new QLabel(tr("Speed"), box));
  row->addWidget(speed_);
  row->addSpacing(8);
  row->addWidget(new QLabel(tr("Cell size"), box));
  row->addWidget(cellSize_);
  listMaterials();
  material_->setCurrentIndex(static_cast<int>(material));
  connect(material_, &QComboBox::currentIndexChanged, this, &ThresholdDialog::proposeCellSize);
  proposeCellSize();
  return box;
}

QWidget* ThresholdDialog::makeButtons() {
  auto* box = new QWidget(this);
  busy_ = new QProgressBar(box);
  busy_->setRange(0, 0);
  busy_->setFixedWidth(120);
  busy_->setTextVisible(false);
  start_ = new QPushButton(box);
  start_->setObjectName(QStringLiteral("threshold-start"));
  use_ = new QPushButton(box);
  use_->setObjectName(QStringLiteral("threshold-use"));
  use_->setToolTip(tr("Give the material this threshold, in place of a strength or toughness it may have"));
  auto* close = new QPushButton(tr("Close"), box);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(start_);
  row->addWidget(busy_);
  row->addStretch();
  row->addWidget(close);
  row->addWidget(use_);
  connect(start_, &QPushButton::clicked, this, [this] {
    if (run_ && !progress_.ended) {
      run_->cancel();
      start_->setEnabled(false);
    } else {
      start();
    }
  });
  connect(use_, &QPushButton::clicked, this, &ThresholdDialog::use);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return box;
}

void ThresholdDialog::listMaterials() {
  const QString chosen = material_->currentText();
  const int place = material_->currentIndex();
  const int count = material_->count();
  const QSignalBlocker blocker(material_);
  material_->clear();
  for (const modeling::SceneMaterial& listed : session_.document().scene().materials)
    material_->addItem(QString::fromStdString(listed.name));
  // One that has another name now stands where it stood.
  const bool renamed = material_->findText(chosen) < 0 && material_->count() == count;
  material_->setCurrentIndex(renamed ? place : material_->findText(chosen));
  if (renamed && tuned_ == chosen.toStdString()) tuned_ = material_->currentText().toStdString();
  if (start_ != nullptr) showState();
}

const modeling::SceneMaterial* ThresholdDialog::material() const {
  const std::string name = material_->currentText().toStdString();
  for (const modeling::SceneMaterial& listed : session_.document().scene().materials)
    if (listed.name == name) return &listed;
  return nullptr;
}

bool ThresholdDialog::isThere(const std::string& name) const {
  const auto& listed = session_.document().scene().materials;
  return std::ranges::find(listed, name, &modeling::SceneMaterial::name) != listed.end();
}

/// The cells of a part of the material, as the threshold is to suit it.
void ThresholdDialog::proposeCellSize() {
  const std::string name = material_->currentText().toStdString();
  for (const modeling::Part& part : session_.document().scene().parts) {
    if (part.material != name) continue;
    if (const auto edge = modeling::cellEdgeOf(part.shape)) cellSize_->setValue(*edge);
    return;
  }
}

void ThresholdDialog::start() {
  const modeling::SceneMaterial* chosen = material();
  if (chosen == nullptr) return;
  modeling::CalibrationSettings settings;
  settings.speed = speed_->value().value_or(settings.speed);
  settings.cellSize = cellSize_->value().value_or(settings.cellSize);
  tuned_ = chosen->name;
  progress_ = {};
  run_ = std::make_unique<CalibrationRun>(chosen->values, settings);
  timer_.start();
  chart_->plot(progress_);
  showState();
}

void ThresholdDialog::poll() {
  if (!run_) return;
  const std::size_t before = progress_.trials.size();
  progress_ = run_->progress();
  if (progress_.ended) timer_.stop();
  if (progress_.ended || progress_.trials.size() != before) chart_->plot(progress_);
  showState();
}

QString ThresholdDialog::stateText() const {
  if (!run_) return tr("Nothing dropped yet.");
  if (progress_.problem) return textOf(*progress_.problem);
  const QString last = progress_.trials.empty() ? QString()
                                                : tr("%1 at %2")
                                                      .arg(verdictText(progress_.trials.back().verdict),
                                                           number(progress_.trials.back().threshold));
  if (!progress_.ended)
    return last.isEmpty() ? tr("Dropping the first cylinder") : tr("Dropping. Last: %1").arg(last);
  if (progress_.threshold)
    return tr("%1 breaks well at a threshold of %2.")
        .arg(QString::fromStdString(tuned_), number(*progress_.threshold));
  if (progress_.cancelled) return tr("Stopped before anything broke well.");
  return tr(
      "No threshold let it break into pieces of size: it goes from holding to crumbling at once. Try another "
      "speed, or smaller cells.");
}

void ThresholdDialog::showState() {
  const bool runs = run_ && !progress_.ended;
  busy_->setVisible(runs);
  start_->setText(runs ? tr("Stop") : run_ ? tr("Drop Again") : tr("Drop Samples"));
  if (!runs) start_->setEnabled(material() != nullptr);
  use_->setEnabled(isThere(tuned_));
  start_->setDefault(!runs && !progress_.threshold);
  for (QWidget* widget :
       {static_cast<QWidget*>(material_), static_cast<QWidget*>(speed_), static_cast<QWidget*>(cellSize_)})
    widget->setEnabled(!runs);
  use_->setVisible(progress_.ended && progress_.threshold);
  if (progress_.threshold) use_->setText(tr("Use %1").arg(number(*progress_.threshold)));
  use_->setDefault(use_->isVisibleTo(this));
  state_->setText(stateText());
  QPalette palette = this->palette();
  if (progress_.problem) palette.setColor(QPalette::WindowText, Theme::instance().colours().bad);
  state_->setPalette(palette);
}

void ThresholdDialog::use() {
  if (!progress_.threshold) return;
  // As it is shown: two digits are more than the spread of bonds lets one tell apart.
  const double threshold = number(*progress_.threshold).toDouble();
  session_.document().edit(tr("Threshold of %1").arg(QString::fromStdString(tuned_)),
                           [&](modeling::Scene& scene) {
                             for (modeling::SceneMaterial& listed : scene.materials) {
                               if (listed.name != tuned_) continue;
                               listed.values.threshold.mean = threshold;
                               listed.values.strength.reset();
                               listed.values.fractureToughness.reset();
                             }
                           });
  accept();
}

}  // namespace ui
