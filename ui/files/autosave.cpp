#include "ui/files/autosave.h"

#include <QDateTime>
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>
#include <algorithm>
#include <chrono>

#include "modeling/scene/scene_file.h"
#include "modeling/scene/text_file.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene = "autosave.scene.json";
constexpr const char* kState = "autosave.json";
constexpr const char* kLock = "running";
/// A program that has just made its folder may not have locked it yet.
constexpr std::chrono::minutes kStartingTakes{1};

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

std::vector<fs::path> takesIn(const fs::path& folder) {
  std::vector<fs::path> takes;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".take") takes.push_back(entry.path());
  }
  std::sort(takes.begin(), takes.end());
  return takes;
}

std::optional<Leftover> leftoverIn(const fs::path& folder) {
  Leftover leftover;
  leftover.folder = folder;
  leftover.takes = takesIn(folder);
  const auto state = modeling::readTextFile(folder / kState, std::uintmax_t{1} << 20U);
  if (state) {
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(*state)).object();
    leftover.file = object["file"].toString().toStdString();
    leftover.when = QDateTime::fromString(object["when"].toString(), Qt::ISODate);
  }
  sim::Result<modeling::SceneFile> scene = modeling::loadScene(folder / kScene);
  if (!scene) return std::nullopt;
  leftover.scene = std::move(scene->scene);
  return leftover;
}

}  // namespace

fs::path Autosave::newFolder(const fs::path& root) {
  const std::string name = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  const fs::path folder = root / name;
  std::error_code error;
  fs::create_directories(folder, error);
  return folder;
}

Autosave::Autosave(Session& session, fs::path folder)
    : session_(session), folder_(std::move(folder)), lock_(text(folder_ / kLock)) {
  // A lock whose program runs is never stale, however old.
  lock_.setStaleLockTime(0);
  lock_.tryLock(0);
  regular_.setInterval(kMinutes * 60 * 1000);
  regular_.start();
  afterEdit_.setSingleShot(true);
  afterEdit_.setInterval(kSecondsAfterEdit * 1000);
  connect(&regular_, &QTimer::timeout, this, &Autosave::write);
  connect(&afterEdit_, &QTimer::timeout, this, &Autosave::write);
  connect(&session_.document(), &Document::sceneChanged, &afterEdit_, qOverload<>(&QTimer::start));
  connect(&session_, &Session::runChanged, this, [this] {
    if (!session_.hasRun()) write();
  });
}

Autosave::~Autosave() {
  std::error_code error;
  lock_.unlock();
  fs::remove_all(folder_, error);
}

void Autosave::write() {
  const Document& document = session_.document();
  const bool worthKeeping = document.isModified() || !takesIn(folder_).empty();
  if (!worthKeeping || document.scene().parts.empty() || written_ == document.scene()) return;
  const sim::Status saved = modeling::saveScene(document.scene(), folder_ / kScene);
  QJsonObject state;
  state["file"] = text(document.file());
  state["when"] = QDateTime::currentDateTime().toString(Qt::ISODate);
  const std::string json = QJsonDocument(state).toJson().toStdString();
  const sim::Status noted = modeling::replaceTextFile(folder_ / kState, json);
  if (saved && noted) {
    written_ = document.scene();
  } else {
    session_.report(saved ? noted.problem() : saved.problem());
  }
}

std::vector<Leftover> Autosave::leftovers(const fs::path& root) {
  std::vector<Leftover> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(root, error)) {
    QLockFile lock(text(entry.path() / kLock));
    lock.setStaleLockTime(0);
    // It runs still.
    if (!entry.is_directory() || !lock.tryLock(0)) continue;
    std::optional<Leftover> leftover = leftoverIn(entry.path());
    lock.unlock();
    if (leftover) {
      found.push_back(std::move(*leftover));
    } else if (fs::file_time_type::clock::now() - entry.last_write_time(error) > kStartingTakes) {
      fs::remove_all(entry.path(), error);
    }
  }
  std::sort(found.begin(), found.end(),
            [](const Leftover& left, const Leftover& right) { return left.when > right.when; });
  return found;
}

void Autosave::discard(const Leftover& leftover) {
  std::error_code error;
  fs::remove_all(leftover.folder, error);
}

}  // namespace ui
