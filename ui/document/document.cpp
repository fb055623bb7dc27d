#include "ui/document/document.h"

#include <QScopeGuard>
#include <QTimer>
#include <exception>

#include "modeling/files/output_file.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_ranges.h"
#include "ui/document/edit_command.h"

namespace ui {

EditCommand::EditCommand(Document& document, const QString& name, Document::ScenePointer after,
                         QString gesture)
    : QUndoCommand(name),
      document_(document),
      before_(document.kept_),
      after_(std::move(after)),
      gesture_(std::move(gesture)) {}

int EditCommand::id() const {
  return gesture_.isEmpty() ? -1 : 1;
}

bool EditCommand::mergeWith(const QUndoCommand* next) {
  const auto& later = static_cast<const EditCommand&>(*next);
  if (later.gesture_ != gesture_) return false;
  after_ = later.after_;
  setObsolete(*after_ == *before_);
  return true;
}

Document::Document(QObject* parent) : QObject(parent) {
  undoStack_.setUndoLimit(kMostSteps);
  connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::statusChanged);
}

QString Document::titleOf(const modeling::Scene& scene, const std::filesystem::path& file) {
  if (!scene.name.empty()) return QString::fromStdString(scene.name);
  if (file.empty()) return tr("Untitled");
  QString name = QString::fromStdString(file.filename().string());
  name.remove(QStringLiteral(".scene.json"));
  return name;
}

modeling::FileChange Document::changeOfFile() const {
  return file_.empty() ? modeling::FileChange::none : stamp_.changeOf(file_);
}

void Document::endGesture() {
  if (!isRehearsing()) gesture_.clear();
}

modeling::Scene Document::rehearse(const std::function<void()>& confirm) {
  modeling::Scene scene = scene_;
  {
    rehearsed_ = &scene;
    const auto end = qScopeGuard([this] { rehearsed_ = nullptr; });
    confirm();
  }
  if (scene != scene_) emit rehearsed();
  return scene;
}

void Document::edit(const QString& name, const Change& change, const QString& gesture) {
  if (rehearsed_ != nullptr) return change(*rehearsed_);
  modeling::Scene after = scene_;
  change(after);
  modeling::keepNumbersInRange(after);
  // Commands merge with the one before by the gesture's name: another gesture of the same name, begun later,
  // must not.
  static int gestures = 0;
  if (gesture != gesture_ || gesture.isEmpty()) ++gestures;
  gesture_ = gesture;
  if (after == scene_) return;
  const QString unique = gesture.isEmpty() ? QString() : gesture + QString::number(gestures);
  undoStack_.push(
      new EditCommand(*this, name, std::make_shared<const modeling::Scene>(std::move(after)), unique));
}

void Document::setScene(const ScenePointer& scene) {
  kept_ = scene;
  if (*scene == scene_) return;
  const bool renamed = scene->name != scene_.name;
  scene_ = *scene;
  // What a listener throws must not tear the history, which has half of a step done: it is thrown again from
  // the event loop.
  try {
    emit sceneChanged();
    if (renamed) emit statusChanged();
  } catch (...) {
    QTimer::singleShot(0, this, [thrown = std::current_exception()] { std::rethrow_exception(thrown); });
  }
}

void Document::reset(modeling::Scene scene, std::filesystem::path file, std::filesystem::path baseFolder) {
  const modeling::FileStamp stamp = modeling::FileStamp::of(file);
  baseFolder_ = std::move(baseFolder);
  replace(std::move(scene), std::move(file), stamp);
}

void Document::reset(modeling::Scene scene, std::filesystem::path file, const modeling::FileStamp& stamp) {
  baseFolder_.clear();
  replace(std::move(scene), std::move(file), stamp);
}

void Document::replace(modeling::Scene scene, std::filesystem::path file, const modeling::FileStamp& stamp) {
  gesture_.clear();
  undoStack_.clear();
  // To clear a stack that is empty leaves it as unclean as it was (findings/undo-stack-clear).
  undoStack_.setClean();
  scene_ = std::move(scene);
  savedScene_ = scene_;
  kept_ = std::make_shared<const modeling::Scene>(scene_);
  file_ = std::move(file);
  stamp_ = stamp;
  emit replaced();
  emit sceneChanged();
  emit statusChanged();
}

void Document::takeFromFile(modeling::Scene scene, const modeling::FileStamp& stamp) {
  edit(tr("Reload"), [&](modeling::Scene& changed) { changed = std::move(scene); });
  savedScene_ = scene_;
  stamp_ = stamp;
  undoStack_.setClean();
  emit statusChanged();
}

void Document::detachFromFile() {
  baseFolder_ = folder();
  file_.clear();
  markUnsaved();
  emit statusChanged();
}

sim::Status Document::saveTo(const std::filesystem::path& file) {
  const std::string text = modeling::writeScene(scene_);
  if (const sim::Status saved = modeling::replaceFile(file, text); !saved) return saved;
  file_ = file;
  stamp_ = modeling::FileStamp::ofText(text);
  savedScene_ = scene_;
  endGesture();
  undoStack_.setClean();
  emit statusChanged();
  return sim::Done{};
}

}  // namespace ui
