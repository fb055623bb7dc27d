#include "ui/files/kept_takes.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>
#include <algorithm>

#include "modeling/text/text_file.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIndex = "takes.json";
/// Share of the scene's time: the last frame may be one short of it.
constexpr double kWhole = 0.9;
constexpr std::uintmax_t kMostIndexBytes = std::uintmax_t{1} << 22U;

fs::path pictureOf(const fs::path& take) {
  fs::path picture = take;
  return picture.replace_extension(".png");
}

QJsonObject entryOf(const fs::path& file, const TakeLabel& label) {
  QJsonObject entry;
  entry["file"] = QString::fromStdString(file.filename().string());
  entry["name"] = label.name;
  if (!label.note.isEmpty()) entry["note"] = label.note;
  if (label.continuedAt) entry["continuedAt"] = *label.continuedAt;
  entry["made"] = label.made.toString(Qt::ISODate);
  return entry;
}

TakeLabel labelOf(const QJsonObject& entry) {
  TakeLabel label;
  label.name = entry["name"].toString();
  label.note = entry["note"].toString();
  if (entry["continuedAt"].isDouble()) label.continuedAt = entry["continuedAt"].toDouble();
  label.made = QDateTime::fromString(entry["made"].toString(), Qt::ISODate);
  return label;
}

}  // namespace

KeptTakes::KeptTakes(Session& session, fs::path root, QObject* parent)
    : QObject(parent), session_(session), root_(std::move(root)) {
  connect(&session_.document(), &Document::replaced, this, [this] {
    replaced_ = true;
    sceneFile_.clear();
    waiting_.clear();
  });
  connect(&session_.document(), &Document::statusChanged, this, &KeptTakes::follow);
  connect(&session_.takes(), &TakeList::changed, this, &KeptTakes::keep);
  connect(&session_, &Session::runChanged, this, [this] {
    if (!session_.hasRun()) keep();
  });
  connect(&session_.takes(), &TakeList::removing, this, [this](const Take& take) {
    if (take.own) forget(take.footage->file());
  });
}

fs::path KeptTakes::folderOf(const fs::path& sceneFile) const {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(sceneFile, error);
  const QByteArray name = QByteArray::fromStdString((error ? sceneFile : whole).string());
  const QByteArray hash = QCryptographicHash::hash(name, QCryptographicHash::Sha1).toHex().left(12);
  return root_ / (sceneFile.stem().stem().string() + "-" + hash.toStdString());
}

void KeptTakes::follow() {
  const fs::path& file = session_.document().file();
  if (file != sceneFile_) {
    sceneFile_ = file;
    written_.clear();
    if (!file.empty()) folder_ = folderOf(file);
    if (!file.empty() && replaced_) load();
    keep();
  }
  replaced_ = false;
}

void KeptTakes::load() {
  const auto text = modeling::readTextFile(folder_ / kIndex, kMostIndexBytes);
  if (!text) return;
  const QJsonArray entries = QJsonDocument::fromJson(QByteArray::fromStdString(*text)).array();
  for (const QJsonValue& value : entries) {
    // A name with a folder in it is none of ours.
    const fs::path file = fs::path(value["file"].toString().toStdString()).filename();
    std::error_code error;
    if (file.extension() == ".take" && fs::exists(folder_ / file, error))
      waiting_.push_back({folder_ / file, labelOf(value.toObject())});
  }
  if (!waiting_.empty()) QTimer::singleShot(0, this, &KeptTakes::listNext);
}

bool KeptTakes::isListed(const fs::path& file) const {
  return std::ranges::any_of(
      session_.takes(), [&](const Take& take) { return take.footage->file().filename() == file.filename(); });
}

/// One take a turn: the window answers in between.
void KeptTakes::listNext() {
  if (waiting_.empty()) return;
  const Entry entry = std::move(waiting_.front());
  waiting_.pop_front();
  if (!isListed(entry.file)) {
    const sim::Status listed = session_.takes().list(
        entry.file, entry.label, QImage(QString::fromStdString(pictureOf(entry.file).string())));
    if (!listed) session_.report(listed.problem());
  }
  if (waiting_.empty()) {
    chooseNewest();
  } else {
    QTimer::singleShot(0, this, &KeptTakes::listNext);
  }
}

/// What was simulated already, to its end, need not be simulated again.
void KeptTakes::chooseNewest() {
  if (session_.takes().current() || session_.hasRun()) return;
  for (std::size_t take = session_.takes().size(); take-- > 0;) {
    const Take& one = session_.takes()[take];
    const double wanted = one.footage->scene()->output.duration;
    if (one.stale || one.footage->duration() < kWhole * wanted) continue;
    session_.takes().select(take);
    return;
  }
}

void KeptTakes::keep() {
  // An empty list may be that of a document which is being replaced: only who takes the last one out means
  // it.
  if (sceneFile_.empty() || (session_.takes().empty() && !removed_)) return;
  removed_ = false;
  std::error_code error;
  fs::create_directories(folder_, error);
  for (const Take& take : session_.takes()) {
    if (!take.own) continue;
    keepRecording(take.footage->file());
    const fs::path picture = pictureOf(folder_ / take.footage->file().filename());
    if (!take.thumbnail.isNull() && !fs::exists(picture, error))
      take.thumbnail.save(QString::fromStdString(picture.string()));
  }
  writeIndex();
}

void KeptTakes::keepRecording(const fs::path& file) {
  std::error_code error;
  const fs::path kept = folder_ / file.filename();
  if (file.parent_path() == folder_ || fs::exists(kept, error)) return;
  fs::create_hard_link(file, kept, error);
  if (!error || session_.hasRun()) return;
  fs::copy_file(file, kept, error);
  if (error)
    session_.report({file.string(), "the take could not be kept: " + error.message(),
                     "save it as a file of its own, or make room"});
}

void KeptTakes::writeIndex() {
  QJsonArray entries;
  for (const Take& take : session_.takes()) {
    if (take.own) entries.append(entryOf(take.footage->file(), take));
  }
  for (const Entry& entry : waiting_) entries.append(entryOf(entry.file, entry.label));
  const QByteArray json = QJsonDocument(entries).toJson();
  if (json == written_) return;
  const sim::Status written = modeling::replaceTextFile(folder_ / kIndex, json.toStdString());
  if (written) {
    written_ = json;
  } else {
    session_.report(written.problem());
  }
}

void KeptTakes::forget(const fs::path& file) {
  if (sceneFile_.empty()) return;
  removed_ = true;
  std::error_code error;
  fs::remove(folder_ / file.filename(), error);
  fs::remove(pictureOf(folder_ / file.filename()), error);
}

}  // namespace ui
