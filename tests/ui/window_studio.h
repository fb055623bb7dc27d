#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "ui/files/autosave.h"
#include "ui/window/main_window.h"

/// The real window on a screen of its own, from which pictures are taken as a person would see it.
namespace tests {

class WindowStudio {
 public:
  /// Pictures go to `folder`/THEME/NAME.png, one for each of the themes ("dark", "light"). The window fills
  /// the screen.
  WindowStudio(QString folder, QStringList themes);
  ~WindowStudio();

  ui::MainWindow& window() { return *window_; }
  ui::Session& session() { return *session_; }
  /// A folder to put files into; gone when the studio is.
  std::filesystem::path desk() const { return desk_.path().toStdString(); }

  /// A part of the window that is named.
  template <class Widget = QWidget>
  Widget& find(const char* name) {
    auto* found = window_->findChild<Widget*>(QString::fromLatin1(name));
    if (found == nullptr) qFatal("there is no %s", name);
    return *found;
  }
  void raise(const char* dock);
  /// What an action of a menu does, by its text without dots and ampersand.
  void trigger(const QString& text);
  QAction& action(const QString& text);

  /// The screen, or only what `of` covers of it, in each theme, once nothing moves any more.
  void take(const QString& name, QWidget* of = nullptr);
  /// The same while something is open that `open` returns from only when it is closed, such as a menu or a
  /// question; `meanwhile` gets it and may take other pictures.
  void whileOpen(const std::function<void()>& open, const std::function<void(QWidget&)>& meanwhile);
  void takeMenu(const QString& name, const std::function<void()>& open);

  /// Waits for other threads; ends the program where it does not come true.
  void waitUntil(const char* what, const std::function<bool()>& condition);
  void load(const modeling::Scene& scene, const QString& name = {});
  /// Runs what is loaded to its end.
  void simulate();
  /// Waits until what the window shows has been drawn.
  void settle();

 private:
  QImage seen(QWidget* of);
  QString folder_;
  QStringList themes_;
  QTemporaryDir desk_;
  std::filesystem::path autosaves_;
  std::unique_ptr<ui::Session> session_;
  std::unique_ptr<ui::Autosave> autosave_;
  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace tests
