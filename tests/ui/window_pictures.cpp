// Takes pictures of all of the window, for docs/guide/the-window.md and to be looked at:
//   draw-window FOLDER [THEME]... [PART]...
// on a screen that the window fills. docs/guide/draw does it.
#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <fstream>

#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"
#include "tests/ui/window_studio.h"
#include "ui/document/new_scene.h"
#include "ui/editors/editor_actions.h"
#include "ui/editors/glue_editing.h"
#include "ui/editors/glue_pairs.h"
#include "ui/editors/profile_canvas.h"
#include "ui/editors/render_dialog.h"
#include "ui/editors/threshold_dialog.h"
#include "ui/files/kept_takes.h"
#include "ui/files/recovery.h"
#include "ui/panels/add_actions.h"
#include "ui/panels/diagnostics_panel.h"
#include "ui/panels/live_panel.h"
#include "ui/panels/preflight_dialog.h"
#include "ui/panels/section.h"
#include "ui/theme/theme.h"
#include "ui/timeline/timeline.h"
#include "ui/timeline/track_rows.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_renderer.h"

namespace {

using modeling::Scene;
using tests::WindowStudio;
using ui::Item;
using ui::ItemKind;

Scene withThings(const std::vector<const char*>& names) {
  Scene scene = ui::newScene();
  std::vector<Item> selected;
  for (const char* name : names) selected = {ui::addThing(scene, ui::newThing(name), selected)};
  return scene;
}

Scene cup() {
  Scene scene = withThings({"cup", "handle"});
  scene.name = "My cup";
  return scene;
}

modeling::SceneTrack track(sim::TrackTarget target, const std::vector<std::pair<double, double>>& keys,
                           sim::Interpolation interpolation) {
  modeling::SceneTrack made;
  made.target.target = target;
  made.interpolation = interpolation;
  for (const auto& [time, value] : keys) {
    modeling::SceneTrackKey key;
    key.time = time;
    key.value = value;
    made.keys.push_back(key);
  }
  return made;
}

/// A cup that falls a little askew, breaks, and is made to sneeze.
Scene fallingCup() {
  Scene scene = cup();
  for (modeling::Part& part : scene.parts) {
    part.worldFromPart.position.z() = 12.0;
    part.worldFromPart.rotation.value = sim::Vec3(0.0, 25.0, 0.0);
    part.velocity.z() = -300.0;
  }
  scene.output = {200.0, 0.3};
  scene.tracks.push_back(track(sim::TrackTarget::gravityScale, {{0.0, 1.0}, {0.12, 3.0}, {0.2, 1.0}},
                               sim::Interpolation::smooth));
  scene.tracks.push_back(track(sim::TrackTarget::stiffnessScale, {{0.0, 1.0}, {0.22, 0.2}, {0.25, 1.0}},
                               sim::Interpolation::step));
  return scene;
}

/// One of everything that has properties of its own.
Scene oneOfEach(const std::filesystem::path& folder) {
  Scene scene = withThings({"cup", "handle", "slab", "patch", "box", "sphere", "cylinder"});
  std::filesystem::copy_file(modeling::resourcesFolder() / "scenes" / "meshes" / "fluted-vase.obj",
                             folder / "fluted-vase.obj");
  ui::addMesh(scene, "fluted-vase.obj", {});
  ui::addMeshObstacle(scene, "fluted-vase.obj");
  scene.environment.colliders.back().name = "mesh in the way";
  scene.environment.colliders.back().active = {0.1, 0.25};
  scene.tracks = fallingCup().tracks;
  return scene;
}

void takeGallery(WindowStudio& studio) {
  studio.window().showGallery();
  studio.take("gallery");
}

void takeEmptyScene(WindowStudio& studio) {
  studio.window().files().newScene();
  studio.take("empty-scene");
}

void takeAuthoring(WindowStudio& studio) {
  studio.load(cup());
  studio.session().selection().select({ItemKind::part, 0});
  studio.take("cup");
  studio.session().selection().select({ItemKind::part, 1});
  studio.take("handle");
  studio.trigger("Move");
  studio.take("move");
  studio.trigger("Select");
}

/// The way of docs/guide/first-cup.md.
void takeFirstCup(WindowStudio& studio) {
  Scene scene = cup();
  for (modeling::Part& part : scene.parts) part.worldFromPart.position.z() = 40.0;
  scene.output.duration = 0.42;
  studio.load(scene);
  studio.session().selection().set({{ItemKind::part, 0}, {ItemKind::part, 1}});
  studio.simulate();
  studio.session().selection().clear();
  ui::Playback& playback = studio.session().playback();
  playback.toLast();
  ui::ViewCamera camera = studio.window().viewport().camera();
  camera.frame(Eigen::AlignedBox3d(sim::Vec3(-14.0, -14.0, 0.0), sim::Vec3(14.0, 14.0, 18.0)),
               studio.window().viewport().viewSize());
  studio.window().viewport().flyTo(camera);
  studio.take("first-cup-broken");
  playback.toFirstBreak();
  studio.take("first-cup-first-break");
}

void takeProperties(WindowStudio& studio) {
  studio.load(oneOfEach(studio.desk()), "table");
  const Scene& scene = studio.session().document().scene();
  QWidget& panel = studio.find("properties");
  studio.take("outliner", &studio.find("outliner"));
  studio.take("properties-scene", &panel);
  for (auto* section : panel.findChildren<ui::Section*>()) section->setOpen(true);
  studio.settle();
  QScrollBar* bar = panel.findChild<QScrollArea*>()->verticalScrollBar();
  bar->setValue(bar->maximum());
  studio.take("properties-scene-view", &panel);
  for (const ItemKind kind :
       {ItemKind::part, ItemKind::gluing, ItemKind::collider, ItemKind::material, ItemKind::track}) {
    for (std::size_t i = 0; i < ui::countOf(scene, kind); ++i) {
      studio.session().selection().select({kind, i});
      QString name = ui::nameOf(scene, {kind, i}).toLower().replace(u' ', u'-');
      studio.take("properties-" + name, &panel);
    }
  }
}

void takeEditors(WindowStudio& studio) {
  studio.load(cup());
  studio.session().selection().select({ItemKind::part, 0});
  studio.trigger("Edit Points");
  studio.take("profile");
  studio.trigger("Edit Points");
  studio.session().selection().select({ItemKind::part, 1});
  studio.trigger("Edit Points");
  studio.take("points-of-a-handle");
  studio.window().viewport().setTool(nullptr);
  studio.session().selection().clear();
  studio.trigger("Glue Parts");
  studio.take("glue-choosing");
  auto& gluing = studio.window().findChild<ui::EditorActions*>()->glueEditing();
  gluing.edit(0);
  studio.waitUntil("the pairs", [&] { return gluing.outcome() && !gluing.isBusy(); });
  studio.take("glue");
  gluing.end();
  ui::ViewSettings view = studio.window().viewport().viewSettings();
  view.gluePairs = view.xray = true;
  studio.window().viewport().setViewSettings(view);
  const auto& pairs = *studio.window().viewport().findChild<ui::GluePairs*>();
  studio.waitUntil("the pairs", [&] { return !pairs.links().empty(); });
  studio.take("view-glue-pairs", &studio.window().viewport());
  view.gluePairs = view.xray = false;
  studio.window().viewport().setViewSettings(view);
  studio.load(withThings({"patch"}));
  studio.session().selection().select({ItemKind::part, 0});
  studio.trigger("Edit Points");
  studio.take("points-of-a-patch");
  studio.window().viewport().setTool(nullptr);
}

void takeThreshold(WindowStudio& studio) {
  studio.load(cup());
  studio.trigger("Tune Threshold");
  auto* dialog = studio.window().findChild<ui::ThresholdDialog*>();
  dialog->start();
  studio.waitUntil("the threshold", [&] { return dialog->progress().ended; });
  studio.take("threshold", dialog);
  dialog->close();
}

void takeRun(WindowStudio& studio) {
  studio.load(fallingCup());
  studio.raise("live");
  studio.take("live");
  studio.simulate();
  studio.session().playback().toFirstBreak();
  studio.session().playback().stepBy(8);
  const std::size_t frame = studio.session().playback().frame();
  studio.take("run");
  studio.raise("properties");
  auto& rows = studio.find<ui::Timeline>("timeline").rows();
  rows.setExpanded(0, true);
  const QPointF key = rows.pointOf({0, 1});
  QTest::mouseClick(&rows, Qt::LeftButton, {}, key.toPoint());
  studio.take("tracks");
  QTest::mouseDClick(&rows, Qt::LeftButton, {}, key.toPoint());
  studio.take("track-key");
  QApplication::activePopupWidget()->close();
  rows.setExpanded(0, false);
  studio.raise("takes");
  studio.take("takes");
  studio.session().document().edit("Heavier", [](Scene& scene) { scene.materials[0].values.density = 3.0; });
  studio.take("stale");
  studio.session().document().undoStack().undo();
  studio.waitUntil("the scene as it was", [&] { return !studio.session().isBuilding(); });
  studio.settle();
  studio.session().playback().seek(frame);
  studio.waitUntil("the frame", [&] { return studio.session().shown().recorded; });
  studio.raise("outliner");
}

void takeDiagnostics(WindowStudio& studio) {
  studio.raise("diagnostics");
  auto* plots = studio.window().findChild<ui::DiagnosticsPanel*>();
  const char* names[] = {"energy", "breaking", "step", "speed", "work"};
  for (std::size_t plot = 0; plot < std::size(names); ++plot) {
    plots->showPlot(plot);
    studio.take(QStringLiteral("diagnostics-") + names[plot], plot == 0 ? nullptr : plots);
  }
  studio.find("diagnostics").hide();
}

void takeViews(WindowStudio& studio) {
  using ui::ViewSettings;
  ui::Viewport& viewport = studio.window().viewport();
  const ViewSettings usual = viewport.viewSettings();
  const std::pair<const char*, std::function<void(ViewSettings&)>> views[] = {
      {"surface", [](ViewSettings&) {}},
      {"fragments", [](ViewSettings& view) { view.colouring = ui::Colouring::fragments; }},
      {"quality", [](ViewSettings& view) { view.colouring = ui::Colouring::quality; }},
      {"nodes",
       [](ViewSettings& view) {
         view.surface = false;
         view.nodes = true;
       }},
      {"bonds",
       [](ViewSettings& view) {
         view.surface = false;
         view.bonds = true;
       }},
      {"broken-bonds",
       [](ViewSettings& view) {
         view.surface = false;
         view.bonds = view.brokenBonds = true;
       }},
      {"x-ray", [](ViewSettings& view) { view.xray = view.bonds = true; }},
      {"exploded", [](ViewSettings& view) { view.explode = 0.8; }},
      {"level-surface",
       [](ViewSettings& view) {
         view.surface = false;
         view.levelSurface = true;
       }},
      {"tetrahedra", [](ViewSettings& view) { view.isolated = ui::IsolatedNodes::tetrahedra; }},
      {"statistics", [](ViewSettings& view) { view.statistics = true; }}};
  for (const auto& [name, choose] : views) {
    ViewSettings settings = usual;
    choose(settings);
    viewport.setViewSettings(settings);
    studio.take(QStringLiteral("view-") + name, &viewport);
  }
  viewport.setViewSettings(usual);
  auto buttons = studio.find("viewBar").parentWidget()->findChildren<QAbstractButton*>();
  for (QAbstractButton* button : buttons) {
    if (button->accessibleName() != QLatin1String("What is shown")) continue;
    studio.whileOpen([&] { button->click(); }, [&](QWidget&) { studio.take("view-choices"); });
  }
}

void takeInspector(WindowStudio& studio) {
  ui::Viewport& viewport = studio.window().viewport();
  ui::ViewSettings bonds = viewport.viewSettings();
  bonds.surface = false;
  bonds.bonds = true;
  const ui::ViewSettings usual = viewport.viewSettings();
  viewport.setViewSettings(bonds);
  studio.settle();
  studio.raise("inspector");
  const auto& shown = studio.session().shown();
  for (std::size_t bond = 0; bond < shown.network->bondCount(); ++bond) {
    const auto index = static_cast<sim::BondIndex>(bond);
    const auto& positions = shown.moment->positions;
    const sim::Vec3 middle =
        0.5 * (positions[shown.network->bondStart(index)] + positions[shown.network->bondEnds[bond]]);
    const std::optional<QPointF> at = viewport.project(middle);
    if (!at || viewport.pickAt(*at).kind != ui::Pick::Kind::bond) continue;
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, at->toPoint());
    break;
  }
  studio.take("inspector");
  viewport.setViewSettings(usual);
  studio.raise("properties");
}

