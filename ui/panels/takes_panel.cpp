#include "ui/panels/takes_panel.h"

#include <QAction>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/takes_model.h"
#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"

namespace ui {

TakesPanel::TakesPanel(Session& session, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), actions_(actions) {
  setObjectName(QStringLiteral("takesPanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  model_ = new TakesModel(session_, this);
  list_ = new QListView(this);
  list_->setModel(model_);
  list_->setItemDelegate(new TakeDelegate(session_, list_));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setUniformItemSizes(true);
  list_->setMouseTracking(true);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setAccessibleName(tr("Takes"));
  stack_ = new QStackedWidget(this);
  stack_->addWidget(makeEmpty());
  stack_->addWidget(list_);
  column->addWidget(stack_, 1);
  makeButtons();
  column->addWidget(bar_);
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) {
    session_.takes().select(static_cast<std::size_t>(index.row()));
  });
  connect(list_, &QListView::activated, this, &TakesPanel::play);
  connect(list_, &QListView::customContextMenuRequested, this, &TakesPanel::showMenu);
  connect(&session_.takes(), &TakeList::changed, this, &TakesPanel::showTakes);
  connect(model_, &QAbstractItemModel::modelReset, this, &TakesPanel::selectInList);
  showTakes();
}

QWidget* TakesPanel::makeEmpty() {
  auto* empty = new QWidget(this);
  auto* column = new QVBoxLayout(empty);
  column->setContentsMargins(20, 20, 20, 20);
  auto* text = new QLabel(tr("No takes yet.\nEach simulation becomes one: press Space."), empty);
  text->setAlignment(Qt::AlignCenter);
  text->setWordWrap(true);
  text->setForegroundRole(QPalette::PlaceholderText);
  auto* openButton = new QPushButton(tr("Open a Take..."), empty);
  connect(openButton, &QPushButton::clicked, this, &TakesPanel::open);
  column->addStretch(1);
  column->addWidget(text);
  column->addSpacing(6);
  column->addWidget(openButton, 0, Qt::AlignCenter);
  column->addStretch(2);
  return empty;
}

void TakesPanel::makeButtons() {
  bar_ = new QWidget(this);
  auto* column = new QVBoxLayout(bar_);
  column->setContentsMargins(8, 6, 8, 6);
  note_ = new QLineEdit(bar_);
  note_->setPlaceholderText(tr("Note on this take"));
  note_->setObjectName(QStringLiteral("takeNote"));
  connect(note_, &QLineEdit::editingFinished, this, &TakesPanel::takeNote);
  // What is typed and not confirmed is not lost with the program either.
  auto* pause = new QTimer(this);
  pause->setSingleShot(true);
  pause->setInterval(2000);
  connect(pause, &QTimer::timeout, this, &TakesPanel::takeNote);
  connect(note_, &QLineEdit::textEdited, pause, qOverload<>(&QTimer::start));
  column->addWidget(note_);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  const auto make = [&](const QString& icon, const QString& text, const QString& tip) {
    auto* action = new QAction(Theme::icon(icon), text, this);
    action->setToolTip(tip);
    auto* button = new QToolButton(bar_);
    button->setDefaultAction(action);
    row->addWidget(button);
    return action;
  };
  play_ = make(QStringLiteral("play"), tr("Play"), tr("Play this take  (Enter)"));
  auto* go = new QToolButton(bar_);
  go->setDefaultAction(actions_.continueChanged);
  row->addWidget(go);
  rename_ = make(QStringLiteral("rename"), tr("Rename"), tr("Rename this take  (F2)"));
  remove_ = make(QStringLiteral("delete-take"), tr("Delete"), tr("Delete this take  (Del)"));
  row->addStretch(1);
  save_ = make(QStringLiteral("save-take"), tr("Save As..."), tr("Save this take as a file of its own"));
  open_ = make(QStringLiteral("open-take"), tr("Open..."), tr("Open a take from a file"));
  column->addLayout(row);
  list_->installEventFilter(this);
  connect(play_, &QAction::triggered, this, &TakesPanel::play);
  connect(rename_, &QAction::triggered, this,
          [this] { list_->edit(model_->index(static_cast<int>(selected()))); });
  connect(remove_, &QAction::triggered, this, &TakesPanel::remove);
  connect(save_, &QAction::triggered, this, &TakesPanel::saveAs);
  connect(open_, &QAction::triggered, this, &TakesPanel::open);
}

/// In the list Delete and F2 are meant for takes, not for what is selected in the scene.
bool TakesPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool asked = event->type() == QEvent::ShortcutOverride;
  if (!asked && event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Delete && key != Qt::Key_F2) return QWidget::eventFilter(watched, event);
  event->accept();
  if (!asked && key == Qt::Key_Delete) remove();
  return asked || key == Qt::Key_Delete;
}

