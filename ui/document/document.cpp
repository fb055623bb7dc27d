#include "ui/document/document.h"

#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_ranges.h"
#include "ui/document/edit_command.h"

namespace ui {

EditCommand::EditCommand(Document& document, const QString& name, modeling::Scene after, QString gesture)
    : QUndoCommand(name),
      document_(document),
      before_(document.scene()),
      after_(std::move(after)),
      gesture_(std::move(gesture)) {}

int EditCommand::id() const {
  return gesture_.isEmpty() ? -1 : 1;
}

bool EditCommand::mergeWith(const QUndoCommand* next) {
  const auto& later = static_cast<const EditCommand&>(*next);
  if (later.gesture_ != gesture_) return false;
  after_ = later.after_;
  setObsolete(after_ == before_);
  return true;
}

Document::Document(QObject* parent) : QObject(parent) {
  connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::statusChanged);
}

QString Document::title() const {
  if (!scene_.name.empty()) return QString::fromStdString(scene_.name);
  if (file_.empty()) return tr("Untitled");
  QString name = QString::fromStdString(file_.filename().string());
  name.remove(QStringLiteral(".scene.json"));
  return name;
}

void Document::edit(const QString& name, const Change& change, const QString& gesture) {
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
  undoStack_.push(new EditCommand(*this, name, std::move(after), unique));
}

void Document::setScene(const modeling::Scene& scene) {
  if (scene == scene_) return;
  const bool renamed = scene.name != scene_.name;
  scene_ = scene;
  emit sceneChanged();
  if (renamed) emit statusChanged();
}

void Document::reset(modeling::Scene scene, std::filesystem::path file, std::filesystem::path baseFolder) {
  gesture_.clear();
  undoStack_.clear();
  scene_ = std::move(scene);
  file_ = std::move(file);
  baseFolder_ = std::move(baseFolder);
  emit replaced();
  emit sceneChanged();
  emit statusChanged();
}

void Document::detachFromFile() {
  baseFolder_ = folder();
  file_.clear();
  markUnsaved();
  emit statusChanged();
}

sim::Status Document::saveTo(const std::filesystem::path& file) {
  if (const sim::Status saved = modeling::saveScene(scene_, file); !saved) return saved;
  file_ = file;
  endGesture();
  undoStack_.setClean();
  emit statusChanged();
  return sim::Done{};
}

}  // namespace ui