void takeRender(WindowStudio& studio) {
  studio.trigger("Render");
  auto* dialog = studio.window().findChild<ui::RenderDialog*>("render-dialog");
  studio.waitUntil("the preview", [dialog] { return dialog->view().image && dialog->view().ended; });
  studio.take("render", dialog);
  dialog->close();
}

void takeDialogs(WindowStudio& studio) {
  studio.load(cup());
  studio.trigger("Pre-flight");
  auto* preflight = studio.window().findChild<ui::PreflightDialog*>();
  studio.waitUntil("pre-flight", [&] { return preflight->isDone(); });
  studio.take("pre-flight", preflight);
  preflight->close();
  studio.takeMenu("shortcuts", [&] { studio.trigger("Shortcuts"); });
  studio.takeMenu("about", [&] { studio.trigger("About Smithereens"); });
  studio.session().document().edit("Move", [](Scene& scene) { scene.parts[0].velocity.x() = 1.0; });
  studio.takeMenu("unsaved-changes", [&] { studio.window().files().mayLeave(); });
  studio.takeMenu("mesh-question", [&] {
    studio.window().findChild<ui::AddActions*>()->askAboutMesh(modeling::resourcesFolder() / "scenes" /
                                                               "meshes" / "fluted-vase.obj");
  });
}