std::size_t TakesPanel::selected() const {
  return session_.takes().current().value_or(session_.takes().size());
}

/// It is of the take at which typing began, whichever is on the timeline by now.
void TakesPanel::takeNote() {
  const std::optional<std::size_t> take = session_.takes().find(noted_.lock());
  if (note_->isModified() && take) session_.takes().setNote(*take, note_->text());
  note_->setModified(false);
  showTakes();
}

void TakesPanel::showTakes() {
  const bool some = !session_.takes().empty();
  stack_->setCurrentIndex(some ? 1 : 0);
  bar_->setVisible(some);
  const bool chosen = selected() < session_.takes().size();
  for (QAction* action : {play_, rename_, remove_, save_}) action->setEnabled(chosen);
  note_->setEnabled(chosen);
  if (!note_->hasFocus() || !note_->isModified()) {
    const QString note = chosen ? session_.takes()[selected()].note : QString();
    if (note_->text() != note) note_->setText(note);
    noted_ = session_.takes().currentFootage();
  }
  selectInList();
}

void TakesPanel::selectInList() {
  const QModelIndex index = model_->index(static_cast<int>(selected()));
  if (index.isValid() && list_->currentIndex() != index) list_->setCurrentIndex(index);
}

void TakesPanel::play() {
  const QModelIndex index = list_->currentIndex();
  if (index.isValid()) session_.takes().select(static_cast<std::size_t>(index.row()));
  session_.playback().play(1);
}

void TakesPanel::remove() {
  const std::size_t take = selected();
  if (take >= session_.takes().size()) return;
  const std::shared_ptr<Footage> meant = session_.takes()[take].footage;
  QMessageBox box(
      QMessageBox::Question, tr("Delete Take"),
      tr("Delete \"%1\"? Its recording is deleted from the disk.").arg(session_.takes()[take].name),
      QMessageBox::Cancel, this);
  QPushButton* yes = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  // Runs go on while the question stands: the list may be another.
  const std::optional<std::size_t> still = session_.takes().find(meant);
  if (box.clickedButton() == yes && still) session_.takes().remove(*still);
}

void TakesPanel::saveAs() {
  const std::size_t take = selected();
  if (take >= session_.takes().size()) return;
  const std::shared_ptr<Footage> meant = session_.takes()[take].footage;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save Take"), session_.takes()[take].name + ".take", tr("Takes (*.take)"));
  const std::optional<std::size_t> still = session_.takes().find(meant);
  if (file.isEmpty() || !still) return;
  if (const sim::Status saved = session_.takes().save(*still, file.toStdString()); !saved)
    session_.report(saved.problem());
}

void TakesPanel::open() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open Take"), {}, tr("Takes (*.take)"));
  if (file.isEmpty()) return;
  if (const sim::Status opened = session_.takes().open(file.toStdString()); !opened)
    session_.report(opened.problem());
}

void TakesPanel::showMenu(const QPoint& at) {
  const QModelIndex index = list_->indexAt(at);
  if (index.isValid()) session_.takes().select(static_cast<std::size_t>(index.row()));
  QMenu menu(this);
  connect(&session_.takes(), &TakeList::currentChanged, &menu, &QWidget::close);
  if (index.isValid()) {
    menu.addAction(play_);
    menu.addAction(actions_.continueAsWas);
    menu.addAction(actions_.continueChanged);
    menu.addSeparator();
    menu.addAction(rename_);
    menu.addAction(remove_);
    menu.addAction(save_);
    menu.addSeparator();
  }
  menu.addAction(open_);
  menu.exec(list_->viewport()->mapToGlobal(at));
}

}  // namespace ui
