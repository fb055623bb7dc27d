#include "tests/monkey/chooser.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "tests/monkey/performer.h"
#include "ui/document/scene_edits.h"
#include "ui/kinds/new_things.h"
#include "ui/viewport/viewport.h"

namespace monkey {
namespace {

/// Keys that mean something somewhere, and some that do not. None of them closes the window.
const QStringList kKeys = {"Space",      "Space",       "Ctrl+Space",
                           "Ctrl+.",     "Left",        "Right",
                           "Shift+Left", "Shift+Right", "Shift+B",
                           "L",          "F4",          "Ctrl+Z",
                           "Ctrl+Z",     "Ctrl+Z",      "Ctrl+Shift+Z",
                           "Ctrl+Y",     "Delete",      "X",
                           "F2",         "Ctrl+D",      "H",
                           "Alt+H",      "Ctrl+A",      "Tab",
                           "Tab",        "Shift+Tab",   "F6",
                           "G",          "R",           "S",
                           "Q",          "Home",        "F",
                           "1",          "3",           "5",
                           "7",          "Alt+Z",       "F9",
                           "F12",        "Shift+A",     "Shift+H",
                           "Shift+N",    "Shift+P",     "Shift+K",
                           "Shift+R",    "Shift+E",     "Ctrl+Shift+Space",
                           "Ctrl+Home",  "Ctrl+P",      "F1",
                           "Ctrl+N",     "Ctrl+S",      "Ctrl+O",
                           "Escape",     "Escape",      "Return",
                           "Up",         "Down",        "PgUp",
                           "PgDown",     "Backspace",   "Ctrl+C",
                           "Ctrl+V",     "Y",           "Z",
                           "0",          "-",           ".",
                           "F11",        "Ctrl+Shift+S"};
/// No number makes a lattice that takes minutes to build.
const QStringList kTexts = {"1", "2.5", "0.5",  "10",    "-1",     "0",   "1e3", "1e9", "nan",    "abc",
                            "",  "1/0", "3 mm", "2 * 3", "handle", "cup", "a b", "-",   "1e-300", "100"};
const QStringList kFiles = {"",       "",      "a.scene.json",        "b.scene.json",
                            "c.take", "p.png", "nowhere/d.scene.json"};

/// What it is about is asked often; what ends the window, or opens what is not the program's, never.
bool mayTrigger(const QAction& action) {
  static const QStringList kNever = {"&Quit", "&About Smithereens"};
  return action.isEnabled() && action.isVisible() && action.menu() == nullptr && !action.isSeparator() &&
         !action.text().isEmpty() && !kNever.contains(action.text());
}

std::vector<QWidget*> seenIn(QWidget& top) {
  std::vector<QWidget*> seen;
  for (QWidget* widget : top.findChildren<QWidget*>()) {
    if (widget->window() == top.window() && widget->isVisible() && widget->isEnabled() &&
        !widget->visibleRegion().isEmpty() && qobject_cast<QDockWidget*>(widget) == nullptr)
      seen.push_back(widget);
  }
  return seen;
}

QString text(const QPoint& at) {
  return QString::number(at.x()) + u'\t' + QString::number(at.y());
}

Action pointed(const char* verb, const QPoint& at, const QStringList& more = {}, int wait = 5) {
  return {wait, QString::fromLatin1(verb), text(at).split(u'\t') + more};
}

}  // namespace

int Chooser::number(int below) {
  // Not a distribution of the library, which may differ from one to the next.
  return below <= 1 ? 0 : static_cast<int>(random_() % static_cast<std::uint64_t>(below));
}

bool Chooser::chance(double share) {
  return number(1'000'000) < share * 1e6;
}

QString Chooser::word(const QStringList& words) {
  return words[number(static_cast<int>(words.size()))];
}

QString Chooser::modifiers() {
  return chance(0.8) ? QStringLiteral("none") : word({"shift", "control", "alt", "shift+control"});
}

Action Chooser::next() {
  if (planned_.empty()) planned_.push_back(choose());
  Action action = planned_.front();
  planned_.pop_front();
  if (chance(0.03)) action.wait += number(300);
  if (action.verb == QLatin1String("press")) held_ = true;
  if (action.verb == QLatin1String("release")) held_ = false;
  return action;
}

Action Chooser::choose() {
  if (QWidget* popup = QApplication::activePopupWidget()) return inPopup(*popup);
  if (QWidget* modal = QApplication::activeModalWidget()) return inDialog(*modal);
  if (held_) return whileHeld();
  const int kind = number(100);
  if (kind < 42) return pointer();
  if (kind < 62) return key();
  if (kind < 70) return typed();
  if (kind < 78) return menu();
  if (kind < 88) return fromElsewhere();
  if (kind < 94) return ofTheRun();
  return {number(60), "rest", {}};
}

Action Chooser::inPopup(QWidget& popup) {
  const int kind = number(10);
  if (kind < 3) return {5, "key", {"Escape"}};
  if (kind < 5) return {5, "key", {word({"Down", "Up", "Return", "Right", "Left", "Tab"})}};
  if (kind == 5) return fromElsewhere();
  if (kind == 6) return typed();
  const QPoint at = chance(0.85) ? placeIn(popup) : QPoint(number(1280), number(800));
  planned_.push_back(pointed("release", at, {"left", "none"}));
  return pointed("press", at, {"left", "none"});
}

Action Chooser::inDialog(QWidget& dialog) {
  if (qobject_cast<QFileDialog*>(&dialog) != nullptr) return {5, "file", {word(kFiles)}};
  const int kind = number(10);
  if (kind < 2) return {5, "key", {"Escape"}};
  if (kind == 2) return key();
  if (kind == 3) return typed();
  const QList<QPushButton*> buttons = dialog.findChildren<QPushButton*>();
  QPoint at = placeIn(dialog);
  if (!buttons.isEmpty() && chance(0.4)) {
    const QPushButton* button = buttons[number(static_cast<int>(buttons.size()))];
    at = button->mapToGlobal(button->rect().center());
  }
  planned_.push_back(pointed("release", at, {"left", "none"}));
  return pointed("press", at, {"left", "none"});
}

/// What is held is where most can go wrong.
Action Chooser::whileHeld() {
  const int kind = number(20);
  if (kind < 9) {
    at_ += QPoint(number(81) - 40, number(61) - 30);
    return pointed("move", at_, {"left", modifiers()});
  }
  if (kind < 11) return fromElsewhere();
  if (kind < 12) return ofTheRun();
  if (kind < 14) return key();
  return pointed("release", at_, {"left", "none"});
}

Action Chooser::fromElsewhere() {
  const int kind = number(20);
  if (kind < 6) return {5, "undo", {}};
  if (kind < 8) return {5, "redo", {}};
  const modeling::Scene& scene = window_.session().document().scene();
  const int which = 1 + number(5);
  const auto count = static_cast<int>(ui::countOf(scene, static_cast<ui::ItemKind>(which)));
  const QStringList item{QString::number(which), QString::number(number(count))};
  if (kind < 11) return {5, "remove", item};
  if (kind < 14) return {5, "select", item};
  if (kind == 14) return {5, "rename", item + QStringList{word({"one", "two", "cup", "é"})}};
  if (kind == 15) return {5, "track", {QString::number(number(12))}};
  if (kind == 16 && scene.parts.size() < 6) {
    const auto& things = ui::newThings();
    return {5, "add", {QString::fromStdString(things[number(static_cast<int>(things.size()))].name)}};
  }
  if (kind == 17 && QApplication::activePopupWidget() == nullptr)
    return {5, chance(0.5) ? "open" : "reset", {word(Performer::sceneNames())}};
  return {5, "rest", {}};
}

Action Chooser::ofTheRun() {
  const QString which = QString::number(number(6));
  switch (number(8)) {
    case 0:
    case 1:
      return {5, "simulate", {}};
    case 2:
      return {5, "stop", {}};
    case 3:
      return {5, "take", {which}};
    case 4:
      return {5, "drop", {which}};
    default:
      return {5, "seek", {QString::number(number(40))}};
  }
}

QPoint Chooser::placeIn(QWidget& top) {
  const std::vector<QWidget*> seen = seenIn(top);
  QWidget* widget = seen.empty() ? &top : seen[number(static_cast<int>(seen.size()))];
  const QRect part = widget->visibleRegion().boundingRect();
  const QRect inside = part.isEmpty() ? widget->rect() : part;
  return widget->mapToGlobal(inside.topLeft() + QPoint(number(inside.width()), number(inside.height())));
}

Action Chooser::pointer() {
  QWidget* top = &window_;
  if (chance(0.3)) {
    QWidgetList others = QApplication::topLevelWidgets();
    others.removeIf([](const QWidget* widget) { return !widget->isVisible() || !widget->isEnabled(); });
    if (!others.isEmpty()) top = others[number(static_cast<int>(others.size()))];
  }
  at_ = placeIn(*top);
  if (chance(0.25)) at_ = placeIn(window_.viewport());
  const int kind = number(20);
  if (kind < 2) return pointed("wheel", at_, {word({"120", "-120", "-120", "240"}), modifiers()});
  if (kind < 3) return pointed("double", at_, {"left", "none"});
  const QString button = kind < 16 ? QStringLiteral("left") : word({"right", "middle"});
  const QString keys = modifiers();
  if (button == QLatin1String("left") && chance(0.4)) return pointed("press", at_, {button, keys});
  if (button == QLatin1String("middle"))
    planned_.push_back(pointed("move", at_ + QPoint(number(101) - 50, number(101) - 50), {button, keys}));
  planned_.push_back(pointed("release", at_, {button, keys}));
  return pointed("press", at_, {button, keys});
}

Action Chooser::key() {
  if (!held_ && chance(0.15)) grabByKey();
  return {5, "key", {word(kKeys)}};
}

/// A selected thing in the hand, and numbers typed.
void Chooser::grabByKey() {
  const QPoint at = placeIn(window_.viewport());
  planned_.push_back({5, "select", {"1", "0"}});
  planned_.push_back(pointed("move", at, {"none", "none"}));
  planned_.push_back({5, "key", {word({"G", "R", "S"})}});
  for (const char* letter : {"Z", "1", "0"}) planned_.push_back({5, "key", {QString::fromLatin1(letter)}});
  if (chance(0.5)) planned_.push_back(fromElsewhere());
  planned_.push_back({5, "key", {word({"Return", "Escape"})}});
}

Action Chooser::typed() {
  Action action{5, "type", {word(kTexts)}};
  if (chance(0.7)) planned_.push_back({5, "key", {word({"Return", "Tab", "Escape", "Ctrl+Z"})}});
  return action;
}

Action Chooser::menu() {
  QStringList texts;
  for (const QAction* action : window_.findChildren<QAction*>())
    if (mayTrigger(*action)) texts.append(action->text());
  return texts.isEmpty() ? key() : Action{5, "trigger", {word(texts)}};
}

}  // namespace monkey
