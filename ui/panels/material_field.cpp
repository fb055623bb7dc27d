#include "ui/panels/material_field.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include "modeling/scene/resources.h"
#include "ui/document/scene_edits.h"
#include "ui/panels/item_icons.h"
#include "ui/panels/plain_fields.h"
#include "ui/theme/theme.h"

namespace ui {

MaterialField::MaterialField(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  choice_ = new ChoiceField(this);
  choice_->setObjectName(QStringLiteral("material-choice"));
  row->addWidget(choice_, 1);
  open_ = new QToolButton(this);
  open_->setIcon(Theme::icon(QStringLiteral("material")));
  open_->setToolTip(tr("Show the properties of this material"));
  row->addWidget(open_);
  add_ = new QToolButton(this);
  add_->setIcon(Theme::icon(QStringLiteral("add")));
  add_->setToolTip(tr("New material from a preset"));
  add_->setObjectName(QStringLiteral("new-material"));
  row->addWidget(add_);
  connect(choice_, &ChoiceField::edited, this,
          [this](const QVariant& name) { emit chosen(name.toString()); });
  connect(open_, &QToolButton::clicked, this, &MaterialField::openWanted);
  connect(add_, &QToolButton::clicked, this, &MaterialField::openPresets);
}

void MaterialField::show(const modeling::Scene& scene, const QString& chosen) {
  choice_->clear();
  for (const modeling::SceneMaterial& material : scene.materials) {
    const QString name = QString::fromStdString(material.name);
    choice_->addItem(swatchOf(material.values.look), name, name);
  }
  choice_->setValue(chosen.isEmpty() ? QVariant() : QVariant(chosen));
  open_->setEnabled(!chosen.isEmpty());
}

void MaterialField::openPresets() {
  QMenu menu(this);
  for (const std::string& name : modeling::presetNames()) {
    const sim::Result<modeling::Material> preset = modeling::presetMaterial(name);
    if (!preset) continue;
    const QString text = QString::fromStdString(name);
    menu.addAction(swatchOf(preset->look), text, this, [this, text] { emit newWanted(text); });
  }
  menu.exec(add_->mapToGlobal(QPoint(0, add_->height())));
}

std::string addMaterial(modeling::Scene& scene, const std::string& preset) {
  modeling::SceneMaterial material;
  material.name = uniqueName(preset.empty() ? "material" : preset, namesOf(scene, ItemKind::material));
  if (sim::Result<modeling::Material> values = modeling::presetMaterial(preset)) {
    material.preset = preset;
    material.values = std::move(values).value();
  }
  material.values.name = material.name;
  scene.materials.push_back(material);
  return material.name;
}

}  // namespace ui
