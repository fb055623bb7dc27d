// The monkey uses the real window by chance, for as long as it is told, and says what broke.
#include <QCommandLineParser>
#include <QDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"
#include "tests/monkey/chooser.h"
#include "tests/monkey/performer.h"
#include "tests/monkey/watch.h"
#include "ui/files/autosave.h"
#include "ui/files/kept_takes.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport_renderer.h"
#include "ui/window/application.h"
#include "ui/window/memory.h"

namespace {

struct Orders {
  std::uint64_t seed = 1;
  long actions = 0;  ///< 0: as many as there is time for
  double seconds = 60.0;
  std::string replay;   ///< a log; empty: by chance
  std::string log;      ///< empty: none
  double calm = 20.0;   ///< s: after so long memory is looked at
  double growth = 0.0;  ///< share by which the memory may grow; 0: not looked at
};

Orders ordersOf(const QStringList& arguments) {
  QCommandLineParser parser;
  parser.setApplicationDescription("Uses the window by chance, or as a log says, and reports what broke.");
  parser.addHelpOption();
  parser.addOptions(
      {{"seed", "What chance begins with.", "N", "1"},
       {"actions", "At most so many.", "N", "0"},
       {"seconds", "At most so long.", "S", "60"},
       {"replay", "Does what the log says.", "LOG"},
       {"log", "Writes what is done.", "FILE"},
       {"calm", "Every so long all is closed, one small scene opened, and memory looked at.", "S", "20"},
       {"growth", "The share by which memory may grow after the first sixth of the time.", "SHARE", "0"}});
  parser.process(arguments);
  return {parser.value("seed").toULongLong(), parser.value("actions").toLong(),
          parser.value("seconds").toDouble(), parser.value("replay").toStdString(),
          parser.value("log").toStdString(),  parser.value("calm").toDouble(),
          parser.value("growth").toDouble()};
}

/// Scenes of the gallery may be saved, too: the monkey has copies of all resources.
void moveResourcesTo(const std::filesystem::path& folder) {
  std::filesystem::copy(modeling::resourcesFolder(), folder, std::filesystem::copy_options::recursive);
  qputenv("SMITHEREENS_RESOURCES", QByteArray::fromStdString(folder.string()));
}

/// The window as the program opens it, in a home of its own.
struct Cage {
  explicit Cage(const std::filesystem::path& home)
      : folder(ui::Autosave::newFolder(home / "sessions")),
        session(folder),
        autosave(session, folder),
        takes(session, home / "takes"),
        window(session) {
    for (const QString& name : monkey::Performer::sceneNames()) {
      if (!modeling::saveScene(monkey::sceneNamed(name), home / (name.toStdString() + ".scene.json")))
        qFatal("monkey: the scenes cannot be written");
    }
    window.setGeometry(0, 0, 1280, 800);
    window.show();
    window.activateWindow();
  }

  std::filesystem::path folder;
  ui::Session session;
  ui::Autosave autosave;
  ui::KeptTakes takes;
  ui::MainWindow window;
};

/// Does one action after the other, from the event loop, also from those of dialogs.
class Player {
 public:
  Player(const Orders& orders, Cage& cage, const std::filesystem::path& home, monkey::Watch& watch)
      : orders_(orders), watch_(watch), performer_(cage.window, home), chooser_(cage.window, orders.seed) {
    if (!orders.log.empty()) log_.open(orders.log);
    if (!orders.replay.empty()) script_.open(orders.replay);
    clock_.start();
  }

  void next() {
    const std::optional<monkey::Action> action = wanted();
    if (!action) return finish();
    if (action->verb == QLatin1String("calm")) return calmDown();
    QTimer::singleShot(action->wait, qApp, [this, one = *action] {
      ++count_;
      if (log_.is_open()) log_ << one.line() << std::endl;
      watch_.begin(one.line());
      // Before it is done: a dialog comes back when it is closed, and somebody has to close it.
      QTimer::singleShot(0, qApp, [this] { nextWhenReady(); });
      ++under_;
      performer_.perform(one);
      --under_;
    });
  }
  /// What an action waits for, such as the end of a drag, is let go on after a while; else it is to end
  /// first.
  void nextWhenReady(int waited = 0) {
    constexpr int kWait = 5;       // ms
    constexpr int kLongest = 200;  // ms
    const bool asked =
        QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr;
    if (under_ == 0 || asked || waited > kLongest) return next();
    QTimer::singleShot(kWait, qApp, [this, waited] { nextWhenReady(waited + kWait); });
  }
  long count() const { return count_; }

