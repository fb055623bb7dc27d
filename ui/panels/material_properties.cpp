#include <QLabel>

#include "modeling/scene/resources.h"
#include "ui/document/scene_edits.h"
#include "ui/panels/cell_drawing.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_icons.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/sample_preview.h"

namespace ui {
namespace {

using modeling::Material;
using modeling::Scene;

Material* valuesOf(Scene& scene, const Item& item) {
  return item.index < scene.materials.size() ? &scene.materials[item.index].values : nullptr;
}

/// What decides when it breaks.
enum class Breaking { never, strain, strength, toughness };

Breaking breakingOf(const Material& material) {
  if (material.threshold.mean) return Breaking::strain;
  if (material.strength) return Breaking::strength;
  return material.fractureToughness ? Breaking::toughness : Breaking::never;
}

/// At the cell size at which dishes are made, so that a change of the measure hardly changes when it breaks.
constexpr double kUsualCell = 0.5;

void setBreaking(Material& material, Breaking breaking) {
  if (breakingOf(material) == breaking) return;
  const double strain = modeling::breakStrain(material, kUsualCell);
  const double usual = std::isfinite(strain) ? strain : 0.05;
  material.threshold.mean.reset();
  material.strength.reset();
  material.fractureToughness.reset();
  if (breaking == Breaking::strain) material.threshold.mean = usual;
  if (breaking == Breaking::strength) material.strength = usual * material.youngsModulus;
  if (breaking != Breaking::toughness) return;
  // breakStrain() is proportional to it.
  material.fractureToughness = 1.0;
  *material.fractureToughness = usual / modeling::breakStrain(material, kUsualCell);
}

void addPreset(PropertyForm& form) {
  std::vector<std::pair<QString, QVariant>> presets{{PropertyForm::tr("None"), QString()}};
  for (const std::string& name : modeling::presetNames())
    presets.emplace_back(QString::fromStdString(name), QString::fromStdString(name));
  ChoiceField* field = form.addChoice(
      {PropertyForm::tr("Preset"), PropertyForm::tr("Takes all values of a known material."), ".preset"},
      presets,
      [](Scene& scene, const Item& item) -> QVariant {
        return item.index < scene.materials.size()
                   ? QString::fromStdString(scene.materials[item.index].preset)
                   : QString();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        if (item.index >= scene.materials.size()) return;
        modeling::SceneMaterial& material = scene.materials[item.index];
        material.preset = data.toString().toStdString();
        if (sim::Result<Material> values = modeling::presetMaterial(material.preset)) {
          material.values = std::move(values).value();
          material.values.name = material.name;
        }
      });
  for (int i = 1; i < field->count(); ++i) {
    const sim::Result<Material> preset =
        modeling::presetMaterial(field->itemData(i).toString().toStdString());
    if (preset) field->setItemIcon(i, swatchOf(preset->look));
  }
}

void addBreakingChoice(PropertyForm& form, RowLabel label) {
  label.text = PropertyForm::tr("Breaks at");
  label.help = PropertyForm::tr("What decides when a bond breaks; one measure at a time.");
  form.addChoice(
      label,
      {{PropertyForm::tr("Never"), static_cast<int>(Breaking::never)},
       {PropertyForm::tr("A strain"), static_cast<int>(Breaking::strain)},
       {PropertyForm::tr("Its strength"), static_cast<int>(Breaking::strength)},
       {PropertyForm::tr("Its toughness"), static_cast<int>(Breaking::toughness)}},
      [](Scene& scene, const Item& item) -> QVariant {
        const Material* material = valuesOf(scene, item);
        return material ? QVariant(static_cast<int>(breakingOf(*material))) : QVariant();
      },
      [](Scene& scene, const Item& item, const QVariant& data) {
        if (Material* material = valuesOf(scene, item))
          setBreaking(*material, static_cast<Breaking>(data.toInt()));
      });
}

/// Of the measures only the one that decides is shown.
void addBreaking(PropertyForm& form, FieldRows& material, const RowLabel& label) {
  form.beginSection(label.text);
  addBreakingChoice(form, label);
  FieldRows threshold(form, label.path, [](Scene& scene, const Item& item) -> modeling::ThresholdSpec* {
    Material* values = valuesOf(scene, item);
    return values && breakingOf(*values) != Breaking::never ? &values->threshold : nullptr;
  });
  threshold.add("mean");
  material.add("strength");
  material.add("fractureToughness");
  threshold.addRest();
}

/// Flow that a person sees, where it has just been wanted.
void beginPlastic(Scene& scene, const Item& item) {
  if (Material* material = valuesOf(scene, item)) material->plastic = modeling::Plastic{0.01, 100.0};
}

void addPattern(PropertyForm& form, FieldRows& material) {
  form.beginSection(PropertyForm::tr("Bonds of a Cell"));
  material.add("pattern");
  auto* drawing = new CellDrawing(&form);
  drawing->setToolTip(PropertyForm::tr("Edges grey, diagonals of faces blue, of the body yellow"));
  form.addWide(drawing, [&form, drawing](Scene& scene) {
    if (const Material* shown = valuesOf(scene, form.current())) drawing->setPattern(shown->pattern);
  });
}

void addSample(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Sample"));
  auto* sample = new SamplePreview(&form);
  form.addWide(sample, [&form, sample](Scene& scene) {
    if (const Material* material = valuesOf(scene, form.current())) sample->setMaterial(*material);
  });
}

void addUse(PropertyForm& form) {
  auto* use = new QLabel(&form);
  use->setWordWrap(true);
  use->setForegroundRole(QPalette::PlaceholderText);
  form.addWide(use, [&form, use](Scene& scene) {
    if (form.current().index >= scene.materials.size()) return;
    const modeling::SceneMaterial& material = scene.materials[form.current().index];
    QStringList parts;
    for (const std::string& name : usersOf(scene, material.name)) parts << QString::fromStdString(name);
    use->setText(parts.isEmpty() ? PropertyForm::tr("Nothing is made of it yet.")
                                 : PropertyForm::tr("Used by %1.").arg(parts.join(QStringLiteral(", "))));
  });
}

}  // namespace

void addMaterialProperties(PropertyForm& form) {
  FieldRows material(form, "", valuesOf);
  const RowLabel breaking = material.label("threshold");
  for (const char* later : {"strength", "fractureToughness", "plastic", "pattern", "look"})
    material.leaveOut(later);
  addPreset(form);
  addUse(form);
  addSample(form);
  form.beginSection(PropertyForm::tr("Substance"));
  material.addRest();
  addBreaking(form, material, breaking);
  material.add("plastic", beginPlastic);
  addPattern(form, material);
  material.add("look");
}

}  // namespace ui
