#include <QLabel>
#include <QTableWidget>

#include "ui/document/scene_edits.h"
#include "ui/document/track_titles.h"
#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/key_table.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"

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
  Fieldset<SceneTrack> fields(form, "", trackOf);
  std::vector<std::pair<QString, QVariant>> choices;
  for (const modeling::TargetName& target : modeling::targetsOf(form.session().document().scene()))
    choices.emplace_back(titleOf(target), QString::fromStdString(target.text()));
  form.addChoice(
      fields.labelOf(&SceneTrack::target, PropertyForm::tr("Drives")), choices,
      [](Scene& scene, const Item& item) -> QVariant {
        const SceneTrack* track = trackOf(scene, item);
        return track ? QVariant(QString::fromStdString(track->target.text())) : QVariant();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        const auto target = modeling::TargetName::parse(data.toString().toStdString());
        if (trackOf(scene, item) && target) setTarget(scene, item.index, *target);
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