 private:
  std::optional<monkey::Action> wanted() {
    const bool late = static_cast<double>(clock_.elapsed()) > 1e3 * orders_.seconds;
    if (ended_ || late || (orders_.actions > 0 && count_ >= orders_.actions)) return std::nullopt;
    if (!script_.is_open()) {
      const bool due = static_cast<double>(clock_.elapsed()) > calmAt_ + 1e3 * orders_.calm;
      return due && chooser_.idle() ? monkey::Action{0, QStringLiteral("calm"), {}} : chooser_.next();
    }
    std::string line;
    while (std::getline(script_, line))
      if (auto action = monkey::Action::read(QString::fromStdString(line))) return action;
    return std::nullopt;
  }
  /// Closes what is open before the window, and then calls. Dialogs keep the event loop until they are
  /// closed.
  void closeAllAndThen(const std::function<void()>& then) {
    if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QDialog*>(widget); dialog != nullptr && dialog->isVisible())
        dialog->reject();
    const bool open = QApplication::activeModalWidget() != nullptr ||
                      QApplication::activePopupWidget() != nullptr || under_ > 0;
    if (!open) return then();
    QTimer::singleShot(20, qApp, [this, then] { closeAllAndThen(then); });
  }
  void finish() {
    ended_ = true;
    // Not quit(), which asks about what is not saved.
    closeAllAndThen([] { QApplication::exit(); });
  }
  /// Brings the window to where its memory can be compared, and looks.
  void calmDown() {
    constexpr int kUntilBuilt = 2000;  // ms
    watch_.begin("calm");
    if (log_.is_open()) log_ << monkey::Action{0, QStringLiteral("calm"), {}}.line() << std::endl;
    closeAllAndThen([this] {
      performer_.calm();
      QTimer::singleShot(kUntilBuilt, qApp, [this] {
        watch_.lookAtMemory();
        calmAt_ = static_cast<double>(clock_.elapsed());
        next();
      });
    });
  }

  const Orders& orders_;
  monkey::Watch& watch_;
  monkey::Performer performer_;
  monkey::Chooser chooser_;
  std::ofstream log_;
  std::ifstream script_;
  QElapsedTimer clock_;
  long count_ = 0;
  double calmAt_ = 0.0;  ///< ms
  int under_ = 0;        ///< actions that are under way, one within the other
  bool ended_ = false;
};

int report(const Orders& orders, long actions, int caught, const monkey::Watch& watch) {
  for (const monkey::Stall& stall : watch.stalls())
    std::cout << "stalled " << stall.own << " s (" << stall.seconds << " by the clock"
              << (stall.drawing ? ", in the driver of OpenGL" : "") << ") during: " << stall.during << '\n';
  const std::size_t every = std::max<std::size_t>(1, watch.memory().size() / 30);
  for (std::size_t i = 0; i < watch.memory().size(); i += every) {
    const monkey::Memory& memory = watch.memory()[i];
    std::cout << memory.seconds << " s: " << memory.resident << " MB, asked for " << memory.asked << " MB, "
              << memory.widgets << " widgets\n";
  }
  const double growth = watch.growth();
  std::cout << "seed " << orders.seed << ", " << actions << " actions, " << caught << " caught, "
            << watch.ownStalls() << " stalls, longest wait " << watch.longest() << " s, memory grew by "
            << 100.0 * growth << " per cent\n";
  const bool grew = orders.growth > 0.0 && growth > orders.growth;
  return caught == 0 && watch.ownStalls() == 0 && !grew ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int argc, char** argv) {
  // What a person keeps is neither read nor touched.
  const QTemporaryDir home;
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
    qputenv(variable, home.path().toUtf8());
  ui::shareHeaps();
  ui::ViewportRenderer::askForContexts(1);
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  ui::Application application(argc, argv);
  ui::giveBackNowAndThen(application);
  const Orders orders = ordersOf(QApplication::arguments());
  const std::filesystem::path folder = home.path().toStdString();
  moveResourcesTo(folder / "resources");
  std::filesystem::current_path(folder);
  QApplication::setQuitOnLastWindowClosed(false);
  ui::Theme::instance().apply(ui::ThemeKind::dark);
  monkey::Watch watch;
  Cage cage(folder);
  ui::spreadNet(application, cage.session, cage.autosave);
  QObject::connect(&application, &ui::Application::caught,
                   [](const sim::Problem& problem) { monkey::Watch::tellThrow(problem.what); });
  Player player(orders, cage, folder, watch);
  player.next();
  QApplication::exec();
  return report(orders, player.count(), application.caughtCount(), watch);
}
