#pragma once

#include <QDateTime>
#include <QJsonObject>
#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <filesystem>
#include <optional>
#include <vector>

#include "ui/session/session.h"

namespace ui {

/// Work that a program which was killed left behind.
struct Leftover {
  std::filesystem::path folder;  ///< of the autosave
  modeling::Scene scene;
  std::filesystem::path file;  ///< where the scene had been saved; empty: nowhere
  std::vector<LeftTake> takes;
  QDateTime when;
};

/// Writes the scene aside every two minutes, when a run begins and ends and shortly after an edit, so that
/// what was done is there again after a crash. Each running program has a folder of its own, which is removed
/// when it ends well.
class Autosave : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMinutes = 2;
  /// After an edit: long enough that a drag is not written move by move.
  static constexpr int kSecondsAfterEdit = 5;

  /// `folder` is newFolder() of this program.
  Autosave(Session& session, std::filesystem::path folder);
  /// The program ends well: nothing is left behind.
  ~Autosave() override;

  /// A folder for this program in `root`, where those of all running programs are; its takes go there, too.
  static std::filesystem::path newFolder(const std::filesystem::path& root);

  /// Writes now, if anything changed.
  void write();

  /// Of programs that do not run any more, the newest first.
  static std::vector<Leftover> leftovers(const std::filesystem::path& root);
  static void discard(const Leftover& leftover);

 private:
  QJsonObject state() const;

  Session& session_;
  std::filesystem::path folder_;
  QLockFile lock_;
  QTimer regular_;
  QTimer afterEdit_;
  modeling::Scene written_;
  QJsonObject writtenState_;
};

}  // namespace ui
