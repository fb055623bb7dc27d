#include "ui/document/new_scene.h"

#include "modeling/scene/resources.h"

namespace ui {

modeling::Scene newScene() {
  constexpr const char* kPreset = "tipsy-turvy-ceramic";
  modeling::Scene scene;
  modeling::SceneMaterial ceramic;
  ceramic.name = "ceramic";
  if (sim::Result<modeling::Material> preset = modeling::presetMaterial(kPreset)) {
    ceramic.preset = kPreset;
    ceramic.values = std::move(preset).value();
  }
  ceramic.values.name = ceramic.name;
  // The preset's own is for what is thrown. With this one a cup that falls from 40 cm breaks into ten large
  // shards, and one that falls from 10 cm stays whole.
  ceramic.values.threshold.mean = 0.03;
  scene.materials.push_back(std::move(ceramic));
  modeling::SceneCollider floor;
  floor.name = "floor";
  floor.form = modeling::FloorShape{};
  scene.environment.colliders.push_back(std::move(floor));
  scene.output.fps = 100.0;
  scene.output.duration = 1.0;
  return scene;
}

}  // namespace ui
