#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <cstdlib>
#include <iostream>

#include "ui/files/autosave.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

namespace {

/// The viewport needs OpenGL 3.3; it says so itself where it does not get it.
void askForOpenGl() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(4);
  QSurfaceFormat::setDefaultFormat(format);
}

int run(QApplication& application) {
  QCommandLineParser arguments;
  arguments.setApplicationDescription(
      QApplication::translate("main", "Dishes of nodes and springs that bend and break."));
  arguments.addHelpOption();
  arguments.addVersionOption();
  arguments.addPositionalArgument("file", QApplication::translate("main", "A scene or a take to open."),
                                  "[FILE]");
  arguments.process(application);

  const bool light = QSettings().value("theme").toString() == "light";
  ui::Theme::instance().apply(light ? ui::ThemeKind::light : ui::ThemeKind::dark);
  const std::filesystem::path root =
      std::filesystem::path(
          QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) /
      "sessions";
  const std::filesystem::path folder = ui::Autosave::newFolder(root);
  ui::Session session(folder);
  ui::Autosave autosave(session, folder);
  ui::MainWindow window(session);
  window.show();
  const QStringList files = arguments.positionalArguments();
  if (!files.isEmpty()) window.files().open(files.front().toStdString());
  window.offerLeftovers(root);
  return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
  askForOpenGl();
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  QApplication::setApplicationVersion(QStringLiteral(SMITHEREENS_VERSION));
  try {
    QApplication application(argc, argv);
    return run(application);
  } catch (const std::exception& exception) {
    std::cerr << "smithereens: stopped: " << exception.what() << '\n';
    return EXIT_FAILURE;
  }
}
