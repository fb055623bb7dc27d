#include "ui/document/scene_edits.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/key_table.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneTrack;
using sim::TrackTarget;

SceneTrack* trackOf(Scene& scene, const Item& item) {
  return item.index < scene.tracks.size() ? &scene.tracks[item.index] : nullptr;
}

QString titleOf(const modeling::TargetName& target) {
  const QString object = QString::fromStdString(target.object);
  switch (target.target) {
    case TrackTarget::gravityScale:
      return PropertyForm::tr("Strength of gravity");
    case TrackTarget::gravity:
      return PropertyForm::tr("Gravity");
    case TrackTarget::stiffnessScale:
      return object.isEmpty() ? PropertyForm::tr("Stiffness")
                              : PropertyForm::tr("Stiffness of %1").arg(object);
    case TrackTarget::dampingScale:
      return object.isEmpty() ? PropertyForm::tr("Damping") : PropertyForm::tr("Damping of %1").arg(object);
    case TrackTarget::colliderPosition:
      return PropertyForm::tr("Position of %1").arg(object);
    case TrackTarget::colliderRotation:
      return PropertyForm::tr("Rotation of %1").arg(object);
  }
  return {};
}

/// All that a track could drive in this scene.
std::vector<modeling::TargetName> targetsOf(const Scene& scene) {
  std::vector<modeling::TargetName> targets{{TrackTarget::gravityScale, ""},
                                            {TrackTarget::gravity, ""},
                                            {TrackTarget::stiffnessScale, ""},
                                            {TrackTarget::dampingScale, ""}};
  for (const modeling::SceneMaterial& material : scene.materials) {
    targets.push_back({TrackTarget::stiffnessScale, material.name});
    targets.push_back({TrackTarget::dampingScale, material.name});
  }
  for (const modeling::SceneCollider& collider : scene.environment.colliders) {
    targets.push_back({TrackTarget::colliderPosition, collider.name});
    targets.push_back({TrackTarget::colliderRotation, collider.name});
  }
  return targets;
}

/// Keys of another kind of value would mean nothing: they begin anew.
void setTarget(SceneTrack& track, const modeling::TargetName& target) {
  if (target.isVector() != track.target.isVector()) {
    for (modeling::SceneTrackKey& key : track.keys) {
      if (target.isVector()) {
        key.value = sim::Vec3(sim::Vec3::Zero());
      } else {
        key.value = 1.0;
      }
    }
  }
  track.target = target;
}

}  // namespace

void addTrackProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Track"));
  FieldRows track(form, "", trackOf);
  const RowLabel keyLabel = track.label("keys");
  std::vector<std::pair<QString, QVariant>> choices;
  for (const modeling::TargetName& target : targetsOf(form.session().document().scene()))
    choices.emplace_back(titleOf(target), QString::fromStdString(target.text()));
  form.addChoice(
      track.label("target"), choices,
      [](Scene& scene, const Item& item) -> QVariant {
        const SceneTrack* shown = trackOf(scene, item);
        return shown ? QVariant(QString::fromStdString(shown->target.text())) : QVariant();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        const auto target = modeling::TargetName::parse(data.toString().toStdString());
        SceneTrack* changed = trackOf(scene, item);
        if (changed && target) setTarget(*changed, *target);
      });
  track.addRest();
  if (form.items().size() > 1) return;
  form.beginSection(keyLabel.text);
  auto* keys = new KeyTable(&form);
  form.addWide(
      keys,
      [&form, keys](Scene& scene) {
        if (const SceneTrack* shown = trackOf(scene, form.current())) keys->show(*shown);
      },
      keyLabel);
  QObject::connect(keys, &KeyTable::edited, &form,
                   [&form, keyLabel](const std::vector<modeling::SceneTrackKey>& changed, bool finished) {
                     form.apply(
                         keyLabel.text,
                         [&](Scene& scene, const Item& item) {
                           if (SceneTrack* edited = trackOf(scene, item)) edited->keys = changed;
                         },
                         finished);
                   });
}

}  // namespace ui
