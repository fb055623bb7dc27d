#include <QLabel>
#include <QToolButton>

#include "modeling/scene/resources.h"
#include "ui/document/scene_edits.h"
#include "ui/panels/box_list_field.h"
#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/material_field.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/rotation_rows.h"
#include "ui/panels/section.h"

namespace ui {
namespace {

using modeling::Part;
using modeling::Scene;

Part* partOf(Scene& scene, const Item& item) {
  return item.index < scene.parts.size() ? &scene.parts[item.index] : nullptr;
}

void addPlacement(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Placement"));
  Fieldset<modeling::Placement> placement(form, ".worldFromPart", [](Scene& scene, const Item& item) {
    Part* part = partOf(scene, item);
    return part ? &part->worldFromPart : nullptr;
  });
  placement.vector(&modeling::Placement::position, PropertyForm::tr("Position, cm"), Dimension::length, 0.5);
  addRotation(form, placement.labelOf(&modeling::Placement::rotation, PropertyForm::tr("Rotation, °")),
              [](Scene& scene, const Item& item) {
                Part* part = partOf(scene, item);
                return part ? &part->worldFromPart.rotation : nullptr;
              });
  NumberFormat format;
  format.least = 0.0;
  format.leastExcluded = true;
  format.step = 0.05;
  form.addVector(
      placement.labelOf(&modeling::Placement::scale, PropertyForm::tr("Scale")), format,
      [](Scene& scene, const Item& item) {
        Part* part = partOf(scene, item);
        return part ? &part->worldFromPart.scale.factors : nullptr;
      },
      sim::Vec3::Ones());
}

void addMaterialRow(PropertyForm& form) {
  auto* field = new MaterialField(&form);
  Fieldset<Part> parts(form, "", partOf);
  const RowLabel label = parts.labelOf(&Part::material, PropertyForm::tr("Material"));
  form.addRow(label, field, [&form, field](Scene& scene) {
    const Part* shown = partOf(scene, form.current());
    if (!shown) return;
    bool same = true;
    for (const Item& item : form.items()) {
      const Part* part = partOf(scene, item);
      same &= part && part->material == shown->material;
    }
    field->show(scene, same ? QString::fromStdString(shown->material) : QString());
  });
  QObject::connect(field, &MaterialField::chosen, &form, [&form, label](const QString& name) {
    form.apply(label.text, [&](Scene& scene, const Item& item) {
      if (Part* part = partOf(scene, item)) part->material = name.toStdString();
    });
  });
  QObject::connect(field, &MaterialField::newWanted, &form, [&form](const QString& preset) {
    std::string name;
    form.apply(PropertyForm::tr("Material"), [&](Scene& scene, const Item& item) {
      if (name.empty()) name = addMaterial(scene, preset.toStdString());
      if (Part* part = partOf(scene, item)) part->material = name;
    });
  });
  QObject::connect(field, &MaterialField::openWanted, &form, [&form] {
    const Scene& scene = form.session().document().scene();
    const Item current = form.current();
    if (current.index >= scene.parts.size()) return;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      if (scene.materials[i].name == scene.parts[current.index].material)
        return form.session().selection().select({ItemKind::material, i});
    }
  });
}

}  // namespace

void addPartProperties(PropertyForm& form) {
  addMaterialRow(form);
  addPlacement(form);
  addShapeProperties(form);
  Fieldset<Part> parts(form, "", partOf);
  form.beginSection(PropertyForm::tr("Motion at the Start"));
  parts.vector(&Part::velocity, PropertyForm::tr("Velocity, cm/s"), Dimension::velocity, 10.0);
  parts.vector(&Part::angularVelocity, PropertyForm::tr("Turning, rad/s"), Dimension::angularVelocity, 0.5);
  form.beginSection(PropertyForm::tr("Held"));
  auto* boxes = new BoxListField(&form);
  boxes->setToolTip(parts.labelOf(&Part::hold, {}).help);
  form.addWide(
      boxes,
      [&form, boxes](Scene& scene) {
        if (const Part* part = partOf(scene, form.current())) boxes->show(*part);
      },
      ".hold");
  QObject::connect(boxes, &BoxListField::edited, &form,
                   [&form](const std::vector<modeling::Box>& hold, bool finished) {
                     form.apply(
                         PropertyForm::tr("Held"),
                         [&](Scene& scene, const Item& item) {
                           if (Part* part = partOf(scene, item)) part->hold = hold;
                         },
                         finished);
                   });
}

}  // namespace ui