void takeProblems(WindowStudio& studio) {
  const auto file = studio.desk() / "damaged.scene.json";
  std::ofstream(file)
      << "{\n  \"smithereens\": 1,\n  \"parts\": [{\"name\": \"cup\", \"kind\": \"revolutoin\"}]\n}\n";
  studio.load(cup());
  studio.window().files().open(file);
  studio.take("broken-file");
  studio.load(cup());
  studio.session().document().edit("Wrong", [](Scene& scene) {
    std::get<modeling::RevolutionShape>(scene.parts[0].shape).resolution.counts[0] = 7;
  });
  studio.session().selection().select({ItemKind::part, 0});
  studio.waitUntil("the problem", [&] { return studio.session().preview()->problem.has_value(); });
  studio.take("problem-of-a-part");
}

void takeRecovery(WindowStudio& studio) {
  const auto root = studio.desk() / "killed";
  const auto folder = ui::Autosave::newFolder(root);
  {
    ui::Session other(folder);
    ui::Autosave autosave(other, folder);
    other.document().reset(cup(), {});
    other.document().markUnsaved();
    autosave.write();
    std::filesystem::copy(folder, root / "left", std::filesystem::copy_options::recursive);
  }
  std::ofstream(root / "left" / "running", std::ios::trunc) << "999999\nsmithereens\n\n";
  studio.load(ui::newScene());
  ui::Autosave autosave(studio.session(), ui::Autosave::newFolder(root));
  ui::KeptTakes kept(studio.session(), studio.desk() / "takes");
  ui::Recovery recovery(studio.session(), kept, autosave, root, &studio.window());
  studio.takeMenu("recovery", [&] { recovery.offer(); });
}

