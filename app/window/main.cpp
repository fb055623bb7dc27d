#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSettings>
#include <QStandardPaths>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "ui/files/autosave.h"
#include "ui/files/kept_takes.h"
#include "ui/files/recovery.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport_renderer.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"
#include "ui/window/memory.h"

namespace {

/// Qt does not survive a window with a picture of OpenGL where there is none: better asked before.
bool hasOpenGl() {
  QOpenGLContext context;
  QOffscreenSurface surface;
  surface.create();
  return context.create() && context.makeCurrent(&surface) && context.format().version() >= std::pair(3, 3);
}

int complainOfOpenGl() {
  const QString words = QApplication::translate(
      "main",
      "Smithereens needs OpenGL 3.3 to draw, and this display does not offer it. Install a driver of your "
      "graphics card or Mesa's software renderer. smithereens-cli does everything without a window.");
  std::cerr << "smithereens: " << words.toStdString() << '\n';
  if (QGuiApplication::platformName() != QStringLiteral("offscreen"))
    QMessageBox::critical(nullptr, QStringLiteral("Smithereens"), words);
  return EXIT_FAILURE;
}

int run(ui::Application& application) {
  QCommandLineParser arguments;
  arguments.setApplicationDescription(
      QApplication::translate("main", "Dishes of nodes and springs that bend and break."));
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.addPositionalArgument("file", QApplication::translate("main", "A scene or a take to open."),
                                  "[FILE]");
  const QCommandLineOption recover(
      QStringLiteral("recover"),
      QApplication::translate("main", "Take up what a window that was killed left in this folder."),
      QStringLiteral("FOLDER"));
  arguments.addOption(recover);
  arguments.process(application);

  if (!hasOpenGl()) return complainOfOpenGl();
  const bool light = QSettings().value("theme").toString() == "light";
  ui::Theme::instance().apply(light ? ui::ThemeKind::light : ui::ThemeKind::dark);
  const std::filesystem::path data =
      QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString();
  const std::filesystem::path root = data / "sessions";
  const std::filesystem::path folder = ui::Autosave::newFolder(root);
  ui::Session session(folder);
  ui::Autosave autosave(session, folder);
  ui::KeptTakes takes(session, data / "takes");
  ui::MainWindow window(session);
  ui::spreadNet(application, session, autosave);
  window.show();
  const QStringList files = arguments.positionalArguments();
  if (!files.isEmpty()) window.files().open(files.front().toStdString());
  ui::Recovery recovery(session, takes, autosave, root, &window);
  QObject::connect(&recovery, &ui::Recovery::recovered, &window, &ui::MainWindow::showViewport);
  if (arguments.isSet(recover)) {
    recovery.takeUp(arguments.value(recover).toStdString());
  } else {
    recovery.offer();
  }
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
#ifdef SIGXFSZ
  // A file that may grow no further is a problem to be told of, as a full disk is, not the end of the
  // program.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  ui::shareHeaps();
  ui::ViewportRenderer::askForContexts();
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  QApplication::setApplicationVersion(QStringLiteral(SMITHEREENS_VERSION));
  try {
    ui::Application application(argc, argv);
    ui::giveBackNowAndThen(application);
    return run(application);
  } catch (const std::exception& exception) {
    std::cerr << "smithereens: stopped: " << exception.what() << '\n';
    return EXIT_FAILURE;
  }
}
