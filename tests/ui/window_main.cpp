// The tests of the window: a real application on the display it is given (tests/ui/with_display).
#define CATCH_CONFIG_RUNNER
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <iostream>

#include <catch2/catch.hpp>

#include "tests/ui/expected_catches.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport_renderer.h"
#include "ui/window/application.h"

int main(int argc, char** argv) {
  // What a person keeps is neither read nor touched.
  const QTemporaryDir home;
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
    qputenv(variable, home.path().toUtf8());
  // Smooth edges take a processor that draws twice as long.
  ui::ViewportRenderer::askForContexts(1);
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  ui::Application application(argc, argv);
  ui::Theme::instance().apply(ui::ThemeKind::dark);
  const int failed = Catch::Session().run(argc, argv);
  const int unexpected = application.caughtCount() - tests::expectedCatches();
  if (unexpected > 0) std::cerr << unexpected << " exceptions of event handlers were caught\n";
  return failed != 0 ? failed : unexpected;
}
