#include "ui/document/scene_edits.h"
#include "ui/document/track_titles.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/key_table.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneTrack;

SceneTrack* trackOf(Scene& scene, const Item& item) {
  return item.index < scene.tracks.size() ? &scene.tracks[item.index] : nullptr;
}

}  // namespace

void addTrackProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Track"));
  FieldRows track(form, "", trackOf);
  const RowLabel keyLabel = track.label("keys");
  std::vector<std::pair<QString, QVariant>> choices;
  for (const modeling::TargetName& target : modeling::targetsOf(form.session().document().scene()))
    choices.emplace_back(titleOf(target), QString::fromStdString(target.text()));
  form.addChoice(
      track.label("target"), choices,
      [](Scene& scene, const Item& item) -> QVariant {
        const SceneTrack* shown = trackOf(scene, item);
        return shown ? QVariant(QString::fromStdString(shown->target.text())) : QVariant();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        const auto target = modeling::TargetName::parse(data.toString().toStdString());
        if (trackOf(scene, item) && target) setTarget(scene, item.index, *target);
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
