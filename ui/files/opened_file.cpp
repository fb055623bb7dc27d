#include "ui/files/opened_file.h"

#include <QGuiApplication>

#include "modeling/files/output_file.h"
#include "modeling/scene/scene_file.h"
#include "ui/timeline/scene_difference.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr int kSettled = 300;  // ms

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

OpenedFile::OpenedFile(Session& session, QObject* parent) : QObject(parent), session_(session) {
  settled_.setSingleShot(true);
  settled_.setInterval(kSettled);
  connect(&settled_, &QTimer::timeout, this, &OpenedFile::look);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &settled_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &settled_, qOverload<>(&QTimer::start));
  connect(&session_.document(), &Document::statusChanged, this, &OpenedFile::follow);
  // Not every file system tells.
  connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
    if (state == Qt::ApplicationActive) settled_.start();
  });
}

void OpenedFile::follow() {
  const Document& document = session_.document();
  told_ = document.fileStamp();
  toldGone_ = false;
  if (document.file() == file_) return;
  file_ = document.file();
  if (const QStringList watched = watcher_.files() + watcher_.directories(); !watched.isEmpty())
    watcher_.removePaths(watched);
  watch();
}

/// The folder too: a file that is replaced is another one, which nobody watches yet.
void OpenedFile::watch() {
  if (file_.empty()) return;
  const fs::path target = modeling::linkTarget(file_);
  for (const fs::path& path : {file_, target, file_.parent_path(), target.parent_path()}) {
    const QString name = text(path);
    if (name.isEmpty() || watcher_.files().contains(name) || watcher_.directories().contains(name)) continue;
    std::error_code error;
    if (fs::exists(path, error)) watcher_.addPath(name);
  }
}

void OpenedFile::look() {
  watch();
  const Document& document = session_.document();
  const modeling::FileChange change = document.changeOfFile();
  if (change == modeling::FileChange::gone && !std::exchange(toldGone_, true)) {
    session_.report({file_.string(), "the file of this scene was deleted or renamed by somebody else",
                     "save the scene to have it again"});
  }
  if (change == modeling::FileChange::gone) return;
  toldGone_ = false;
  const modeling::FileStamp now = modeling::FileStamp::of(file_);
  if (now == std::exchange(told_, now) || change == modeling::FileChange::none) return;
  session_.report(
      {file_.string(),
       "the file of this scene was changed by somebody else (" + changeInWords(document).toStdString() + ")",
       "File, Reload takes it over; saving asks first"});
}

QString changeInWords(const Document& document) {
  const auto theirs = modeling::loadScene(document.file());
  if (!theirs) return OpenedFile::tr("it is no whole scene any more");
  QStringList found = differencesOf(document.savedScene(), theirs->scene);
  if (document.savedScene().name != theirs->scene.name) found << OpenedFile::tr("name");
  if (document.savedScene().view != theirs->scene.view) found << OpenedFile::tr("view and pictures");
  return found.isEmpty() ? OpenedFile::tr("only how it is written") : found.join(QStringLiteral(", "));
}

}  // namespace ui
