#include "ui/window/gallery.h"

#include <QFile>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "modeling/scene/resources.h"
#include "ui/theme/theme.h"
#include "ui/window/card_grid.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".scene.json";

QString stem(const fs::path& file) {
  QString name = QString::fromStdString(file.filename().string());
  for (const char* ending : {kEnding, ".take", ".json"}) {
    if (name.endsWith(QLatin1String(ending))) return name.chopped(static_cast<int>(qstrlen(ending)));
  }
  return name;
}

/// "teapot-drop" is "Teapot drop".
QString titleOf(const QString& stem) {
  QString title = stem;
  title.replace('-', ' ').replace('_', ' ');
  if (!title.isEmpty()) title[0] = title[0].toUpper();
  return title;
}

/// The scene's own name, without reading all of it: a gallery should not be slower than what it shows.
QString nameIn(const fs::path& file) {
  QFile opened(QString::fromStdString(file.string()));
  if (!opened.open(QIODevice::ReadOnly)) return {};
  return QJsonDocument::fromJson(opened.readAll()).object()["name"].toString();
}

std::vector<fs::path> shippedScenes() {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(modeling::resourcesFolder() / "scenes", error)) {
    if (entry.path().filename().string().ends_with(kEnding)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

Gallery::Gallery(RecentFiles& recent, QWidget* parent) : QScrollArea(parent), recent_(recent) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  // Five cards beside each other, in the middle of whatever room there is.
  constexpr int kWidest = 1600;  // logical pixels
  auto* page = new QWidget(this);
  page->setMaximumWidth(kWidest);
  setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  auto* layout = new QVBoxLayout(page);
  layout->setContentsMargins(36, 30, 36, 36);
  layout->setSpacing(12);
  layout->addWidget(makeHead());
  recentHeading_ = heading(tr("Recent"));
  recentCards_ = new CardGrid(page);
  sceneCards_ = new CardGrid(page);
  layout->addWidget(recentHeading_);
  layout->addWidget(recentCards_);
  layout->addWidget(heading(tr("Scenes to start from")));
  layout->addWidget(sceneCards_);
  layout->addStretch(1);
  setWidget(page);
  addScenes();
  showRecent();
  connect(&recent_, &RecentFiles::changed, this, &Gallery::showRecent);
}

fs::path Gallery::sceneFile(const QString& name) {
  return modeling::resourcesFolder() / "scenes" / (name.toStdString() + kEnding);
}

QWidget* Gallery::makeHead() {
  auto* head = new QWidget(this);
  auto* layout = new QHBoxLayout(head);
  layout->setContentsMargins(0, 0, 0, 10);
  auto* words = new QVBoxLayout;
  auto* title = new QLabel(tr("Smithereens"), head);
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 2.1);
  large.setWeight(QFont::DemiBold);
  title->setFont(large);
  auto* line = new QLabel(tr("Build dishes from springs. Drop them."), head);
  words->addWidget(title);
  words->addWidget(line);
  layout->addLayout(words, 1);
  auto* fresh = new QPushButton(Theme::icon("file-new"), tr("New scene"), head);
  auto* open = new QPushButton(Theme::icon("folder-open"), tr("Open…"), head);
  fresh->setObjectName("galleryNew");
  fresh->setDefault(true);
  connect(fresh, &QPushButton::clicked, this, &Gallery::newWanted);
  connect(open, &QPushButton::clicked, this, &Gallery::openWanted);
  layout->addWidget(fresh, 0, Qt::AlignBottom);
  layout->addWidget(open, 0, Qt::AlignBottom);
  return head;
}

QLabel* Gallery::heading(const QString& text) {
  auto* label = new QLabel(text, this);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.15);
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  label->setContentsMargins(0, 10, 0, 0);
  return label;
}

void Gallery::addScenes() {
  const fs::path pictures = modeling::resourcesFolder() / "pictures";
  for (const fs::path& file : shippedScenes()) {
    const QString name = stem(file);
    const QImage picture(QString::fromStdString((pictures / (name.toStdString() + ".jpg")).string()));
    auto* card = new Card(titleOf(name), nameIn(file), picture);
    card->setObjectName(name);
    connect(card, &Card::clicked, this, [this, file] { emit fileWanted(file); });
    sceneCards_->add(card);
  }
}

void Gallery::showRecent() {
  recentCards_->clear();
  constexpr std::size_t kShown = 6;
  const std::vector<fs::path> files = recent_.files();
  for (std::size_t i = 0; i < std::min(kShown, files.size()); ++i) {
    const fs::path& file = files[i];
    auto* card = new Card(titleOf(stem(file)), QString::fromStdString(file.parent_path().string()),
                          recent_.picture(file));
    if (file.extension() == ".take") card->setIconName("film");
    connect(card, &Card::clicked, this, [this, file] { emit fileWanted(file); });
    recentCards_->add(card);
  }
  recentHeading_->setVisible(!recentCards_->isEmpty());
  recentCards_->setVisible(!recentCards_->isEmpty());
}

}  // namespace ui
