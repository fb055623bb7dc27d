#include "modeling/scene/tracks.h"
#include "tests/monkey/performer.h"
#include "ui/document/new_scene.h"
#include "ui/document/scene_edits.h"
#include "ui/kinds/new_things.h"

namespace monkey {
namespace {

modeling::Scene slab(double speed) {
  modeling::Scene scene = ui::newScene();
  modeling::Part part;
  part.name = "slab";
  part.material = scene.materials.front().name;
  part.shape = modeling::SlabShape{sim::Vec3(4.0, 4.0, 1.0), {1.0, {}}};
  part.worldFromPart.position.z() = 2.0;
  part.velocity.z() = -speed;
  scene.parts.push_back(part);
  return scene;
}

void addTracks(modeling::Scene& scene) {
  for (const modeling::TargetName& target : modeling::targetsOf(scene)) {
    const std::size_t track = modeling::addTrack(scene, target);
    modeling::addKey(scene.tracks[track], 0.1, modeling::valueAt(scene.tracks[track], 0.1));
  }
}

}  // namespace

modeling::Scene sceneNamed(const QString& name) {
  modeling::Scene scene = ui::newScene();
  if (name == QLatin1String("slab")) scene = slab(0.0);
  if (name == QLatin1String("shards")) scene = slab(600.0);
  if (name == QLatin1String("tracks")) {
    scene = slab(100.0);
    addTracks(scene);
  }
  if (name == QLatin1String("cup") || name == QLatin1String("many")) {
    const ui::Item cup = ui::addThing(scene, ui::newThing("cup"), {});
    ui::addThing(scene, ui::newThing("handle"), {cup});
  }
  if (name == QLatin1String("many")) {
    for (const ui::NewThing& thing : ui::newThings()) ui::addThing(scene, thing, {});
  }
  scene.output = {100.0, 0.3};
  return scene;
}

}  // namespace monkey