void takeMenus(WindowStudio& studio) {
  studio.load(cup());
  studio.session().selection().select({ItemKind::part, 0});
  for (QAction* action : studio.window().menuBar()->actions()) {
    QMenu* menu = action->menu();
    const QRect place = studio.window().menuBar()->actionGeometry(action);
    const QPoint below = studio.window().menuBar()->mapToGlobal(place.bottomLeft());
    studio.takeMenu("menu-" + action->text().remove(u'&').toLower(), [&] { menu->exec(below); });
  }
}

void takeLongRun(WindowStudio& studio) {
  auto fine = modeling::loadScene(modeling::resourcesFolder() / "scenes" / "teapot-drop-fine.scene.json");
  if (!fine) qFatal("%s", fine.problem().line().c_str());
  fine->scene.output.duration = 20.0;
  studio.load(fine->scene);
  studio.session().simulate();
  studio.waitUntil("the notice", [&] { return studio.find("long-run").isVisible(); });
  studio.session().pauseRun(true);
  studio.take("long-run");
  studio.session().stopRun();
}

void takeRecent(WindowStudio& studio) {
  const std::pair<const char*, Scene> scenes[] = {{"my-cup", cup()}, {"vase", withThings({"vase"})}};
  for (const auto& [name, scene] : scenes) {
    const auto file = studio.desk() / (std::string(name) + ".scene.json");
    if (!modeling::saveScene(scene, file)) qFatal("cannot save");
    studio.load(ui::newScene());
    studio.window().files().open(file);
    studio.settle();
    studio.window().viewport().frameAll();
    studio.settle();
    studio.window().showGallery();
  }
  studio.take("gallery-with-recent");
}

