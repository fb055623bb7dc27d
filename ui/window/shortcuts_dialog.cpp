#include "ui/window/shortcuts_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/theme/theme.h"

namespace ui {
namespace {

QString plain(QString text) {
  return text.remove('&').remove(QStringLiteral("…"));
}

QString keysOf(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys.append(key.toString(QKeySequence::NativeText));
  return keys.join(QStringLiteral("  "));
}

void addRows(QTreeWidgetItem* under, const QList<QAction*>& actions) {
  for (const QAction* action : actions) {
    if (action->menu() != nullptr) {
      addRows(under, action->menu()->actions());
      continue;
    }
    if (action->shortcuts().isEmpty()) continue;
    auto* row = new QTreeWidgetItem(under, {plain(action->text()), keysOf(*action)});
    row->setFont(1, Theme::numberFont());
  }
}

/// Shows the rows that hold the words.
void filter(QTreeWidget& tree, const QString& words) {
  for (int g = 0; g < tree.topLevelItemCount(); ++g) {
    QTreeWidgetItem* group = tree.topLevelItem(g);
    bool any = false;
    for (int r = 0; r < group->childCount(); ++r) {
      QTreeWidgetItem* row = group->child(r);
      const bool fits = row->text(0).contains(words, Qt::CaseInsensitive) ||
                        row->text(1).contains(words, Qt::CaseInsensitive);
      row->setHidden(!fits);
      any |= fits;
    }
    group->setHidden(!any);
  }
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(QMainWindow& window) : QDialog(&window) {
  setWindowTitle(tr("Shortcuts"));
  resize(520, 560);
  auto* layout = new QVBoxLayout(this);
  auto* find = new QLineEdit(this);
  find->setPlaceholderText(tr("Find"));
  find->setClearButtonEnabled(true);
  auto* tree = new QTreeWidget(this);
  tree->setColumnCount(2);
  tree->setHeaderHidden(true);
  tree->setRootIsDecorated(false);
  tree->setSelectionMode(QAbstractItemView::NoSelection);
  for (const QAction* menu : window.menuBar()->actions()) {
    if (menu->menu() == nullptr) continue;
    auto* group = new QTreeWidgetItem(tree, {plain(menu->text())});
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    group->setFont(0, bold);
    addRows(group, menu->menu()->actions());
  }
  tree->expandAll();
  filter(*tree, {});
  tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  connect(find, &QLineEdit::textChanged, tree, [tree](const QString& words) { filter(*tree, words); });
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(find);
  layout->addWidget(tree, 1);
  layout->addWidget(buttons);
}

}  // namespace ui
