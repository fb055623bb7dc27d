#pragma once

#include <QApplication>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QTimer>
#include <filesystem>
#include <fstream>
#include <string>

namespace tests {

/// A process id that no process has any more.
inline qint64 endedProcess() {
  QProcess process;
  process.start("true", QStringList());
  process.waitForStarted();
  const qint64 id = process.processId();
  process.waitForFinished();
  return id;
}

/// What a killed program leaves: its folder, and a lock that nobody holds.
inline std::filesystem::path leaveBehind(const std::filesystem::path& folder,
                                         const std::filesystem::path& root,
                                         const std::string& name = "left-behind") {
  const std::filesystem::path left = root / name;
  std::filesystem::copy(folder, left, std::filesystem::copy_options::recursive);
  std::ofstream lock(left / "running", std::ios::trunc);
  lock << endedProcess() << "\nsmithereens\n" << QSysInfo::machineHostName().toStdString() << "\n";
  return left;
}

/// Answers the next question with the button of that text; what it asked comes into `asked`.
inline void answer(const QString& button, QString* asked = nullptr) {
  QTimer::singleShot(100, [button, asked] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* box = qobject_cast<QMessageBox*>(widget);
      if (box == nullptr || !box->isVisible()) continue;
      if (asked != nullptr) *asked = box->text() + u'\n' + box->informativeText();
      for (QAbstractButton* choice : box->buttons()) {
        if (choice->text().remove('&') == button) choice->click();
      }
    }
  });
}

}  // namespace tests
