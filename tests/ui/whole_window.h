#pragma once

#include <QDockWidget>
#include <QTemporaryDir>
#include <QTest>
#include <filesystem>

#include <catch2/catch.hpp>

#include "ui/files/autosave.h"
#include "ui/session/session.h"
#include "ui/window/main_window.h"

namespace tests {

/// The window as the program opens it, active, with a folder of its own to keep things in.
struct WholeWindow {
  QTemporaryDir place;
  std::filesystem::path root = place.path().toStdString();
  std::filesystem::path folder = ui::Autosave::newFolder(root / "sessions");
  ui::Session session{folder};
  ui::MainWindow window{session};

  WholeWindow() {
    window.resize(1280, 800);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&window));
  }

  ui::Viewport& viewport() { return window.viewport(); }
  const modeling::Scene& scene() { return session.document().scene(); }
  void raise(const char* dock) {
    auto* found = window.findChild<QDockWidget*>(QString::fromLatin1(dock));
    REQUIRE(found != nullptr);
    found->show();
    found->raise();
  }
};

}  // namespace tests