struct Part {
  const char* name;
  void (*take)(WindowStudio&);
};

constexpr Part kParts[] = {{"gallery", takeGallery},         {"empty-scene", takeEmptyScene},
                           {"authoring", takeAuthoring},     {"first-cup", takeFirstCup},
                           {"properties", takeProperties},   {"editors", takeEditors},
                           {"threshold", takeThreshold},     {"run", takeRun},
                           {"diagnostics", takeDiagnostics}, {"views", takeViews},
                           {"inspector", takeInspector},     {"render", takeRender},
                           {"dialogs", takeDialogs},         {"problems", takeProblems},
                           {"recovery", takeRecovery},       {"menus", takeMenus},
                           {"long-run", takeLongRun},        {"recent", takeRecent}};

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir home;
  for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
    qputenv(variable, home.path().toUtf8());
  ui::ViewportRenderer::askForContexts();
  QApplication::setApplicationName(QStringLiteral("Smithereens"));
  QApplication::setOrganizationName(QStringLiteral("Smithereens"));
  QApplication application(argc, argv);
  QApplication::setCursorFlashTime(0);
  QStringList arguments = QApplication::arguments().mid(1);
  if (arguments.isEmpty()) qFatal("draw-window FOLDER [dark|light]... [PART]...");
  const QString folder = arguments.takeFirst();
  QStringList themes;
  for (const char* theme : {"dark", "light"}) {
    if (arguments.removeAll(QLatin1String(theme)) > 0) themes.append(QLatin1String(theme));
  }
  if (themes.isEmpty()) themes = {"dark", "light"};
  ui::Theme::instance().apply(themes.front() == "light" ? ui::ThemeKind::light : ui::ThemeKind::dark);
  WindowStudio studio(folder, themes);
  for (const Part& part : kParts) {
    if (arguments.isEmpty() || arguments.contains(QLatin1String(part.name))) part.take(studio);
  }
  return 0;
}
