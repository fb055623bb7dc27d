#include "ui/document/scene_edits.h"
#include "ui/panels/box_list_field.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/material_field.h"

namespace ui {
namespace {

using modeling::Part;
using modeling::Scene;

Part* partOf(Scene& scene, const Item& item) {
  return item.index < scene.parts.size() ? &scene.parts[item.index] : nullptr;
}

void addMaterialRow(PropertyForm& form, const RowLabel& label) {
  auto* field = new MaterialField(&form);
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

void addHold(PropertyForm& form, const RowLabel& label) {
  form.beginSection(label.text);
  auto* boxes = new BoxListField(&form);
  form.addWide(
      boxes,
      [&form, boxes](Scene& scene) {
        if (const Part* part = partOf(scene, form.current())) boxes->show(*part);
      },
      label);
  QObject::connect(boxes, &BoxListField::edited, &form,
                   [&form, label](const std::vector<modeling::Box>& hold, bool finished) {
                     form.apply(
                         label.text,
                         [&](Scene& scene, const Item& item) {
                           if (Part* part = partOf(scene, item)) part->hold = hold;
                         },
                         finished);
                   });
}

}  // namespace

void addPartProperties(PropertyForm& form) {
  FieldRows part(form, "", partOf);
  part.leaveOut("name");
  addMaterialRow(form, part.label("material"));
  part.add("worldFromPart");
  addShapeProperties(form);
  const RowLabel hold = part.label("hold");
  form.beginSection(PropertyForm::tr("Motion at the Start"));
  part.addRest();
  addHold(form, hold);
}

}  // namespace ui
