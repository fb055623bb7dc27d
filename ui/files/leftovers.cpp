#include "ui/files/leftovers.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <chrono>

#include "modeling/exchange/take_scene.h"
#include "modeling/scene/salvage.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/text_file.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

/// A program that has just made its folder may not have locked it yet.
constexpr std::chrono::minutes kStartingTakes{1};

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

LeftTake takeOf(const fs::path& file, const QJsonObject& known) {
  return {file, known["name"].toString(), known["note"].toString()};
}

/// As its name says (TakeList::newFile()).
QDateTime begunAt(const QString& take) {
  return QDateTime::fromString(take.mid(5, 19), QStringLiteral("yyyyMMdd-hhmmss-zzz"));
}

/// Those that the state names, in the order they were made in, and those that were begun since the scene
/// was opened: a folder may have takes of other scenes, which were open before. Where there is no state, all.
void findTakes(const std::optional<QJsonObject>& names, Leftover& left) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(left.folder, error)) {
    if (entry.path().extension() != ".take") continue;
    const QString name = text(entry.path().filename());
    const bool since = left.opened.isValid() && begunAt(name) >= left.opened;
    if (!names || names->contains(name) || since)
      left.takes.push_back(takeOf(entry.path(), names ? (*names)[name].toObject() : QJsonObject()));
  }
  std::ranges::sort(left.takes, {}, &LeftTake::file);
}

/// The names of takes; nothing where there is no state, or it is damaged.
std::optional<QJsonObject> readState(Leftover& left) {
  left.when = QFileInfo(text(left.folder)).lastModified();
  const fs::path file = left.folder / kAsideState;
  std::error_code error;
  if (!fs::exists(file, error)) return std::nullopt;
  const auto json = modeling::readTextFile(file, std::uintmax_t{1} << 22U);
  const QJsonDocument document =
      json ? QJsonDocument::fromJson(QByteArray::fromStdString(*json)) : QJsonDocument();
  if (!document.isObject()) {
    left.faults.push_back(
        {file.string(), "what was kept of the file's name and of its takes is damaged", ""});
    return std::nullopt;
  }
  const QJsonObject state = document.object();
  left.file = state["file"].toString().toStdString();
  left.baseFolder = state["folder"].toString().toStdString();
  left.stamp = modeling::FileStamp::fromText(state["stamp"].toString().toStdString());
  left.modified = state["modified"].toBool(true);
  left.opened = QDateTime::fromString(state["opened"].toString(), Qt::ISODateWithMs);
  left.when = QDateTime::fromString(state["when"].toString(), Qt::ISODateWithMs);
  return state["takes"].toObject();
}

/// The scene that was written aside; where that was not reached or is lost, that of the newest take that has
/// one.
void readScene(Leftover& left) {
  const fs::path file = left.folder / kAsideScene;
  std::error_code error;
  if (fs::exists(file, error)) {
    auto salvaged = modeling::salvageScene(file);
    if (salvaged) {
      left.scene = std::move(salvaged->scene);
      left.faults.insert(left.faults.end(), salvaged->faults.begin(), salvaged->faults.end());
      return;
    }
    // A scene without parts cannot be salvaged, and is whole.
    if (auto whole = modeling::loadScene(file)) {
      left.scene = std::move(whole->scene);
      return;
    }
    left.faults.push_back(salvaged.problem());
  }
  for (auto take = left.takes.rbegin(); take != left.takes.rend(); ++take) {
    const auto reader = sim::TakeReader::open(take->file);
    if (!reader) continue;
    if (sim::Result<modeling::Scene> scene = modeling::sceneOf(**reader)) {
      left.scene = std::move(scene).value();
      return;
    }
  }
  left.readable = false;
}

/// It was saved just before the end.
bool isInItsFile(const Leftover& left) {
  if (left.file.empty()) return false;
  const auto saved = modeling::loadScene(left.file);
  return saved && saved->scene == left.scene;
}

}  // namespace

std::vector<Leftover> leftoverOf(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return {};
  Leftover left;
  left.folder = folder;
  left.lock = std::make_shared<QLockFile>(text(folder / kAsideLock));
  // A lock whose program runs is never stale, however old.
  left.lock->setStaleLockTime(0);
  if (!left.lock->tryLock(0)) return {};
  const std::optional<QJsonObject> names = readState(left);
  findTakes(names, left);
  readScene(left);
  left.modified = left.modified && !isInItsFile(left);
  const bool nothing = left.faults.empty() && left.takes.empty() && (!left.readable || !left.modified);
  if (!nothing) return {left};
  const bool old = fs::file_time_type::clock::now() - fs::last_write_time(folder, error) > kStartingTakes;
  if (names || old) discard(left);
  return {};
}

std::vector<Leftover> leftoversIn(const fs::path& root) {
  std::vector<Leftover> found;
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(root, error)) folders.push_back(entry.path());
  for (const fs::path& folder : folders) {
    for (Leftover& left : leftoverOf(folder)) found.push_back(std::move(left));
  }
  std::ranges::stable_sort(found, std::ranges::greater(), &Leftover::when);
  return found;
}

void discard(const Leftover& leftover) {
  removeAside(leftover.folder);
  if (leftover.lock) leftover.lock->unlock();
  std::error_code error;
  fs::remove(leftover.folder, error);
}

void removeAside(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename() != kAsideLock) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove_all(file, error);
}

fs::path putAside(const Leftover& leftover) {
  const fs::path folder = leftover.folder.parent_path().parent_path() / "damaged";
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path aside = folder / leftover.folder.filename();
  if (leftover.lock) leftover.lock->unlock();
  fs::rename(leftover.folder, aside, error);
  return error ? leftover.folder : aside;
}

}  // namespace ui
