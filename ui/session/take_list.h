#pragma once

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "ui/document/document.h"
#include "ui/session/footage.h"

namespace ui {

/// What is known of a take beside its recording.
struct TakeLabel {
  QString name;
  QString note;
  std::optional<double> continuedAt;  ///< s: where it left the take it was continued from
  QDateTime made;

  bool operator==(const TakeLabel&) const = default;
};

/// A take in the window's list.
struct Take : TakeLabel {
  std::shared_ptr<Footage> footage;
  QImage thumbnail;
  bool stale = false;  ///< the scene has been changed since
  bool own = false;    ///< recorded by the program, which keeps and deletes its file; else somebody's file
};

/// A take that a program which was killed left behind.
struct LeftTake {
  std::filesystem::path file;
  QString name;  ///< empty: none is known
  QString note;
};

/// Whether two scenes make the same motion: where the camera stands and what a scene is called does not
/// matter.
bool movesAlike(modeling::Scene left, modeling::Scene right);

/// The takes of a document, and which of them is on the timeline. Lives in the window's thread.
class TakeList : public QObject {
  Q_OBJECT

 public:
  /// Takes are recorded in `folder`, which is made when needed.
  TakeList(const Document& document, std::filesystem::path folder, QObject* parent = nullptr);

  bool empty() const { return takes_.empty(); }
  std::size_t size() const { return takes_.size(); }
  const Take& operator[](std::size_t take) const { return takes_.at(take); }
  std::vector<Take>::const_iterator begin() const { return takes_.begin(); }
  std::vector<Take>::const_iterator end() const { return takes_.end(); }
  /// Which take is on the timeline.
  std::optional<std::size_t> current() const { return current_; }
  /// The footage of the take on the timeline; null where there is none.
  std::shared_ptr<Footage> currentFootage() const { return current_ ? takes_[*current_].footage : nullptr; }
  /// Where that footage is listed; nothing where it is not any more.
  std::optional<std::size_t> find(const std::shared_ptr<Footage>& footage) const;
  /// Some take was recorded by the program itself.
  bool hasOwn() const;

  /// Another document begins without takes. Their files stay.
  void clear();
  /// Looks anew which takes are stale.
  void judge();
  void select(std::size_t take);
  void rename(std::size_t take, const QString& name);
  void setNote(std::size_t take, const QString& note);
  void setThumbnail(std::size_t take, const QImage& picture);
  /// Takes it off the list; its file is deleted where it is the program's own.
  void remove(std::size_t take);

  /// Where the next run is to be recorded.
  std::filesystem::path newFile() const;
  /// A name that no take has.
  QString freshName() const;
  /// Puts the take of a run into the list and makes it the current one.
  void add(Take take);
  /// Puts somebody's file into the list and makes it the current one. A Problem where it is no take.
  sim::Status open(const std::filesystem::path& file);
  /// Puts a take of the program's own into the list, and leaves the timeline as it is.
  sim::Status list(const std::filesystem::path& file, const TakeLabel& label, const QImage& thumbnail);
  /// Takes over files of a run that was cut short. Those that cannot be read are left out: problemFound().
  void adopt(const std::vector<LeftTake>& takes);
  /// Copies its file. Asks for a take that is finished.
  sim::Status save(std::size_t take, const std::filesystem::path& file) const;

 signals:
  void changed();
  /// Another take is on the timeline, or none; emitted before changed().
  void currentChanged();
  /// A take was read from a file; what timeline and plots show of it is not known yet.
  void fileRead(const std::shared_ptr<Footage>& footage);
  /// A take is about to leave the list, and its file the disk where it is the program's own.
  void removing(const Take& take);
  void problemFound(const sim::Problem& problem);

 private:
  sim::Status addFile(const std::filesystem::path& file, Take take);

  const Document& document_;
  std::filesystem::path folder_;
  std::vector<Take> takes_;
  std::optional<std::size_t> current_;
};

}  // namespace ui
