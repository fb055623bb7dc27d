#include "tests/monkey/performer.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>

#include "modeling/scene/scene_file.h"
#include "modeling/scene/tracks.h"
#include "ui/document/scene_edits.h"
#include "ui/kinds/new_things.h"
#include "ui/viewport/viewport.h"

namespace monkey {
namespace {

Qt::MouseButton buttonOf(const QString& word) {
  if (word == QLatin1String("right")) return Qt::RightButton;
  return word == QLatin1String("middle") ? Qt::MiddleButton : Qt::LeftButton;
}

Qt::KeyboardModifiers modifiersOf(const QString& word) {
  Qt::KeyboardModifiers modifiers;
  if (word.contains(QLatin1String("shift"))) modifiers |= Qt::ShiftModifier;
  if (word.contains(QLatin1String("control"))) modifiers |= Qt::ControlModifier;
  if (word.contains(QLatin1String("alt"))) modifiers |= Qt::AltModifier;
  return modifiers;
}

QWindow* handleOf(QWidget* widget) {
  return widget != nullptr ? widget->window()->windowHandle() : nullptr;
}

/// One event at a time: any of them may close the window that it goes to, and QTest::keyClick would send the
/// next to it all the same.
void click(const QPointer<QWindow>& window, Qt::Key key, Qt::KeyboardModifiers modifiers) {
  const bool writes = (modifiers & ~Qt::KeyboardModifiers(Qt::ShiftModifier)) == Qt::NoModifier;
  const char letter = writes ? QTest::keyToAscii(key) : '\0';
  QString text = letter != '\0' ? QString(QLatin1Char(letter)) : QString();
  if (modifiers.testFlag(Qt::ShiftModifier)) text = text.toUpper();
  for (const bool press : {true, false}) {
    if (window) QTest::simulateEvent(window.data(), press, key, modifiers, text, false);
  }
}

ui::Item itemOf(const QStringList& words) {
  return {static_cast<ui::ItemKind>(words.value(0).toInt()),
          static_cast<std::size_t>(words.value(1).toInt())};
}

void addTrackOf(modeling::Scene& scene, std::size_t which) {
  const std::vector<modeling::TargetName> targets = modeling::targetsOf(scene);
  const std::size_t track = modeling::addTrack(scene, targets[which % targets.size()]);
  for (const double time : {0.05, 0.1})
    modeling::addKey(scene.tracks[track], time, modeling::valueAt(scene.tracks[track], time));
}

}  // namespace

Performer::Performer(ui::MainWindow& window, std::filesystem::path folder)
    : window_(window), folder_(std::move(folder)) {}

QWidget* Performer::topWindow(const QPoint& at) {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  if (QWidget* modal = QApplication::activeModalWidget()) return modal;
  return QApplication::topLevelAt(at);
}

void Performer::perform(const Action& action) {
  const bool known = point(action.verb, action.words) || press(action.verb, action.words) ||
                     change(action.verb, action.words) || run(action.verb, action.words);
  if (!known) qWarning("monkey: nobody knows \"%s\"", qPrintable(action.verb));
}

bool Performer::point(const QString& verb, const Words& words) {
  if (!(QStringList{"press", "move", "release", "double", "wheel"}.contains(verb))) return false;
  const QPoint at(words.value(0).toInt(), words.value(1).toInt());
  QWidget* top = topWindow(at);
  QWindow* window = handleOf(top);
  if (window == nullptr) return true;
  const QPoint local = top->mapFromGlobal(at);
  const Qt::MouseButton button = buttonOf(words.value(2));
  const Qt::KeyboardModifiers modifiers = modifiersOf(words.value(3));
  // What shortcuts ask for is where the pointer of the screen is.
  QCursor::setPos(at);
  if (verb == QLatin1String("press")) QTest::mousePress(window, button, modifiers, local);
  if (verb == QLatin1String("release")) QTest::mouseRelease(window, button, modifiers, local);
  if (verb == QLatin1String("double")) QTest::mouseDClick(window, button, modifiers, local);
  if (verb == QLatin1String("move")) QTest::mouseMove(window, local);
  if (verb == QLatin1String("wheel")) {
    QWidget* under = top->childAt(local);
    if (under == nullptr) under = top;
    QWheelEvent event(under->mapFromGlobal(QPointF(at)), at, {}, {0, words.value(2).toInt()}, Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(under, &event);
  }
  return true;
}

bool Performer::press(const QString& verb, const Words& words) {
  QWidget* focus = QApplication::focusWidget();
  QPointer<QWindow> window = handleOf(QApplication::activePopupWidget());
  if (window == nullptr) window = focus != nullptr ? handleOf(focus) : handleOf(topWindow(QCursor::pos()));
  if (verb == QLatin1String("key")) {
    const QKeySequence keys(words.value(0));
    if (keys.isEmpty() || window == nullptr) return true;
    click(window, keys[0].key(), keys[0].keyboardModifiers());
  } else if (verb == QLatin1String("type")) {
    if (window == nullptr) return true;
    for (const QChar letter : words.value(0)) click(window, QTest::asciiToKey(letter.toLatin1()), {});
  } else if (verb == QLatin1String("file")) {
    chooseFile(words.value(0));
  } else if (verb == QLatin1String("trigger")) {
    trigger(words.value(0));
  } else {
    return verb == QLatin1String("rest");
  }
  return true;
}

void Performer::chooseFile(const QString& name) {
  auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
  if (dialog == nullptr) return;
  auto* field = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
  if (name.isEmpty() || field == nullptr) return dialog->reject();
  field->setText(QString::fromStdString((folder_ / name.toStdString()).string()));
  QTest::keyClick(field, Qt::Key_Return);
}

void Performer::trigger(const QString& name) {
  if (QApplication::activeModalWidget() != nullptr) return;
  for (QAction* action : window_.findChildren<QAction*>()) {
    if (action->text() == name && action->isEnabled() && action->menu() == nullptr) return action->trigger();
  }
}

bool Performer::change(const QString& verb, const Words& words) {
  ui::Document& document = window_.session().document();
  const ui::Item item = itemOf(words);
  const bool there = item.index < ui::countOf(document.scene(), item.kind);
  if (verb == QLatin1String("undo")) {
    document.undoStack().undo();
  } else if (verb == QLatin1String("redo")) {
    document.undoStack().redo();
  } else if (verb == QLatin1String("select")) {
    if (there) window_.session().selection().select(item);
  } else if (verb == QLatin1String("remove")) {
    if (there && !ui::removalProblem(document.scene(), std::vector{item}))
      document.edit("Delete", [&](modeling::Scene& scene) { ui::remove(scene, std::vector{item}); });
  } else if (verb == QLatin1String("rename")) {
    if (there)
      document.edit("Rename",
                    [&](modeling::Scene& scene) { ui::rename(scene, item, words.value(2).toStdString()); });
  } else if (verb == QLatin1String("add")) {
    document.edit("Add", [&](modeling::Scene& scene) {
      ui::addThing(scene, ui::newThing(words.value(0).toStdString()), window_.session().selection().items());
    });
  } else if (verb == QLatin1String("track")) {
    document.edit("Add Track", [&](modeling::Scene& scene) { addTrackOf(scene, words.value(0).toUInt()); });
  } else {
    return false;
  }
  return true;
}

bool Performer::run(const QString& verb, const Words& words) {
  ui::Session& session = window_.session();
  const std::size_t which = words.value(0).toUInt();
  if (verb == QLatin1String("open") || verb == QLatin1String("reset")) {
    load(words.value(0), verb == QLatin1String("open"));
  } else if (verb == QLatin1String("simulate")) {
    session.simulate();
  } else if (verb == QLatin1String("stop")) {
    session.stopRun();
  } else if (verb == QLatin1String("seek")) {
    session.playback().seek(which);
  } else if (verb == QLatin1String("take")) {
    session.takes().select(which);
  } else if (verb == QLatin1String("drop")) {
    session.takes().remove(which);
  } else {
    return false;
  }
  return true;
}

void Performer::load(const QString& name, bool asking) {
  if (asking) return window_.files().open(folder_ / (name.toStdString() + ".scene.json"));
  window_.session().document().reset(sceneNamed(name), {});
  window_.showViewport();
}

void Performer::calm() {
  ui::Session& session = window_.session();
  session.stopRun();
  trigger(QStringLiteral("&Reset Layout"));
  window_.showNormal();
  window_.setGeometry(0, 0, 1280, 800);
  load(QStringLiteral("slab"), false);
  while (!session.takes().empty()) session.takes().remove(session.takes().size() - 1);
}

QStringList Performer::sceneNames() {
  return {"cup", "slab", "tracks", "shards", "empty", "many"};
}

}  // namespace monkey
