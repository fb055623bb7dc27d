#include "ui/panels/properties.h"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include "ui/document/scene_edits.h"
#include "ui/kinds/part_kinds.h"
#include "ui/panels/item_icons.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/property_form.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

QString kindOfItem(const modeling::Scene& scene, const Item& item) {
  switch (item.kind) {
    case ItemKind::scene:
      return Properties::tr("Scene");
    case ItemKind::part:
      return kindOf(scene.parts[item.index].shape).title;
    case ItemKind::gluing:
      return Properties::tr("Glue");
    case ItemKind::collider:
      return Properties::tr("Collider: never moves but by a track");
    case ItemKind::material:
      return Properties::tr("Material");
    case ItemKind::track:
      return Properties::tr("Track");
  }
  return {};
}

void fill(PropertyForm& form) {
  switch (form.current().kind) {
    case ItemKind::scene:
      return addSceneProperties(form);
    case ItemKind::part:
      return addPartProperties(form);
    case ItemKind::gluing:
      return addGluingProperties(form);
    case ItemKind::collider:
      return addColliderProperties(form);
    case ItemKind::material:
      return addMaterialProperties(form);
    case ItemKind::track:
      return addTrackProperties(form);
  }
}

}  // namespace

Properties::Properties(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("properties"));
  setMinimumWidth(280);
  icon_ = new QLabel(this);
  icon_->setFixedSize(20, 20);
  name_ = new TextField(this);
  name_->setObjectName(QStringLiteral("item-name"));
  about_ = new QLabel(this);
  about_->setForegroundRole(QPalette::PlaceholderText);
  about_->setWordWrap(true);
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setFocusPolicy(Qt::NoFocus);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(10, 8, 10, 0);
  head->addWidget(icon_);
  head->addWidget(name_, 1);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(10, 2, 10, 2);
  line->addWidget(about_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(head);
  column->addLayout(line);
  column->addWidget(area_, 1);
  connect(name_, &TextField::edited, this, &Properties::takeName);
  connect(&session_.selection(), &Selection::changed, this, &Properties::showSelection);
  connect(&session_.document(), &Document::sceneChanged, this, &Properties::showSelection);
  connect(&session_.document(), &Document::replaced, this, [this] {
    if (form_) form_->forsake();
    name_->setModified(false);
    items_.clear();
  });
  connect(&session_.document(), &Document::statusChanged, this, &Properties::showHead);
  connect(&session_.document(), &Document::rehearsed, this, &Properties::showScene);
  connect(&session_, &Session::previewChanged, this, &Properties::showScene);
  connect(&Theme::instance(), &Theme::changed, this, &Properties::showScene);
  showSelection();
}

std::vector<Item> Properties::shownItems() const {
  const Item current = session_.selection().current();
  std::vector<Item> items;
  for (const Item& item : session_.selection().items()) {
    if (item.kind == current.kind) items.push_back(item);
  }
  if (items.empty()) items.push_back({});
  std::erase_if(
      items, [&](const Item& item) { return item.index >= countOf(session_.document().scene(), item.kind); });
  if (items.empty()) items.push_back({});
  return items;
}

std::vector<QString> Properties::namesIn(const std::vector<Item>& items) const {
  std::vector<QString> names;
  for (const Item& item : items) names.push_back(nameOf(session_.document().scene(), item));
  return names;
}

void Properties::showSelection() {
  std::vector<Item> items = shownItems();
  std::string structure = structureOf(session_.document().scene(), items);
  if (form_ && items == items_ && structure == structure_) {
    names_ = namesIn(items_);
    return showScene();
  }
  // A click elsewhere takes what is typed; a scene that became another under the hand does not.
  if (form_ && namesIn(items_) != names_) {
    form_->forsake();
    name_->setModified(false);
  }
  const bool sameKind = !items_.empty() && items_.back().kind == items.back().kind;
  const int scrolled = sameKind ? area_->verticalScrollBar()->value() : 0;
  items_ = std::move(items);
  structure_ = std::move(structure);
  names_ = namesIn(items_);
  // One of its fields may be what asked for the change.
  if (QWidget* old = area_->takeWidget()) {
    old->hide();
    old->setParent(nullptr);
    old->deleteLater();
  }
  form_ = new PropertyForm(session_, items_);
  fill(*form_);
  area_->setWidget(form_);
  showScene();
  form_->adjustSize();
  area_->verticalScrollBar()->setValue(scrolled);
}

void Properties::showHead() {
  const modeling::Scene& scene = session_.document().scene();
  if (items_.empty()) return;
  const Item& item = items_.back();
  if (item.index >= countOf(scene, item.kind)) return;
  icon_->setPixmap(iconOf(scene, item).pixmap(QSize(20, 20), devicePixelRatioF()));
  const bool several = items_.size() > 1;
  name_->setReadOnly(several || !hasName(item.kind));
  name_->setPlaceholderText(session_.document().title());
  name_->setValue(several ? tr("%L1 selected").arg(items_.size()) : nameOf(scene, item));
  QString about = kindOfItem(scene, item);
  if (several) about = tr("Edits apply to all of them");
  if (item.kind == ItemKind::scene)
    about = scene.parts.empty() ? tr("Empty: add a part with Shift+A")
                                : tr("Select something to see its own properties");
  about_->setText(about);
}

void Properties::showScene() {
  if (!form_) return;
  showHead();
  form_->showScene();
  showProblem();
}

void Properties::showProblem() {
  const std::optional<sim::Problem>& problem = session_.preview()->problem;
  form_->showProblem(problem ? &*problem : nullptr);
}

void Properties::takeName(const QString& name) {
  if (items_.empty()) return;
  const Item item = items_.back();
  session_.document().edit(
      tr("Rename"), [&](modeling::Scene& scene) { rename(scene, item, name.trimmed().toStdString()); });
  name_->setModified(false);
  showHead();
}

std::string structureOf(const modeling::Scene& scene, const std::vector<Item>& items) {
  const Item& item = items.back();
  std::string structure;
  const auto add = [&](auto value) { structure += std::to_string(value) + ' '; };
  for (const Item& each : items) {
    if (each.kind == ItemKind::part) add(scene.parts[each.index].shape.index());
    if (each.kind == ItemKind::collider) add(scene.environment.colliders[each.index].form.index());
  }
  if (item.kind == ItemKind::part) {
    const modeling::PartShape& shape = scene.parts[item.index].shape;
    // Directions of cells are called otherwise.
    if (const auto* sweep = std::get_if<modeling::CurvedCylinderShape>(&shape))
      add(static_cast<int>(sweep->section));
    if (const auto* network = std::get_if<modeling::NetworkShape>(&shape)) {
      for (const modeling::NamedBondType& type : network->bondTypes) structure += type.type + ' ';
    }
  }
  if (item.kind == ItemKind::gluing) {
    for (const std::string& name : namesOf(scene, ItemKind::part)) structure += name + '\n';
  }
  if (item.kind == ItemKind::track) {
    for (const ItemKind kind : {ItemKind::material, ItemKind::collider})
      for (const std::string& name : namesOf(scene, kind)) structure += name + '\n';
  }
  return structure;
}

}  // namespace ui
