#pragma once

#include <QTemporaryDir>
#include <filesystem>
#include <functional>
#include <memory>

#include "ui/session/session.h"

/// Small scenes and takes for tests of the window.
namespace tests {

/// A slab that falls on a floor and stays whole.
modeling::Scene fallingSlab();
/// A brittle one, thrown down, that breaks.
modeling::Scene breakingSlab();

/// A run of the scene from the start, without a window.
std::uint64_t hashOfHeadlessRun(const modeling::Scene& scene);

/// A take of frames at these times, in none of which anything moves; `breaks` bonds broke in each.
std::shared_ptr<ui::Footage> stillFootage(const std::vector<double>& times,
                                          const std::vector<std::size_t>& breaks = {});

/// Waits for other threads, with the event loop running; a minute is for machines under a sanitizer.
bool becomesTrue(const std::function<bool()>& condition);

/// A session that keeps its takes in a folder of its own.
struct SessionFixture {
  QTemporaryDir folder;
  ui::Session session{std::filesystem::path(folder.path().toStdString())};

  /// Loads the scene and waits until it is shown.
  void load(const modeling::Scene& scene);
  /// Runs it to its end.
  void simulateToEnd();
};

}  // namespace tests
