#include "ui/files/kept_list.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <algorithm>
#include <optional>

#include "modeling/text/text_file.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndex = "takes.json";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 22U;
/// The list is small: who holds the lock for longer has been stopped in the middle.
constexpr int kMostWait = 500;  // ms

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

QJsonObject entryOf(const IndexedTake& take) {
  QJsonObject entry;
  entry["file"] = QString::fromStdString(take.file);
  entry["name"] = take.label.name;
  if (!take.label.note.isEmpty()) entry["note"] = take.label.note;
  if (take.label.continuedAt) entry["continuedAt"] = *take.label.continuedAt;
  entry["made"] = take.label.made.toString(Qt::ISODate);
  return entry;
}

IndexedTake takeOf(const QJsonValue& entry) {
  IndexedTake take;
  // A name with a folder in it is none of ours.
  take.file = fs::path(entry["file"].toString().toStdString()).filename().string();
  take.label.name = entry["name"].toString();
  take.label.note = entry["note"].toString();
  if (entry["continuedAt"].isDouble()) take.label.continuedAt = entry["continuedAt"].toDouble();
  take.label.made = QDateTime::fromString(entry["made"].toString(), Qt::ISODate);
  return take;
}

bool has(const std::vector<IndexedTake>& takes, const std::string& file) {
  return std::ranges::any_of(takes, [&](const IndexedTake& take) { return take.file == file; });
}

/// Nothing where there is a list that means nothing.
std::optional<std::vector<IndexedTake>> listIn(const fs::path& folder) {
  std::vector<IndexedTake> takes;
  const auto json = modeling::readTextFile(folder / kIndex, kMostBytes);
  if (!json) return takes;
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(*json));
  if (!document.isArray()) return std::nullopt;
  for (const QJsonValue& value : document.array()) {
    IndexedTake take = takeOf(value);
    if (fs::path(take.file).extension() == ".take" && !has(takes, take.file))
      takes.push_back(std::move(take));
  }
  return takes;
}

sim::Status putAside(const fs::path& folder) {
  const std::string stamp = QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss-zzz").toStdString();
  const fs::path aside = folder / ("takes.damaged-" + stamp + ".json");
  std::error_code error;
  fs::rename(folder / kIndex, aside, error);
  return sim::Problem{aside.string(),
                      "the list of this scene's takes was damaged: their names and notes are lost",
                      "the takes are there; what is left of the list is kept here"};
}

}  // namespace

std::vector<IndexedTake> KeptList::read() const {
  std::vector<IndexedTake> takes = listIn(folder_).value_or(std::vector<IndexedTake>());
  std::error_code error;
  std::erase_if(takes, [&](const IndexedTake& take) { return !fs::exists(folder_ / take.file, error); });
  std::vector<IndexedTake> unlisted;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() != ".take" || has(takes, file)) continue;
    TakeLabel label;
    label.name = text(entry.path().stem());
    label.made = QFileInfo(text(entry.path())).lastModified();
    unlisted.push_back({file, label});
  }
  std::ranges::sort(unlisted, {}, &IndexedTake::file);
  takes.insert(takes.end(), unlisted.begin(), unlisted.end());
  return takes;
}

sim::Status KeptList::merge(const std::vector<IndexedTake>& ours,
                            const std::map<std::string, TakeLabel>& known,
                            const std::set<std::string>& removed) const {
  QLockFile lock(text(folder_ / "takes.lock"));
  lock.setStaleLockTime(10 * kMostWait);
  // Without it the list is written all the same: a take in no list is found again by read().
  lock.tryLock(kMostWait);
  std::optional<std::vector<IndexedTake>> there = listIn(folder_);
  const sim::Status readable = there ? sim::Status(sim::Done{}) : putAside(folder_);
  std::vector<IndexedTake> merged = std::move(there).value_or(std::vector<IndexedTake>());
  std::error_code error;
  std::erase_if(merged, [&](const IndexedTake& take) {
    return removed.contains(take.file) || (!has(ours, take.file) && !fs::exists(folder_ / take.file, error));
  });
  for (const IndexedTake& take : ours) {
    const auto place = std::ranges::find(merged, take.file, &IndexedTake::file);
    const auto before = known.find(take.file);
    if (place == merged.end()) {
      merged.push_back(take);
    } else if (before == known.end() || !(before->second == take.label)) {
      place->label = take.label;
    }
  }
  QJsonArray entries;
  for (const IndexedTake& take : merged) entries.append(entryOf(take));
  const sim::Status written =
      modeling::replaceTextFile(folder_ / kIndex, QJsonDocument(entries).toJson().toStdString());
  return written ? readable : written;
}

}  // namespace ui
