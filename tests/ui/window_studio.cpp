#include "tests/ui/window_studio.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QScreen>
#include <QTest>
#include <QTimer>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace tests {
namespace {

/// Where something goes on moving, such as the sample of a material, its picture is taken all the same.
constexpr int kMostLooks = 30;
constexpr int kBetweenLooks = 120;  // ms

QString plain(QString text) {
  return text.remove(u'&').remove(QStringLiteral("…"));
}

QWidget* openWidget() {
  if (QWidget* popup = QApplication::activePopupWidget()) return popup;
  return QApplication::activeModalWidget();
}

}  // namespace

WindowStudio::WindowStudio(QString folder, QStringList themes)
    : folder_(std::move(folder)), themes_(std::move(themes)) {
  for (const QString& theme : themes_) QDir().mkpath(folder_ + u'/' + theme);
  const std::filesystem::path root = desk() / "sessions";
  autosaves_ = root;
  const std::filesystem::path own = ui::Autosave::newFolder(root);
  session_ = std::make_unique<ui::Session>(own);
  autosave_ = std::make_unique<ui::Autosave>(*session_, own);
  window_ = std::make_unique<ui::MainWindow>(*session_);
  window_->setGeometry(QGuiApplication::primaryScreen()->geometry());
  window_->show();
  waitUntil("the window", [this] { return window_->isVisible() && window_->windowHandle()->isExposed(); });
  window_->activateWindow();
  waitUntil("the focus", [this] { return window_->isActiveWindow(); });
}

WindowStudio::~WindowStudio() = default;

void WindowStudio::raise(const char* dock) {
  auto& found = find<QDockWidget>(dock);
  found.show();
  found.raise();
}

QAction& WindowStudio::action(const QString& text) {
  for (QAction* action : window_->findChildren<QAction*>()) {
    if (plain(action->text()) == text) return *action;
  }
  qFatal("there is no action %s", qPrintable(text));
}

void WindowStudio::trigger(const QString& text) {
  action(text).trigger();
}

void WindowStudio::waitUntil(const char* what, const std::function<bool()>& condition) {
  constexpr int kMost = 300000;  // ms
  if (!QTest::qWaitFor(condition, kMost)) qFatal("waited in vain for %s", what);
}

QImage WindowStudio::seen(QWidget* of) {
  QScreen* screen = QGuiApplication::primaryScreen();
  QRect place = screen->geometry();
  if (of != nullptr) place = QRect(of->mapToGlobal(QPoint(0, 0)), of->size()) & place;
  return screen->grabWindow(0, place.x(), place.y(), place.width(), place.height())
      .toImage()
      .convertToFormat(QImage::Format_RGB32);
}

void WindowStudio::settle() {
  if (window_->viewport().isVisible())
    waitUntil("the picture", [this] { return window_->viewport().isUpToDate(); });
  QImage before;
  for (int look = 0; look < kMostLooks; ++look) {
    QTest::qWait(kBetweenLooks);
    QImage now = seen(nullptr);
    if (now == before) return;
    before = std::move(now);
  }
}

void WindowStudio::take(const QString& name, QWidget* of) {
  // Where it points at nothing.
  QCursor::setPos(window_->geometry().bottomRight());
  for (const QString& theme : themes_) {
    const auto kind = theme == QLatin1String("light") ? ui::ThemeKind::light : ui::ThemeKind::dark;
    if (ui::Theme::instance().kind() != kind) ui::Theme::instance().apply(kind);
    settle();
    const QString file = folder_ + u'/' + theme + u'/' + name + QStringLiteral(".png");
    if (!seen(of).save(file)) qFatal("cannot write %s", qPrintable(file));
  }
}

void WindowStudio::whileOpen(const std::function<void()>& open,
                             const std::function<void(QWidget&)>& meanwhile) {
  QTimer look;
  look.setInterval(kBetweenLooks);
  QObject::connect(&look, &QTimer::timeout, [&] {
    QWidget* opened = openWidget();
    if (opened == nullptr || !opened->isVisible()) return;
    look.stop();
    meanwhile(*opened);
    opened->close();
  });
  look.start();
  open();
  waitUntil("something to open", [&] { return !look.isActive(); });
}

void WindowStudio::takeMenu(const QString& name, const std::function<void()>& open) {
  whileOpen(open, [&](QWidget& opened) { take(name, &opened); });
}

void WindowStudio::load(const modeling::Scene& scene, const QString& name) {
  window_->viewport().setTool(nullptr);
  session_->stopRun();
  waitUntil("the run to stop", [this] { return !session_->hasRun(); });
  while (!session_->takes().empty()) session_->takes().remove(0);
  session_->document().reset(
      scene, name.isEmpty() ? std::filesystem::path() : desk() / (name.toStdString() + ".scene.json"));
  window_->showViewport();
  waitUntil("the scene", [this] {
    return !session_->isBuilding() && session_->preview()->scene == session_->document().scene();
  });
  settle();
  window_->viewport().frameAll();
}

void WindowStudio::simulate() {
  session_->simulate();
  waitUntil("the run", [this] { return session_->run()->phase == ui::RunPhase::done; });
}

}  // namespace tests
