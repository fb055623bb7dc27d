// The tests of the window: a real application on the display it is given (tests/ui/with_display).
#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <catch2/catch.hpp>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport_renderer.h"

int main(int argc, char** argv) {
  // What a person keeps is neither read nor touched.
  const QTemporaryDir home;
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
    qputenv(variable, home.path().toUtf8());
  // Smooth edges take a processor that draws twice as long.
  ui::ViewportRenderer::askForContexts(1);
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  QApplication application(argc, argv);
  ui::Theme::instance().apply(ui::ThemeKind::dark);
  return Catch::Session().run(argc, argv);
}
