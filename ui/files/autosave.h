#pragma once

#include <QDateTime>
#include <QJsonObject>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>

#include "ui/session/background_worker.h"
#include "ui/session/session.h"

namespace ui {

/// Writes the scene aside, so that what was done is there again after a crash (leftovers.h). Each running
/// program has a folder of its own, which is removed when it ends well.
///
/// It looks every five seconds, whatever goes on: a run, a drag, a question that waits for an answer. What is
/// typed and not confirmed yet (PendingEdit) is written as if it were. So no more than five seconds and the
/// writing are lost; fifteen are promised. The disk is waited for in a thread of its own.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int kSeconds = 5;

  /// `folder` is newFolder() of this program.
  Autosave(Session& session, std::filesystem::path folder);
  /// The program ends well: nothing is left behind.
  ~Autosave() override;

  /// A folder for this program in `root`, where those of all running programs are; its takes go there, too.
  static std::filesystem::path newFolder(const std::filesystem::path& root);

  /// Writes now, if anything changed, and returns when the disk has it.
  void write();

 private:
  struct Order;
  class Writer;

  std::shared_ptr<const Order> newOrder();
  void begin();
  QJsonObject state(bool modified) const;

  Session& session_;
  std::filesystem::path folder_;
  QLockFile lock_;
  QTimer timer_;
  std::shared_ptr<Writer> writer_;
  std::shared_ptr<const Order> ordered_;  ///< what was written last, or is about to be; null: nothing yet
  std::uint64_t orders_ = 0;
  std::uint64_t failed_ = 0;                         ///< number of the worker's request that failed last
  std::string told_;                                 ///< why
  QDateTime opened_ = QDateTime::currentDateTime();  ///< when the document was: takes begun since are its own
  BackgroundWorker<std::shared_ptr<const Order>, bool> worker_;
};

}  // namespace ui
