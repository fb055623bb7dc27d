#include <QCoreApplication>
#include <QGuiApplication>
#include <chrono>
#include <optional>

#include "modeling/scene/scene_file.h"
#include "tests/fuzz/trials.h"
#include "ui/files/kept_takes.h"
#include "ui/files/leftovers.h"

namespace tests {
namespace {

namespace fs = std::filesystem;

/// Until nothing more is to be done, or for a second.
void settle(const ui::Session& session) {
  const auto start = std::chrono::steady_clock::now();
  do {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  } while (session.isBuilding() && std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
  for (int turn = 0; turn < 20; ++turn) QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
}

/// Without a screen.
class HeadlessApplication {
 public:
  HeadlessApplication() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // What Qt says of the machine is no finding.
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    application_.emplace(count_, arguments_);
  }

 private:
  int count_ = 1;
  char name_[5] = "fuzz";
  char* arguments_[2] = {name_, nullptr};
  std::optional<QGuiApplication> application_;
};

}  // namespace

Finding tryKeptTakes(const fs::path& index) {
  const HeadlessApplication application;
  const fs::path folder = index.parent_path();
  const fs::path file = folder / "slab.scene.json";
  const auto scene = modeling::loadScene(file);
  if (!scene) return "WRONG: " + scene.problem().line();
  ui::Session session(folder / "recordings");
  Finding told;
  QObject::connect(&session, &ui::Session::problemFound, [&](const sim::Problem& problem) {
    told = refusal(problem.place, problem.what, problem.remedy);
  });
  ui::KeptTakes keeper(session, folder / "kept");
  const fs::path own = keeper.folderOf(file);
  fs::create_directories(own);
  fs::copy_file(index, own / "takes.json");
  fs::copy_file(folder / "run.take", own / "run.take");
  session.document().reset(scene->scene, file);
  settle(session);
  if (!fs::exists(own / "run.take")) return "WRONG: the take is gone";
  return told.empty() ? "read, " + std::to_string(session.takes().size()) + " takes listed" : told;
}

Finding tryRecovery(const fs::path& folder) {
  const HeadlessApplication application;
  const fs::path root = folder / "programs";
  const fs::path left = root / "left";
  fs::create_directories(left);
  for (const char* name : {"autosave.json", "autosave.scene.json", "run.take"})
    fs::copy_file(folder / name, left / name);
  const std::vector<ui::Leftover> leftovers = ui::leftoversIn(root);
  if (!fs::exists(left / "run.take")) return "WRONG: the take is gone";
  if (leftovers.size() != 1)
    return "WRONG: " + std::to_string(leftovers.size()) + " leftovers, though there is a take";
  if (!leftovers[0].readable && leftovers[0].faults.empty()) return "WRONG: no word about what is damaged";
  ui::Session session(folder / "recordings");
  session.document().reset(leftovers[0].scene, leftovers[0].file);
  session.takes().adopt(leftovers[0].takes);
  settle(session);
  return "read, " + std::to_string(session.takes().size()) + " takes";
}

}  // namespace tests
