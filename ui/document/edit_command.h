#pragma once

#include <QUndoCommand>

#include "ui/document/document.h"

namespace ui {

/// One step of the history: the scene before and after. A scene is a few kilobytes of values, so keeping it
/// is cheaper than a command class for every kind of edit, and undo cannot miss anything. The scene after a
/// step is that before the next, and kept once.
class EditCommand : public QUndoCommand {
 public:
  EditCommand(Document& document, const QString& name, Document::ScenePointer after, QString gesture);

  void undo() override { document_.setScene(before_); }
  void redo() override { document_.setScene(after_); }
  int id() const override;
  bool mergeWith(const QUndoCommand* next) override;

 private:
  Document& document_;
  Document::ScenePointer before_;
  Document::ScenePointer after_;
  QString gesture_;
};

}  // namespace ui
