#include "ui/files/kept_takes.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QTimer>
#include <algorithm>

#include "modeling/files/output_file.h"
#include "ui/files/saved_picture.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

/// Share of the scene's time: the last frame may be one short of it.
constexpr double kWhole = 0.9;

fs::path pictureOf(const fs::path& take) {
  fs::path picture = take;
  return picture.replace_extension(".png");
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
    known_.clear();
    removed_.clear();
    if (!file.empty()) folder_ = folderOf(file);
    if (!file.empty() && replaced_) load();
    keep();
  }
  replaced_ = false;
}

void KeptTakes::load() {
  for (IndexedTake& take : KeptList(folder_).read()) {
    known_[take.file] = take.label;
    waiting_.push_back(std::move(take));
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
  const IndexedTake take = std::move(waiting_.front());
  waiting_.pop_front();
  const fs::path file = folder_ / take.file;
  if (!isListed(file)) {
    const sim::Status listed =
        session_.takes().list(file, take.label, QImage(QString::fromStdString(pictureOf(file).string())));
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
  if (sceneFile_.empty() || (session_.takes().empty() && removed_.empty())) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  for (const Take& take : session_.takes()) {
    if (!take.own) continue;
    keepRecording(take.footage->file());
    keepPicture(take);
  }
  writeIndex();
}

void KeptTakes::keepPicture(const Take& take) {
  std::error_code error;
  const fs::path picture = pictureOf(folder_ / take.footage->file().filename());
  if (take.thumbnail.isNull() || fs::exists(picture, error)) return;
  static_cast<void>(savePicture(take.thumbnail, picture));
}

void KeptTakes::keepRecording(const fs::path& file) {
  std::error_code error;
  const fs::path kept = folder_ / file.filename();
  if (file.parent_path() == folder_ || fs::exists(kept, error)) return;
  fs::create_hard_link(file, kept, error);
  if (!error || session_.hasRun()) return;
  if (const sim::Status copied = modeling::replaceByCopy(kept, file); !copied)
    session_.report({file.string(), "the take could not be kept: " + copied.problem().what,
                     "save it as a file of its own, or make room"});
}

void KeptTakes::writeIndex() {
  std::vector<IndexedTake> ours;
  std::map<std::string, TakeLabel> said;
  std::error_code error;
  for (const Take& take : session_.takes()) {
    const fs::path& file = take.footage->file();
    // Another window may have deleted what it and we took from the folder.
    if (!take.own || (file.parent_path() == folder_ && !fs::exists(file, error))) continue;
    ours.push_back({file.filename().string(), take});
    said[ours.back().file] = take;
  }
  for (const IndexedTake& take : waiting_) said[take.file] = take.label;
  if (said == known_ && removed_.empty()) return;
  const sim::Status written = KeptList(folder_).merge(ours, known_, removed_);
  if (!written) session_.report(written.problem());
  known_ = std::move(said);
  removed_.clear();
}

void KeptTakes::receive(const std::vector<LeftTake>& takes, const fs::path& sceneFile) {
  const fs::path folder = folderOf(sceneFile);
  std::error_code error;
  fs::create_directories(folder, error);
  std::vector<IndexedTake> received;
  for (const LeftTake& left : takes) {
    const fs::path kept = folder / left.file.filename();
    if (fs::exists(kept, error)) continue;
    fs::rename(left.file, kept, error);
    if (error) continue;
    TakeLabel label;
    label.name = left.name.isEmpty() ? QString::fromStdString(left.file.stem().string()) : left.name;
    label.note = left.note;
    label.made = QFileInfo(QString::fromStdString(kept.string())).lastModified();
    received.push_back({kept.filename().string(), label});
  }
  if (received.empty()) return;
  if (const sim::Status written = KeptList(folder).merge(received, {}, {}); !written)
    session_.report(written.problem());
}

void KeptTakes::forget(const fs::path& file) {
  if (sceneFile_.empty()) return;
  removed_.insert(file.filename().string());
  std::error_code error;
  fs::remove(folder_ / file.filename(), error);
  fs::remove(pictureOf(folder_ / file.filename()), error);
}

}  // namespace ui
