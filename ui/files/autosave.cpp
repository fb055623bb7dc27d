#include "ui/files/autosave.h"

#include <QApplication>
#include <QDateTime>
#include <QDialog>
#include <QJsonDocument>
#include <QUuid>

#include "modeling/files/output_file.h"
#include "modeling/scene/scene_file.h"
#include "ui/document/pending_edit.h"
#include "ui/files/leftovers.h"

namespace ui {
namespace {

namespace fs = std::filesystem;

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

/// What is typed in the window. Fields of a dialog count when the dialog says so.
void confirmPending() {
  for (QWidget* widget : QApplication::allWidgets()) {
    auto* pending = dynamic_cast<PendingEdit*>(widget);
    if (pending != nullptr && widget->isVisible() && qobject_cast<QDialog*>(widget->window()) == nullptr)
      pending->rehearse();
  }
}

}  // namespace

struct Autosave::Order {
  std::uint64_t number = 0;
  modeling::Scene scene;
  QJsonObject state;
  QDateTime when;

  bool saysTheSame(const Order& other) const { return scene == other.scene && state == other.state; }
};

/// Shared with the thread, which may outlive the window by a moment.
class Autosave::Writer {
 public:
  explicit Writer(fs::path folder) : folder_(std::move(folder)) {}

  sim::Status write(const Order& order) {
    const std::lock_guard lock(mutex_);
    if (ended_ || order.number <= newest_) return sim::Done{};
    newest_ = order.number;
    if (const sim::Status saved = modeling::saveScene(order.scene, folder_ / kAsideScene); !saved)
      return saved;
    QJsonObject state = order.state;
    state["when"] = order.when.toString(Qt::ISODateWithMs);
    return modeling::replaceFile(folder_ / kAsideState, QJsonDocument(state).toJson().toStdString());
  }

  /// Removes all but the lock. A disk that does not answer is not waited for: then the folder is recovered,
  /// which is better than lost.
  void end() {
    if (!mutex_.try_lock_for(std::chrono::milliseconds(500))) return;
    const std::lock_guard lock(mutex_, std::adopt_lock);
    ended_ = true;
    removeAside(folder_);
  }

 private:
  const fs::path folder_;
  std::timed_mutex mutex_;  ///< of all below and of the files; held while the disk is waited for
  std::uint64_t newest_ = 0;
  bool ended_ = false;
};

fs::path Autosave::newFolder(const fs::path& root) {
  const std::string name = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  const fs::path folder = root / name;
  std::error_code error;
  fs::create_directories(folder, error);
  return folder;
}

Autosave::Autosave(Session& session, fs::path folder)
    : session_(session),
      folder_(std::move(folder)),
      lock_(text(folder_ / kAsideLock)),
      writer_(std::make_shared<Writer>(folder_)),
      worker_([writer = writer_](const std::shared_ptr<const Order>& order, auto&) {
        return writer->write(*order);
      }) {
  // A lock whose program runs is never stale, however old.
  lock_.setStaleLockTime(0);
  lock_.tryLock(0);
  timer_.setInterval(kSeconds * 1000);
  timer_.start();
  connect(&timer_, &QTimer::timeout, this, &Autosave::begin);
  connect(&session_.document(), &Document::replaced, this,
          [this] { opened_ = QDateTime::currentDateTime(); });
  // Not in the middle of what changes them.
  connect(&session_.document(), &Document::statusChanged, this, &Autosave::begin, Qt::QueuedConnection);
  connect(&session_.takes(), &TakeList::changed, this, &Autosave::begin, Qt::QueuedConnection);
}

Autosave::~Autosave() {
  worker_.requestStop();
  writer_->end();
  lock_.unlock();
  std::error_code stays;
  fs::remove(folder_, stays);
}

QJsonObject Autosave::state(bool modified) const {
  const Document& document = session_.document();
  QJsonObject takes;
  for (const Take& take : session_.takes()) {
    if (take.footage->file().parent_path() != folder_) continue;
    takes[text(take.footage->file().filename())] = QJsonObject{{"name", take.name}, {"note", take.note}};
  }
  return {{"file", text(document.file())},
          {"folder", text(document.folder())},
          {"stamp", QString::fromStdString(document.fileStamp().text())},
          {"opened", opened_.toString(Qt::ISODateWithMs)},
          {"modified", modified},
          {"takes", takes}};
}

/// Null where there is nothing new.
std::shared_ptr<const Autosave::Order> Autosave::newOrder() {
  Document& document = session_.document();
  if (document.isRehearsing()) return nullptr;
  auto order = std::make_shared<Order>();
  order->scene = document.rehearse(confirmPending);
  const bool modified = document.isModified() || order->scene != document.scene();
  order->state = state(modified);
  // Whose takes come into the folder is known before there are any.
  const bool isOpen = modified || !document.file().empty() || !document.scene().parts.empty();
  if (!ordered_ && !isOpen) return nullptr;
  if (ordered_ && ordered_->saysTheSame(*order)) return nullptr;
  order->number = ++orders_;
  order->when = QDateTime::currentDateTime();
  ordered_ = order;
  return order;
}

void Autosave::begin() {
  if (const auto last = worker_.newest(); last->problem && last->request != failed_) {
    failed_ = last->request;
    // It is tried again, and told of once.
    ordered_ = nullptr;
    if (std::exchange(told_, last->problem->line()) != last->problem->line()) session_.report(*last->problem);
  }
  if (const auto order = newOrder()) worker_.request(order);
}

void Autosave::write() {
  static_cast<void>(newOrder());
  // One that the thread has not written yet is as good.
  if (!ordered_) return;
  if (const sim::Status written = writer_->write(*ordered_); !written) session_.report(written.problem());
}

}  // namespace ui
