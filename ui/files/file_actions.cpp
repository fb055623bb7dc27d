#include "ui/files/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>

#include "modeling/exchange/take_scene.h"
#include "modeling/files/output_file.h"
#include "modeling/files/output_guard.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/salvage.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_files.h"
#include "ui/document/new_scene.h"
#include "ui/files/opened_file.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

const QString kSceneEnding = QStringLiteral(".scene.json");

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

/// Where people keep what they make.
QString documentsFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

bool isTake(const fs::path& file) {
  return file.extension() == ".take";
}

}  // namespace

FileActions::FileActions(Session& session, RecentFiles& recent, QWidget* window)
    : QObject(window), session_(session), recent_(recent), window_(window) {
  const auto action = [&](const QString& icon, const QString& name, const QKeySequence& key, auto slot) {
    auto* made = new QAction(Theme::icon(icon), name, this);
    made->setShortcut(key);
    if (!key.isEmpty())
      made->setToolTip(QStringLiteral("%1 (%2)").arg(QString(name).remove(u'&').remove(u'…'),
                                                     key.toString(QKeySequence::NativeText)));
    connect(made, &QAction::triggered, this, slot);
    return made;
  };
  new_ = action("file-new", tr("&New"), QKeySequence::New, [this] { newScene(); });
  open_ = action("folder-open", tr("&Open…"), QKeySequence::Open, [this] { askWhatToOpen(); });
  save_ = action("save", tr("&Save"), QKeySequence::Save, [this] { save(); });
  saveAs_ =
      action("save", tr("Save &As…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { saveAs(); });
  reload_ = action("restart", tr("Re&load"), {}, [this] { reload(); });
  saveTake_ = action("film", tr("Save &Take As…"), {}, [this] {
    const auto take = session_.takes().current();
    if (!take) return;
    const QString name = QFileDialog::getSaveFileName(window_, tr("Save the take"), {}, tr("Takes (*.take)"));
    if (name.isEmpty()) return;
    if (const sim::Status saved = session_.takes().save(*take, name.toStdString()); !saved)
      session_.report(saved.problem());
  });
  new OpenedFile(session_, this);
  connect(&session_.document(), &Document::statusChanged, this,
          [this] { reload_->setEnabled(!session_.document().file().empty()); });
  reload_->setEnabled(false);
  const auto judge = [this] { saveTake_->setEnabled(session_.takes().current() && !session_.hasRun()); };
  connect(&session_.takes(), &TakeList::changed, this, judge);
  connect(&session_, &Session::runChanged, this, judge);
  judge();
}

void FileActions::addTo(QMenu& menu) {
  menu.addAction(new_);
  menu.addAction(open_);
  QMenu* recent = menu.addMenu(Theme::icon("clock"), tr("Open &Recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { showRecent(*recent); });
  menu.addSeparator();
  menu.addAction(save_);
  menu.addAction(saveAs_);
  menu.addAction(reload_);
  menu.addAction(saveTake_);
}

void FileActions::showRecent(QMenu& menu) {
  menu.clear();
  for (const fs::path& file : recent_.files()) {
    QAction* action = menu.addAction(text(file.filename()), this, [this, file] { open(file); });
    action->setToolTip(text(file));
  }
  if (menu.isEmpty()) menu.addAction(tr("Nothing yet"))->setEnabled(false);
  menu.addSeparator();
  menu.addAction(tr("Clear"), &recent_, &RecentFiles::clear);
}

bool FileActions::mayLeave() {
  const Document& document = session_.document();
  // Takes of a scene that has a file are kept with it.
  const bool takes = document.file().empty() && session_.takes().hasOwn();
  if (!document.isModified() && !takes) return true;
  const QString words = takes ? tr("Save “%1” and its takes?") : tr("Save the changes to “%1”?");
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"), words.arg(document.title()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question.setInformativeText(tr("They are lost otherwise."));
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void FileActions::newScene() {
  if (!mayLeave()) return;
  session_.document().reset(ui::newScene(), {});
  emit opened();
}

void FileActions::askWhatToOpen() {
  const QString folder = session_.document().file().empty() ? text(modeling::resourcesFolder() / "scenes")
                                                            : text(session_.document().folder());
  const QString name = QFileDialog::getOpenFileName(window_, tr("Open"), folder,
                                                    tr("Scenes and takes (*.scene.json *.json *.take)"));
  if (!name.isEmpty()) open(name.toStdString());
}

bool FileActions::canOpen(const fs::path& file) {
  return isTake(file) || file.extension() == ".json";
}

void FileActions::open(const fs::path& file) {
  if (isTake(file)) {
    openTake(file);
  } else {
    openScene(file);
  }
}

void FileActions::openScene(const fs::path& file) {
  // Before it is read: what changes it meanwhile is noticed.
  const modeling::FileStamp stamp = modeling::FileStamp::of(file);
  sim::Result<modeling::SalvagedScene> salvaged = modeling::salvageScene(file);
  if (!salvaged) {
    recent_.remove(file);
    session_.report(salvaged.problem());
    return;
  }
  if (!mayLeave()) return;
  session_.document().reset(std::move(salvaged->scene), file, stamp);
  recent_.add(file);
  emit opened();
  if (!salvaged->notes.empty()) tell(salvaged->notes);
  if (!salvaged->faults.empty()) showFaults(salvaged->faults);
}

/// Keys that mean nothing any more are gone with the next saving.
void FileActions::tell(const std::vector<sim::Problem>& notes) {
  const sim::Problem& first = notes.front();
  std::string remedy = "save the scene to leave it out";
  if (notes.size() > 1)
    remedy = "save the scene to leave out this and " + std::to_string(notes.size() - 1) +
             (notes.size() == 2 ? " more such key" : " more such keys");
  session_.report({first.place, first.what, remedy});
}

/// What is open now lacks what was left out: it counts as changed, and is not saved over the file without
/// asking.
void FileActions::showFaults(const std::vector<sim::Problem>& faults) {
  session_.document().detachFromFile();
  const auto count = static_cast<int>(faults.size());
  QMessageBox report(QMessageBox::Warning, tr("Opened in part"),
                     tr("%n thing(s) in this file could not be read and were left out.", nullptr, count),
                     QMessageBox::Ok, window_);
  report.setInformativeText(QString::fromStdString(faults.front().line()));
  QStringList lines;
  for (const sim::Problem& fault : faults) lines.append(QString::fromStdString(fault.line()));
  if (count > 1) report.setDetailedText(lines.join('\n'));
  report.exec();
}

/// A take is looked at beside the scene that is open; where none is, its own scene is opened with it.
void FileActions::openTake(const fs::path& file) {
  const bool empty = session_.document().scene().parts.empty() && !session_.document().isModified();
  if (empty) {
    const auto reader = sim::TakeReader::open(file);
    sim::Result<modeling::Scene> scene =
        reader ? modeling::sceneOf(**reader) : sim::Result<modeling::Scene>(reader.problem());
    if (!scene) {
      session_.report(scene.problem());
      return;
    }
    session_.document().reset(std::move(scene).value(), {}, file.parent_path());
  }
  if (const sim::Status opened = session_.takes().open(file); !opened) {
    session_.report(opened.problem());
    return;
  }
  recent_.add(file);
  emit this->opened();
}

bool FileActions::saveTo(const fs::path& file) {
  modeling::OutputGuard guard;
  const Document& document = session_.document();
  guard.reads(modeling::filesOf(document.scene(), document.folder()));
  // Its own file is a scene, whatever has become of it.
  if (file != document.file()) guard.writes(file, modeling::kinds::scene);
  sim::Status saved = guard.check();
  if (saved) saved = session_.document().saveTo(file);
  if (!saved) session_.report(saved.problem());
  return saved.ok();
}

bool FileActions::save() {
  const fs::path& file = session_.document().file();
  return file.empty() || modeling::comesWithProgram(file) ? saveAs() : saveHere();
}

bool FileActions::saveHere() {
  const Document& document = session_.document();
  const modeling::FileChange change = document.changeOfFile();
  return change == modeling::FileChange::none ? saveTo(document.file()) : saveOverChange(change);
}

/// Somebody else has changed the file since it was read: the later does not win without being asked.
bool FileActions::saveOverChange(modeling::FileChange change) {
  const Document& document = session_.document();
  const bool gone = change == modeling::FileChange::gone;
  const QString words = gone ? tr("The file of “%1” was deleted or renamed by somebody else.")
                             : tr("The file of “%1” was changed by somebody else.");
  QMessageBox question(QMessageBox::Warning, tr("Save"), words.arg(document.title()), QMessageBox::NoButton,
                       window_);
  question.setInformativeText(
      gone ? text(document.file())
           : tr("%1\nChanged there: %2.\nTo save anyway keeps the other version beside it; to reload can be "
                "undone.")
                 .arg(text(document.file()), changeInWords(document)));
  QPushButton* anyway = question.addButton(tr("Save Anyway"), QMessageBox::DestructiveRole);
  QPushButton* as = question.addButton(tr("Save As…"), QMessageBox::AcceptRole);
  QPushButton* reloads = gone ? nullptr : question.addButton(tr("Reload"), QMessageBox::ActionRole);
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(as);
  question.exec();
  const QAbstractButton* chosen = question.clickedButton();
  if (chosen == anyway) return (gone || keepOther()) && saveTo(document.file());
  if (chosen == as) return saveAs();
  if (reloads != nullptr && chosen == reloads) reload();
  return false;
}

/// "cup.scene.json" is copied to "cup.other-1.scene.json".
bool FileActions::keepOther() const {
  const fs::path& file = session_.document().file();
  std::string name = file.filename().string();
  const std::size_t dot = std::min(name.find('.', 1), name.size());
  fs::path other;
  std::error_code error;
  for (int number = 1; other.empty() || fs::exists(fs::symlink_status(other, error)); ++number)
    other =
        file.parent_path() / (name.substr(0, dot) + ".other-" + std::to_string(number) + name.substr(dot));
  const sim::Status kept = modeling::replaceByCopy(other, file);
  if (!kept) session_.report(kept.problem());
  return kept.ok();
}

void FileActions::reload() {
  Document& document = session_.document();
  const modeling::FileStamp stamp = modeling::FileStamp::of(document.file());
  sim::Result<modeling::SceneFile> read = modeling::loadScene(document.file());
  if (!read) return session_.report(read.problem());
  document.takeFromFile(std::move(read->scene), stamp);
  if (!read->notes.empty()) tell(read->notes);
}

bool FileActions::saveAs() {
  const fs::path& own = session_.document().file();
  QString start = text(own);
  if (own.empty()) start = documentsFolder() + u'/' + session_.document().title() + kSceneEnding;
  if (modeling::comesWithProgram(own)) start = documentsFolder() + u'/' + text(own.filename());
  QString name = QFileDialog::getSaveFileName(window_, tr("Save the scene"), start,
                                              tr("Scenes (*%1)").arg(kSceneEnding));
  if (name.isEmpty()) return false;
  if (QFileInfo(name).suffix().isEmpty()) name += kSceneEnding;
  const fs::path file = name.toStdString();
  std::error_code error;
  // Its own file, too, may have been changed by somebody else.
  if (!own.empty() && fs::equivalent(file, own, error)) return saveHere();
  if (!saveTo(file)) return false;
  recent_.add(file);
  return true;
}

}  // namespace ui
