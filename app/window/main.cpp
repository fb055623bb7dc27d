#include <QApplication>
#include <QDir>
#include <QStandardPaths>
#include <QSurfaceFormat>

#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSamples(4);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  QApplication application(argc, argv);
  ui::Theme::instance().apply(ui::ThemeKind::dark);

  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
  ui::Session session(std::filesystem::path(data.toStdString()) / "takes");
  ui::MainWindow window(session);
  const std::filesystem::path file = argc > 1
                                         ? std::filesystem::path(argv[1])
                                         : modeling::resourcesFolder() / "scenes" / "teapot-drop.scene.json";
  sim::Result<modeling::SceneFile> scene = modeling::loadScene(file);
  if (scene) {
    session.document().reset(std::move(scene->scene), file);
  } else {
    session.report(scene.problem());
  }
  window.show();
  return QApplication::exec();
}
