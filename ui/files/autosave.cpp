#include "ui/files/autosave.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QUuid>
#include <algorithm>
#include <chrono>

#include "modeling/exchange/take_scene.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/text_file.h"

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

/// In the order they were made in; their names are known by the state.
std::vector<LeftTake> takesIn(const fs::path& folder, const QJsonObject& names) {
  std::vector<LeftTake> takes;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".take") continue;
    const QJsonObject known = names[text(entry.path().filename())].toObject();
    takes.push_back({entry.path(), known["name"].toString(), known["note"].toString()});
  }
  std::sort(takes.begin(), takes.end(),
            [](const LeftTake& left, const LeftTake& right) { return left.file < right.file; });
  return takes;
}

/// The scene that was written aside; where that was not reached, that of the newest take that has one.
std::optional<modeling::Scene> sceneIn(const fs::path& folder, const std::vector<LeftTake>& takes) {
  if (sim::Result<modeling::SceneFile> scene = modeling::loadScene(folder / kScene)) return scene->scene;
  for (auto take = takes.rbegin(); take != takes.rend(); ++take) {
    const auto reader = sim::TakeReader::open(take->file);
    if (!reader) continue;
    if (sim::Result<modeling::Scene> scene = modeling::sceneOf(**reader)) return std::move(scene).value();
  }
  return std::nullopt;
}

std::optional<Leftover> leftoverIn(const fs::path& folder) {
  Leftover leftover;
  leftover.folder = folder;
  QJsonObject names;
  if (const auto state = modeling::readTextFile(folder / kState, std::uintmax_t{1} << 20U)) {
    const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(*state)).object();
    leftover.file = object["file"].toString().toStdString();
    leftover.when = QDateTime::fromString(object["when"].toString(), Qt::ISODate);
    names = object["takes"].toObject();
  } else {
    leftover.when = QFileInfo(text(folder)).lastModified();
  }
  leftover.takes = takesIn(folder, names);
  std::optional<modeling::Scene> scene = sceneIn(folder, leftover.takes);
  if (!scene) return std::nullopt;
  leftover.scene = std::move(*scene);
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
  connect(&session_.takes(), &TakeList::changed, this, &Autosave::write);
}

Autosave::~Autosave() {
  std::error_code error;
  lock_.unlock();
  fs::remove_all(folder_, error);
}

QJsonObject Autosave::state() const {
  QJsonObject takes;
  for (const Take& take : session_.takes()) {
    if (take.footage->file().parent_path() != folder_) continue;
    takes[text(take.footage->file().filename())] = QJsonObject{{"name", take.name}, {"note", take.note}};
  }
  return {{"file", text(session_.document().file())}, {"takes", takes}};
}

void Autosave::write() {
  const Document& document = session_.document();
  QJsonObject state = this->state();
  const bool worthKeeping = document.isModified() || !state["takes"].toObject().isEmpty();
  if (!worthKeeping || document.scene().parts.empty()) return;
  if (written_ == document.scene() && writtenState_ == state) return;
  const sim::Status saved = modeling::saveScene(document.scene(), folder_ / kScene);
  const QJsonObject now = state;
  state["when"] = QDateTime::currentDateTime().toString(Qt::ISODate);
  const std::string json = QJsonDocument(state).toJson().toStdString();
  const sim::Status noted = modeling::replaceTextFile(folder_ / kState, json);
  if (saved && noted) {
    written_ = document.scene();
    writtenState_ = now;
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
