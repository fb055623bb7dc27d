#include "ui/files/recovery.h"

#include <QCoreApplication>
#include <QLocale>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>

namespace ui {
namespace {

namespace fs = std::filesystem;

QString text(const fs::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace

Recovery::Recovery(Session& session, KeptTakes& kept, Autosave& autosave, fs::path root, QWidget* window)
    : QObject(window),
      session_(session),
      kept_(kept),
      autosave_(autosave),
      root_(std::move(root)),
      window_(window) {}

bool Recovery::isFree() const {
  const Document& document = session_.document();
  return document.file().empty() && !document.isModified() && document.scene().parts.empty() &&
         session_.takes().empty();
}

void Recovery::offer() {
  for (Leftover& leftover : leftoversIn(root_)) {
    if (!leftover.readable) {
      sayDamaged(leftover);
      continue;
    }
    // Takes of a scene that is saved belong with it, and there is nothing to ask.
    if (!leftover.modified && !leftover.file.empty()) {
      kept_.receive(leftover.takes, leftover.file);
      discard(leftover);
      continue;
    }
    switch (ask(leftover)) {
      case Choice::recover:
        recover(leftover);
        break;
      case Choice::discard:
        discard(leftover);
        break;
      case Choice::later:
        break;
    }
  }
}

void Recovery::takeUp(const fs::path& folder) {
  for (const Leftover& leftover : leftoverOf(folder)) {
    if (leftover.readable) recoverHere(leftover);
  }
}

Recovery::Choice Recovery::ask(const Leftover& leftover) {
  const QString title = Document::titleOf(leftover.scene, leftover.file);
  QMessageBox question(QMessageBox::Question, tr("Recover"),
                       tr("“%1” was not saved when the program ended unexpectedly.").arg(title),
                       QMessageBox::NoButton, window_);
  QStringList lines{tr("It was kept at %1.").arg(QLocale().toString(leftover.when, QLocale::ShortFormat))};
  if (!leftover.file.empty()) lines << tr("It is of %1, which stays as it is.").arg(text(leftover.file));
  if (!leftover.faults.empty())
    lines << tr("Some of it is damaged: %1").arg(QString::fromStdString(leftover.faults.front().line()));
  if (!isFree()) lines << tr("It comes into a window of its own.");
  question.setInformativeText(lines.join(u'\n'));
  QPushButton* recover = question.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* discard = question.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  question.addButton(tr("Later"), QMessageBox::RejectRole);
  question.setDefaultButton(recover);
  question.exec();
  if (question.clickedButton() == static_cast<QAbstractButton*>(recover)) return Choice::recover;
  return question.clickedButton() == static_cast<QAbstractButton*>(discard) ? Choice::discard : Choice::later;
}

void Recovery::recover(const Leftover& leftover) {
  if (isFree()) {
    recoverHere(leftover);
  } else {
    recoverBeside(leftover);
  }
}

void Recovery::recoverHere(const Leftover& leftover) {
  Document& document = session_.document();
  if (leftover.file.empty()) {
    document.reset(leftover.scene, {}, leftover.baseFolder);
    session_.takes().adopt(leftover.takes);
  } else {
    kept_.receive(leftover.takes, leftover.file);
    document.reset(leftover.scene, leftover.file, leftover.stamp);
  }
  document.markUnsaved();
  emit recovered();
  autosave_.write();
  if (leftover.faults.empty()) {
    discard(leftover);
  } else {
    sayDamaged(leftover);
  }
}

/// The other program locks it for itself.
void Recovery::recoverBeside(const Leftover& leftover) {
  leftover.lock->unlock();
  const QStringList arguments{QStringLiteral("--recover"), text(leftover.folder)};
  if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), arguments))
    session_.report({leftover.folder.string(),
                     "another window could not be opened for what is to be recovered",
                     "it stays where it is: start the program again without a file"});
}

void Recovery::sayDamaged(const Leftover& leftover) {
  const fs::path aside = putAside(leftover);
  QMessageBox told(QMessageBox::Warning, tr("Recover"),
                   leftover.readable
                       ? tr("Some of what was to be recovered is damaged and was left out.")
                       : tr("What an earlier window left behind is damaged and cannot be read."),
                   QMessageBox::Ok, window_);
  QStringList lines;
  for (const sim::Problem& fault : leftover.faults) lines << QString::fromStdString(fault.line());
  told.setInformativeText(tr("All of it is kept in %1.").arg(text(aside)));
  told.setDetailedText(lines.join(u'\n'));
  told.exec();
}

}  // namespace ui
