#pragma once

#include <QObject>
#include <filesystem>

#include "ui/files/autosave.h"
#include "ui/files/kept_takes.h"
#include "ui/files/leftovers.h"

class QWidget;

namespace ui {

/// Takes up what programs that were killed left behind. The window that asks takes one of them where nothing
/// is open in it; each other comes into a window of its own, beside what is open. What is taken up is removed
/// only when it is kept again.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// Leftovers are in `root`; questions are asked in front of `window`.
  Recovery(Session& session, KeptTakes& kept, Autosave& autosave, std::filesystem::path root,
           QWidget* window);

  /// Asks about each.
  void offer();
  /// Takes up that of a folder, without asking: this window was opened for it.
  void takeUp(const std::filesystem::path& folder);

 signals:
  /// There is a document now.
  void recovered();

 private:
  enum class Choice { recover, discard, later };
  Choice ask(const Leftover& leftover);
  void recover(const Leftover& leftover);
  void recoverHere(const Leftover& leftover);
  void recoverBeside(const Leftover& leftover);
  void sayDamaged(const Leftover& leftover);
  bool isFree() const;

  Session& session_;
  KeptTakes& kept_;
  Autosave& autosave_;
  std::filesystem::path root_;
  QWidget* window_;
};

}  // namespace ui
