#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneCollider;

SceneCollider* colliderOf(Scene& scene, const Item& item) {
  return item.index < scene.environment.colliders.size() ? &scene.environment.colliders[item.index] : nullptr;
}

template <class Form>
Form* formOf(Scene& scene, const Item& item) {
  SceneCollider* collider = colliderOf(scene, item);
  return collider ? std::get_if<Form>(&collider->form) : nullptr;
}

/// The rows of the kind of collider, for colliders of one kind.
void addColliderForm(PropertyForm& form) {
  const auto& colliders = form.session().document().scene().environment.colliders;
  const modeling::ColliderForm& shown = colliders[form.current().index].form;
  for (const Item& item : form.items()) {
    // Different kinds have no fields in common.
    if (colliders[item.index].form.index() != shown.index()) return;
  }
  std::visit(
      [&form](const auto& kind) {
        using Kind = std::remove_cvref_t<decltype(kind)>;
        if (modeling::fieldsOf<Kind>().empty()) return;
        form.beginSection(PropertyForm::tr("Shape"));
        FieldRows rows(form, "", formOf<Kind>);
        rows.addRest();
      },
      shown);
}

}  // namespace

void addColliderProperties(PropertyForm& form) {
  FieldRows collider(form, "", colliderOf);
  collider.leaveOut("name");
  form.beginSection(PropertyForm::tr("Placement"));
  collider.add("position");
  collider.add("rotation");
  addColliderForm(form);
  form.beginSection(PropertyForm::tr("Touch"));
  collider.add("friction");
  collider.add("dampingRatio");
  collider.add("stiffness");
  form.beginSection(PropertyForm::tr("Presence"));
  collider.addRest();
}

}  // namespace ui
