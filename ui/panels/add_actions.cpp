#include "ui/panels/add_actions.h"

#include <QAction>
#include <QCursor>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>

#include "modeling/import/mesh_file.h"
#include "ui/document/stored_path.h"
#include "ui/panels/dish_picture.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

QIcon iconFor(const NewThing& thing) {
  return thing.preset ? dishIcon(*thing.preset) : Theme::icon(thing.icon);
}

/// The first letter that no other entry of the menu has chooses it.
QString withFreeLetter(QString title, QString& taken) {
  for (qsizetype i = 0; i < title.size(); ++i) {
    const QChar letter = title[i].toLower();
    if (!letter.isLetter() || taken.contains(letter)) continue;
    taken += letter;
    return title.insert(i, u'&');
  }
  return title;
}

}  // namespace

AddActions::AddActions(Session& session, QWidget* window)
    : QObject(window), session_(session), window_(window), open_(new QAction(tr("Add"), this)) {
  open_->setIcon(Theme::icon(QStringLiteral("add")));
  open_->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_A));
  open_->setToolTip(tr("Add a dish, another part or an obstacle (Shift+A)"));
  open_->setObjectName(QStringLiteral("add"));
  window->addAction(open_);
  connect(open_, &QAction::triggered, this, &AddActions::openMenu);
}

void AddActions::fill(QMenu& menu) {
  bool dishes = true;
  bool colliders = false;
  QString taken = QStringLiteral("nmo");  // by what comes from a file
  for (const NewThing& thing : newThings()) {
    if (dishes && !thing.preset) menu.addSeparator();
    dishes = thing.preset.has_value();
    if (!colliders && thing.isCollider()) {
      menu.addAction(Theme::icon(QStringLiteral("network")), tr("&Network from a File…"), this,
                     &AddActions::addNetworkFile);
      menu.addAction(Theme::icon(QStringLiteral("mesh")), tr("&Mesh from a File…"), this,
                     [this] { addMeshFile(false); });
      menu.addAction(Theme::icon(QStringLiteral("mesh-obstacle")), tr("&Obstacle from a File…"), this,
                     [this] { addMeshFile(true); });
      menu.addSeparator();
      colliders = true;
    }
    QAction* action = menu.addAction(iconFor(thing), withFreeLetter(thing.title, taken), this,
                                     [this, thing] { add(thing); });
    action->setToolTip(thing.help);
    action->setStatusTip(thing.help);
  }
  menu.setToolTipsVisible(true);
}

void AddActions::openMenu() {
  QMenu menu(window_);
  fill(menu);
  menu.exec(QCursor::pos());
}

void AddActions::finish(const QString& name, const std::function<Item(modeling::Scene&)>& change) {
  Item item;
  session_.document().edit(name, [&](modeling::Scene& scene) { item = change(scene); });
  session_.selection().select(item);
  emit added(item);
}

void AddActions::add(const NewThing& thing) {
  const std::vector<Item> selected = session_.selection().items();
  finish(tr("Add %1").arg(thing.title),
         [&](modeling::Scene& scene) { return addThing(scene, thing, selected); });
}

void AddActions::addNetworkFile() {
  const QString file =
      QFileDialog::getOpenFileName(window_, tr("Network of Nodes and Bonds"),
                                   QString::fromStdString(session_.document().folder().string()),
                                   tr("LAMMPS data (*.data *.lmp *.lammps);;All files (*)"));
  if (file.isEmpty()) return;
  const int types = bondTypesAnnounced(file);
  if (types == 0)
    return session_.report({file.toStdString(), "this is no LAMMPS data file with bonds",
                            "choose a file that says \"N bond types\" in its head"});
  const std::string path = storedPath(file.toStdString(), session_.document().folder());
  finish(tr("Add Network"), [&](modeling::Scene& scene) { return addNetwork(scene, path, types); });
}

void AddActions::addMeshFile(bool obstacle) {
  QString endings;
  for (const std::string& ending : modeling::meshFileEndings())
    endings += " *" + QString::fromStdString(ending);
  const QString file =
      QFileDialog::getOpenFileName(window_, obstacle ? tr("Mesh to Collide With") : tr("Closed Mesh"),
                                   QString::fromStdString(session_.document().folder().string()),
                                   tr("Meshes (%1);;All files (*)").arg(endings.trimmed()));
  if (!file.isEmpty()) addMeshOf(file, obstacle);
}

bool AddActions::isMesh(const std::filesystem::path& file) {
  const QString ending = QString::fromStdString(file.extension().string()).toLower();
  return std::ranges::any_of(modeling::meshFileEndings(),
                             [&](const std::string& one) { return QString::fromStdString(one) == ending; });
}

void AddActions::askAboutMesh(const std::filesystem::path& file) {
  QMessageBox question(QMessageBox::Question, tr("Add a Mesh"),
                       tr("Add “%1” as what?").arg(QString::fromStdString(file.filename().string())),
                       QMessageBox::Cancel, window_);
  question.setInformativeText(
      tr("A part is filled with cells and can break; an obstacle stands in the way."));
  const QAbstractButton* part = question.addButton(tr("Part"), QMessageBox::AcceptRole);
  const QAbstractButton* obstacle = question.addButton(tr("Obstacle"), QMessageBox::AcceptRole);
  question.exec();
  if (question.clickedButton() == part || question.clickedButton() == obstacle)
    addMeshOf(QString::fromStdString(file.string()), question.clickedButton() == obstacle);
}

void AddActions::addMeshOf(const QString& file, bool obstacle) {
  const std::string path = storedPath(file.toStdString(), session_.document().folder());
  const std::vector<Item> selected = session_.selection().items();
  finish(obstacle ? tr("Add Obstacle") : tr("Add Mesh"), [&](modeling::Scene& scene) {
    return obstacle ? addMeshObstacle(scene, path) : addMesh(scene, path, selected);
  });
}

int bondTypesAnnounced(const QString& name) {
  constexpr int kHeadLines = 60;
  constexpr int kMostTypes = 1000;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return 0;
  static const QRegularExpression announcement(QStringLiteral("^\\s*(\\d{1,6})\\s+bond\\s+types"));
  for (int line = 0; line < kHeadLines && !file.atEnd(); ++line) {
    constexpr qint64 kLongest = 400;
    const auto match = announcement.match(QString::fromLatin1(file.readLine(kLongest)));
    if (match.hasMatch()) return std::min(match.captured(1).toInt(), kMostTypes);
  }
  return 0;
}

}  // namespace ui
