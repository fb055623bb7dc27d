#include <QLabel>
#include <QTableWidget>

#include "ui/document/scene_edits.h"
#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/key_table.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"

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
  Fieldset<SceneTrack> fields(form, "", trackOf);
  std::vector<std::pair<QString, QVariant>> choices;
  for (const modeling::TargetName& target : targetsOf(form.session().document().scene()))
    choices.emplace_back(titleOf(target), QString::fromStdString(target.text()));
  form.addChoice(
      fields.labelOf(&SceneTrack::target, PropertyForm::tr("Drives")), choices,
      [](Scene& scene, const Item& item) -> QVariant {
        const SceneTrack* track = trackOf(scene, item);
        return track ? QVariant(QString::fromStdString(track->target.text())) : QVariant();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        const auto target = modeling::TargetName::parse(data.toString().toStdString());
        SceneTrack* track = trackOf(scene, item);
        if (track && target) setTarget(*track, *target);
      });
  fields.choice(&SceneTrack::interpolation, PropertyForm::tr("Between keys"),
                {PropertyForm::tr("Step"), PropertyForm::tr("Linear"), PropertyForm::tr("Smooth")});
  if (form.items().size() > 1) return;
  form.beginSection(PropertyForm::tr("Keys"));
  auto* keys = new KeyTable(&form);
  form.addWide(
      keys,
      [&form, keys](Scene& scene) {
        if (const SceneTrack* track = trackOf(scene, form.current())) keys->show(*track);
      },
      ".keys");
  QObject::connect(keys, &KeyTable::edited, &form,
                   [&form](const std::vector<modeling::SceneTrackKey>& changed, bool finished) {
                     form.apply(
                         PropertyForm::tr("Keys"),
                         [&](Scene& scene, const Item& item) {
                           if (SceneTrack* track = trackOf(scene, item)) track->keys = changed;
                         },
                         finished);
                   });
}

}  // namespace ui
