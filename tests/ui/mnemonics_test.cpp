// A letter with Alt means one thing, in each menu and in each dialog.
#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>
#include <map>

#include <catch2/catch.hpp>

#include "tests/ui/whole_window.h"
#include "ui/editors/render_dialog.h"
#include "ui/panels/preflight_dialog.h"

namespace {

using Letters = std::map<QString, QStringList>;  // what answers to each

void note(const QString& text, Letters& letters) {
  const QString letter = QKeySequence::mnemonic(text).toString();
  if (!letter.isEmpty()) letters[letter].append(text);
}

void checkOneEach(const Letters& letters) {
  for (const auto& [letter, texts] : letters) {
    INFO(letter.toStdString() << ": " << texts.join(u", ").toStdString());
    CHECK(texts.size() == 1);
  }
}

/// Menus below it are looked at, too.
void checkMenu(const QString& name, const QList<QAction*>& actions) {
  Letters letters;
  for (const QAction* action : actions) {
    note(action->text(), letters);
    if (action->menu() != nullptr) checkMenu(action->text(), action->menu()->actions());
  }
  INFO(name.toStdString());
  checkOneEach(letters);
}

void checkDialog(const QDialog& dialog) {
  Letters letters;
  for (const auto* button : dialog.findChildren<QAbstractButton*>()) note(button->text(), letters);
  for (const auto* label : dialog.findChildren<QLabel*>())
    if (label->buddy() != nullptr) note(label->text(), letters);
  INFO(dialog.windowTitle().toStdString());
  checkOneEach(letters);
}

TEST_CASE("each letter of a menu chooses one thing, and none of the bar is a shortcut besides",
          "[mnemonics]") {
  tests::WholeWindow desk;
  const QList<QAction*> bar = desk.window.menuBar()->actions();
  REQUIRE(bar.size() >= 6);
  checkMenu(QStringLiteral("bar"), bar);
  Letters letters;
  for (const QAction* menu : bar) note(menu->text(), letters);
  for (const QAction* action : desk.window.findChildren<QAction*>()) {
    for (const QKeySequence& key : action->shortcuts()) {
      INFO(key.toString().toStdString() << " of " << action->text().toStdString());
      CHECK_FALSE(letters.contains(key.toString()));
    }
  }
}

TEST_CASE("each letter of a dialog chooses one thing", "[mnemonics]") {
  tests::WholeWindow desk;
  std::size_t seen = 0;
  const auto look = [&] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* dialog = qobject_cast<QDialog*>(widget);
      if (dialog == nullptr || !dialog->isVisible()) continue;
      checkDialog(*dialog);
      ++seen;
      dialog->close();
    }
  };
  for (const char* text : {"Shortcuts", "About Smithereens", "Pre-flight", "Render"}) {
    for (QAction* action : desk.window.findChildren<QAction*>()) {
      if (action->text().remove(u'&').remove(QStringLiteral("…")) != QLatin1String(text)) continue;
      QTimer::singleShot(200, qApp, look);
      action->trigger();
      QTest::qWait(400);
      break;
    }
  }
  CHECK(seen >= 4);
}

}  // namespace
