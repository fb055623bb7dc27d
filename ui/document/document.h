#pragma once

#include <QObject>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>

#include "modeling/files/file_stamp.h"
#include "modeling/scene/scene.h"

namespace ui {

/// The scene that is edited, its undo history and its file. Lives in the window's thread.
///
/// Everything that changes the scene passes through edit() (or loads another scene by reset()), so that all
/// of it can be undone, saved, rebuilt and shown. Selection, camera and the moment that is shown are no
/// edits.
class Document : public QObject {
  Q_OBJECT

 public:
  /// Steps that can be undone; those before are forgotten. As many scenes of some ten kilobytes are in
  /// memory.
  static constexpr int kMostSteps = 300;
  using Change = std::function<void(modeling::Scene&)>;

  explicit Document(QObject* parent = nullptr);

  const modeling::Scene& scene() const { return scene_; }
  QUndoStack& undoStack() { return undoStack_; }
  /// Where it was loaded from or last saved to; empty: nowhere yet.
  const std::filesystem::path& file() const { return file_; }
  /// Where files that the scene names are looked for.
  std::filesystem::path folder() const { return file_.empty() ? baseFolder_ : file_.parent_path(); }
  /// The scene differs from its file.
  bool isModified() const { return !undoStack_.isClean(); }
  /// What its file held when it was read or saved, and what others have made of it since.
  const modeling::FileStamp& fileStamp() const { return stamp_; }
  modeling::FileChange changeOfFile() const;
  /// The scene as it was read or saved.
  const modeling::Scene& savedScene() const { return savedScene_; }
  /// What to call it: the scene's name, else its file's, else "Untitled".
  QString title() const { return titleOf(scene_, file_); }
  static QString titleOf(const modeling::Scene& scene, const std::filesystem::path& file);

  /// Makes one undoable step of a change, named as in "Undo NAME". A change that leaves the scene equal
  /// leaves nothing behind. Successive edits with the same gesture (any text but "") become one step until
  /// endGesture() or another edit: so a drag is undone as a whole, and vanishes when it ends where it began.
  void edit(const QString& name, const Change& change, const QString& gesture = {});
  void endGesture();
  /// The scene as it would be after the edits that `confirm` makes; nothing comes of them otherwise.
  modeling::Scene rehearse(const std::function<void()>& confirm);
  bool isRehearsing() const { return rehearsed_ != nullptr; }

  /// Another scene: forgets the history. `file` is where it came from; empty for a new one, whose own files
  /// are looked for in `baseFolder`.
  void reset(modeling::Scene scene, std::filesystem::path file, std::filesystem::path baseFolder = {});
  /// The same, of a file that held what the stamp says when it was read.
  void reset(modeling::Scene scene, std::filesystem::path file, const modeling::FileStamp& stamp);
  /// What its file holds now, as an edit that can be undone; counts as saved.
  void takeFromFile(modeling::Scene scene, const modeling::FileStamp& stamp);
  /// Writes it, in one step or not at all; the history stays, and remembers this state as the saved one.
  sim::Status saveTo(const std::filesystem::path& file);
  /// Saving asks for a name again; files that the scene names are still looked for where they were.
  void detachFromFile();
  /// A recovered scene counts as unsaved.
  void markUnsaved() { undoStack_.resetClean(); }

 signals:
  /// The scene is another than before: edited, undone, redone or loaded.
  void sceneChanged();
  /// Another document altogether; comes before sceneChanged().
  void replaced();
  /// File, title or whether it is modified.
  void statusChanged();
  /// Something was rehearsed: what was shown of it is to be shown as it is again.
  void rehearsed();

 private:
  friend class EditCommand;
  using ScenePointer = std::shared_ptr<const modeling::Scene>;
  void setScene(const ScenePointer& scene);
  void replace(modeling::Scene scene, std::filesystem::path file, const modeling::FileStamp& stamp);

  modeling::Scene scene_;
  /// Equal to the scene, as the history keeps it.
  ScenePointer kept_ = std::make_shared<const modeling::Scene>();
  std::filesystem::path file_;
  std::filesystem::path baseFolder_;
  modeling::FileStamp stamp_;
  modeling::Scene savedScene_;
  modeling::Scene* rehearsed_ = nullptr;  ///< takes the edits while they are rehearsed
  QUndoStack undoStack_;
  QString gesture_;
};

}  // namespace ui
