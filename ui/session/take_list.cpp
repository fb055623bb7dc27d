#include "ui/session/take_list.h"

#include <QFileInfo>
#include <QUuid>
#include <algorithm>

#include "modeling/files/output_file.h"
#include "modeling/files/output_guard.h"
#include "modeling/scene/scene_file.h"

namespace ui {

bool movesAlike(modeling::Scene left, modeling::Scene right) {
  left.view = right.view;
  left.name = right.name;
  return modeling::withoutPresets(std::move(left)) == modeling::withoutPresets(std::move(right));
}

TakeList::TakeList(const Document& document, std::filesystem::path folder, QObject* parent)
    : QObject(parent), document_(document), folder_(std::move(folder)) {}

std::optional<std::size_t> TakeList::find(const std::shared_ptr<Footage>& footage) const {
  for (std::size_t take = 0; take < takes_.size(); ++take)
    if (takes_[take].footage == footage) return take;
  return std::nullopt;
}

bool TakeList::hasOwn() const {
  return std::any_of(takes_.begin(), takes_.end(), [](const Take& take) { return take.own; });
}

void TakeList::clear() {
  takes_.clear();
  current_.reset();
  emit changed();
}

void TakeList::judge() {
  bool some = false;
  for (Take& take : takes_) {
    const bool stale = !movesAlike(*take.footage->scene(), document_.scene());
    some |= stale != take.stale;
    take.stale = stale;
  }
  if (some) emit changed();
}

void TakeList::select(std::size_t take) {
  if (take >= takes_.size() || current_ == take) return;
  current_ = take;
  emit currentChanged();
  emit changed();
}

void TakeList::rename(std::size_t take, const QString& name) {
  if (take >= takes_.size()) return;
  takes_[take].name = name;
  emit changed();
}

void TakeList::setNote(std::size_t take, const QString& note) {
  if (take >= takes_.size()) return;
  takes_[take].note = note;
  emit changed();
}

void TakeList::setThumbnail(std::size_t take, const QImage& picture) {
  if (take >= takes_.size()) return;
  takes_[take].thumbnail = picture;
  emit changed();
}

void TakeList::remove(std::size_t take) {
  if (take >= takes_.size()) return;
  emit removing(takes_[take]);
  if (takes_[take].own) {
    std::error_code error;
    std::filesystem::remove(takes_[take].footage->file(), error);
  }
  takes_.erase(takes_.begin() + static_cast<std::ptrdiff_t>(take));
  if (current_ == take) {
    current_.reset();
    emit currentChanged();
  } else if (current_ && *current_ > take) {
    --*current_;
  }
  emit changed();
}

std::filesystem::path TakeList::newFile() const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  const std::string stamp = QDateTime::currentDateTime().toString("yyyyMMdd-hhmmss-zzz").toStdString();
  // Two windows may begin in the same millisecond, and their takes come into one folder.
  const std::string unique = QUuid::createUuid().toString(QUuid::Id128).left(6).toStdString();
  return folder_ / ("take-" + stamp + "-" + unique + ".take");
}

QString TakeList::freshName() const {
  int number = 1;
  const auto taken = [&](const QString& name) {
    return std::any_of(takes_.begin(), takes_.end(), [&](const Take& take) { return take.name == name; });
  };
  while (taken(tr("Take %1").arg(number))) ++number;
  return tr("Take %1").arg(number);
}

void TakeList::add(Take take) {
  takes_.push_back(std::move(take));
  current_ = takes_.size() - 1;
  emit currentChanged();
  emit changed();
}

sim::Status TakeList::addFile(const std::filesystem::path& file, Take take) {
  sim::Result<std::shared_ptr<Footage>> footage = Footage::open(file);
  if (!footage) return footage.problem();
  take.footage = *footage;
  takes_.push_back(std::move(take));
  emit fileRead(*footage);
  judge();
  return sim::Done{};
}

sim::Status TakeList::open(const std::filesystem::path& file) {
  Take take;
  take.name = QString::fromStdString(file.stem().string());
  take.made = QFileInfo(QString::fromStdString(file.string())).lastModified();
  take.own = file.parent_path() == folder_;
  if (const sim::Status added = addFile(file, std::move(take)); !added) return added;
  select(takes_.size() - 1);
  return sim::Done{};
}

sim::Status TakeList::list(const std::filesystem::path& file, const TakeLabel& label,
                           const QImage& thumbnail) {
  if (const sim::Status added = addFile(file, {label, {}, thumbnail, false, true}); !added) return added;
  emit changed();
  return sim::Done{};
}

void TakeList::adopt(const std::vector<LeftTake>& takes) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  for (const LeftTake& left : takes) {
    const std::filesystem::path own = folder_ / left.file.filename();
    std::filesystem::rename(left.file, own, error);
    if (const sim::Status opened = open(error ? left.file : own); !opened) {
      emit problemFound(opened.problem());
      continue;
    }
    takes_.back().note = left.note;
    if (!left.name.isEmpty()) takes_.back().name = left.name;
  }
  if (!takes.empty()) emit changed();
}

sim::Status TakeList::save(std::size_t take, const std::filesystem::path& file) const {
  const std::filesystem::path& from = takes_.at(take).footage->file();
  modeling::OutputGuard guard;
  guard.reads(from);
  guard.writes(file, modeling::kinds::take);
  if (const sim::Status safe = guard.check(); !safe) return safe;
  return modeling::replaceByCopy(file, from);
}

}  // namespace ui
