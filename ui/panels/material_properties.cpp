#include <QLabel>

#include "modeling/scene/resources.h"
#include "ui/document/scene_edits.h"
#include "ui/panels/cell_drawing.h"
#include "ui/panels/fieldset.h"
#include "ui/panels/item_icons.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/sample_preview.h"
#include "ui/panels/section.h"

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

void addSubstance(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Substance"));
  Fieldset<Material> fields(form, "", valuesOf);
  NumberField* stiffness =
      fields.number(&Material::youngsModulus, PropertyForm::tr("Stiffness"), Dimension::pressure, 1e7, true);
  stiffness->setToolTip(PropertyForm::tr("Young's modulus: porcelain 70 GPa, rubber 1.5 MPa, jelly 4 kPa."));
  fields.number(&Material::density, PropertyForm::tr("Density"), Dimension::density, 0.1);
  fields.number(&Material::lossFactor, PropertyForm::tr("Loss factor"), Dimension::number, 0.02);
}

void addBreaking(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Breaking"));
  form.addChoice(
      {PropertyForm::tr("Breaks at"),
       PropertyForm::tr("What decides when a bond breaks; one measure at a time."), ".threshold"},
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
  const Material& shown = form.session().document().scene().materials[form.current().index].values;
  const Breaking breaking = breakingOf(shown);
  const QString none = PropertyForm::tr("none");
  Fieldset<Material> fields(form, "", valuesOf);
  Fieldset<modeling::ThresholdSpec> threshold(form, ".threshold", [](Scene& scene, const Item& item) {
    Material* material = valuesOf(scene, item);
    return material ? &material->threshold : nullptr;
  });
  if (breaking == Breaking::strain)
    threshold.number(&modeling::ThresholdSpec::mean, PropertyForm::tr("Strain"), Dimension::share, 0.005,
                     none, true);
  if (breaking == Breaking::strength)
    fields.number(&Material::strength, PropertyForm::tr("Strength"), Dimension::pressure, 1e6, none, true);
  if (breaking == Breaking::toughness)
    fields.number(&Material::fractureToughness, PropertyForm::tr("Toughness"), Dimension::toughness, 1e7,
                  none, true);
  if (breaking != Breaking::never)
    threshold.number(&modeling::ThresholdSpec::spread, PropertyForm::tr("Spread"), Dimension::share, 0.02);
}

void addPlastic(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Staying Bent"));
  auto* flows = new CheckField(PropertyForm::tr("Flows beyond a strain"), &form);
  flows->setObjectName(QStringLiteral("plastic"));
  form.addRow({{}, PropertyForm::tr("Plastic flow: what is bent far enough stays bent."), ".plastic"}, flows,
              [&form, flows](Scene& scene) {
                const Material* material = valuesOf(scene, form.current());
                flows->setChecked(material && material->plastic);
              });
  QObject::connect(flows, &QAbstractButton::clicked, &form, [&form](bool checked) {
    form.apply(PropertyForm::tr("Plastic Flow"), [checked](Scene& scene, const Item& item) {
      Material* material = valuesOf(scene, item);
      if (!material || material->plastic.has_value() == checked) return;
      material->plastic.reset();
      if (checked) material->plastic = modeling::Plastic{0.01, 100.0};
    });
  });
  if (!form.session().document().scene().materials[form.current().index].values.plastic) return;
  Fieldset<modeling::Plastic> fields(form, ".plastic",
                                     [](Scene& scene, const Item& item) -> modeling::Plastic* {
                                       Material* material = valuesOf(scene, item);
                                       return material && material->plastic ? &*material->plastic : nullptr;
                                     });
  fields.number(&modeling::Plastic::yieldStrain, PropertyForm::tr("Yields at"), Dimension::share, 0.001,
                true);
  fields.number(&modeling::Plastic::rate, PropertyForm::tr("Rate"), Dimension::rate, 1.0, true);
}

void addPattern(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Bonds of a Cell"));
  Fieldset<Material> fields(form, "", valuesOf);
  fields.choice(
      &Material::pattern, PropertyForm::tr("Pattern"),
      {PropertyForm::tr("Full: rigid, alike all ways"), PropertyForm::tr("Edges and body diagonals"),
       PropertyForm::tr("Edges and one diagonal a face"), PropertyForm::tr("Edges and face diagonals")});
  auto* drawing = new CellDrawing(&form);
  drawing->setToolTip(PropertyForm::tr("Edges grey, diagonals of faces blue, of the body yellow"));
  form.addWide(drawing, [&form, drawing](Scene& scene) {
    if (const Material* material = valuesOf(scene, form.current())) drawing->setPattern(material->pattern);
  });
}

void addLook(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Look"));
  Fieldset<modeling::Look> fields(form, ".look", [](Scene& scene, const Item& item) {
    Material* material = valuesOf(scene, item);
    return material ? &material->look : nullptr;
  });
  fields.colour(&modeling::Look::outside, PropertyForm::tr("Outside"));
  fields.colour(&modeling::Look::inside, PropertyForm::tr("Where broken"));
  fields.number(&modeling::Look::glaze, PropertyForm::tr("Glaze"), Dimension::number, 0.05);
  fields.choice(&modeling::Look::finish, PropertyForm::tr("In pictures"),
                {PropertyForm::tr("Glazed"), PropertyForm::tr("Matte"), PropertyForm::tr("Glass")});
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
    use->setToolTip(QString::fromStdString(material.values.source));
  });
}

}  // namespace

void addMaterialProperties(PropertyForm& form) {
  addPreset(form);
  addUse(form);
  addSample(form);
  addSubstance(form);
  addBreaking(form);
  addPlastic(form);
  addPattern(form);
  addLook(form);
}

}  // namespace ui
