#include <QHBoxLayout>
#include <QLabel>

#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/rotation_rows.h"
#include "ui/panels/section.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneCollider;

void addStep(PropertyForm& form) {
  using modeling::Step;
  const auto place = [](Scene& scene, const Item&) { return &scene.solver.step; };
  NumberFormat format;
  format.dimension = Dimension::time;
  format.least = 0.0;
  format.leastExcluded = true;
  format.step = 1e-6;
  format.logarithmic = true;
  format.autoText = PropertyForm::tr("auto");
  form.addNumber(
      {PropertyForm::tr("Step"), PropertyForm::tr("Auto: as long as is stable."), ".solver.step"}, format,
      [place](Scene& scene, const Item& item) { return place(scene, item)->seconds; },
      [place](Scene& scene, const Item& item, const std::optional<double>& value) {
        place(scene, item)->seconds = value;
        if (value) place(scene, item)->tolerance.reset();
      },
      std::nullopt);
  NumberFormat share;
  share.least = 0.0;
  share.leastExcluded = true;
  share.step = 1e-4;
  share.logarithmic = true;
  share.autoText = PropertyForm::tr("none");
  form.addNumber(
      {PropertyForm::tr("Tolerance"),
       PropertyForm::tr("Error of strain, relative to the largest there was: the automatic step is "
                        "shortened to keep to it."),
       ".solver.step.tolerance"},
      share, [place](Scene& scene, const Item& item) { return place(scene, item)->tolerance; },
      [place](Scene& scene, const Item& item, const std::optional<double>& value) {
        place(scene, item)->tolerance = value;
        if (value) place(scene, item)->seconds.reset();
      },
      std::nullopt);
}

void addSeed(PropertyForm& form) {
  NumberFormat format;
  format.whole = true;
  format.least = 0.0;
  // Above this a double cannot tell whole numbers apart.
  format.most = 9007199254740992.0;
  format.step = 1.0;
  form.addNumber(
      {PropertyForm::tr("Seed"), PropertyForm::tr("Of the random thresholds: another one breaks otherwise."),
       ".solver.seed"},
      format,
      [](Scene& scene, const Item&) -> std::optional<double> {
        return static_cast<double>(scene.solver.seed);
      },
      [](Scene& scene, const Item&, const std::optional<double>& value) {
        if (value) scene.solver.seed = static_cast<std::uint64_t>(*value);
      },
      1.0);
}

void addSolver(PropertyForm& form) {
  using modeling::Solver;
  form.beginSection(PropertyForm::tr("Solver"));
  Fieldset<Solver> fields(form, ".solver", [](Scene& scene, const Item&) { return &scene.solver; });
  fields.choice(&Solver::method, PropertyForm::tr("Method"),
                {PropertyForm::tr("Forward Euler"), PropertyForm::tr("Symplectic Euler"),
                 PropertyForm::tr("Velocity Verlet"), PropertyForm::tr("Runge-Kutta 4"),
                 PropertyForm::tr("Implicit Euler"), PropertyForm::tr("Implicit midpoint")});
  fields.choice(&Solver::precision, PropertyForm::tr("Precision"),
                {PropertyForm::tr("Double"), PropertyForm::tr("Float")});
  addStep(form);
  fields.number(&Solver::safety, PropertyForm::tr("Safety"), Dimension::number, 0.05);
  addSeed(form);
}

void addContact(PropertyForm& form) {
  using modeling::Contact;
  form.beginSection(PropertyForm::tr("Contact"));
  Fieldset<Contact> fields(form, ".solver.contact",
                           [](Scene& scene, const Item&) { return &scene.solver.contact; });
  fields.check(&Contact::between, PropertyForm::tr("Between fragments"));
  fields.check(&Contact::self, PropertyForm::tr("Within a fragment"));
  fields.choice(&Contact::length, PropertyForm::tr("Natural length"),
                {PropertyForm::tr("The nearer's (safe)"), PropertyForm::tr("Sum (never breaks)")});
  fields.number(&Contact::stiffnessScale, PropertyForm::tr("Stiffness"), Dimension::number, 0.05);
  fields.number(&Contact::dampingRatio, PropertyForm::tr("Damping"), Dimension::number, 0.05);
  fields.number(&Contact::friction, PropertyForm::tr("Friction"), Dimension::number, 0.05);
}

void addSkip(PropertyForm& form) {
  using Skip = sim::SkipSettings;
  Section* section = form.beginSection(PropertyForm::tr("Leave Out What Is Not Needed"));
  section->setToolTip(PropertyForm::tr("Switched off, the same is computed in full, to compare."));
  Fieldset<Skip> fields(form, ".solver.skip", [](Scene& scene, const Item&) { return &scene.solver.skip; });
  fields.check(&Skip::sleep, PropertyForm::tr("Fragments at rest"));
  fields.check(&Skip::rigid, PropertyForm::tr("Deformation in free flight"));
  fields.check(&Skip::contactSearch, PropertyForm::tr("Contact search"));
  fields.check(&Skip::labelling, PropertyForm::tr("Labelling of fragments"));
  fields.check(&Skip::thresholds, PropertyForm::tr("Thresholds out of reach"));
  fields.check(&Skip::damping, PropertyForm::tr("Dampers of no strength"));
  fields.check(&Skip::ledger, PropertyForm::tr("Energy nobody reads"));
}

SceneCollider* colliderOf(Scene& scene, const Item& item) {
  auto& colliders = scene.environment.colliders;
  return item.index < colliders.size() ? &colliders[item.index] : nullptr;
}

template <class Form>
Form* formOf(Scene& scene, const Item& item) {
  SceneCollider* collider = colliderOf(scene, item);
  return collider ? std::get_if<Form>(&collider->form) : nullptr;
}

void addColliderForm(PropertyForm& form) {
  const auto& colliders = form.session().document().scene().environment.colliders;
  const std::size_t kind = colliders[form.current().index].form.index();
  for (const Item& item : form.items()) {
    if (colliders[item.index].form.index() != kind) return;
  }
  if (std::holds_alternative<modeling::BoxShape>(colliders[form.current().index].form)) {
    Fieldset<modeling::BoxShape> fields(form, "", formOf<modeling::BoxShape>);
    fields.vector(&modeling::BoxShape::halfSize, PropertyForm::tr("Half size, cm"), Dimension::length, 0.5);
  }
  if (std::holds_alternative<modeling::SphereShape>(colliders[form.current().index].form)) {
    Fieldset<modeling::SphereShape> fields(form, "", formOf<modeling::SphereShape>);
    fields.number(&modeling::SphereShape::radius, PropertyForm::tr("Radius"), Dimension::length, 0.2);
  }
  if (std::holds_alternative<modeling::CylinderShape>(colliders[form.current().index].form)) {
    Fieldset<modeling::CylinderShape> fields(form, "", formOf<modeling::CylinderShape>);
    fields.number(&modeling::CylinderShape::radius, PropertyForm::tr("Radius"), Dimension::length, 0.2);
    fields.number(&modeling::CylinderShape::halfHeight, PropertyForm::tr("Half height"), Dimension::length,
                  0.2);
  }
}

}  // namespace

void addSceneProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Recording"));
  Fieldset<modeling::Output> output(form, ".output", [](Scene& scene, const Item&) { return &scene.output; });
  output.number(&modeling::Output::duration, PropertyForm::tr("Duration"), Dimension::time, 0.1);
  output.number(&modeling::Output::fps, PropertyForm::tr("Frame rate"), Dimension::rate, 1.0);
  form.beginSection(PropertyForm::tr("Surroundings"));
  Fieldset<modeling::SceneEnvironment> environment(
      form, ".environment", [](Scene& scene, const Item&) { return &scene.environment; });
  environment.vector(&modeling::SceneEnvironment::gravity, PropertyForm::tr("Gravity, cm/s²"),
                     Dimension::acceleration, 20.0);
  addSolver(form);
  addContact(form);
  addSkip(form);
}

void addColliderProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Placement"));
  Fieldset<SceneCollider> fields(form, "", colliderOf);
  fields.vector(&SceneCollider::position, PropertyForm::tr("Position, cm"), Dimension::length, 0.5);
  addRotation(form, fields.labelOf(&SceneCollider::rotation, PropertyForm::tr("Rotation, °")),
              [](Scene& scene, const Item& item) {
                SceneCollider* collider = colliderOf(scene, item);
                return collider ? &collider->rotation : nullptr;
              });
  addColliderForm(form);
  form.beginSection(PropertyForm::tr("Touch"));
  fields.number(&SceneCollider::friction, PropertyForm::tr("Friction"), Dimension::number, 0.05);
  fields.number(&SceneCollider::dampingRatio, PropertyForm::tr("Damping"), Dimension::number, 0.05);
  fields.number(&SceneCollider::stiffness, PropertyForm::tr("Stiffness"), Dimension::stiffness, 1e5,
                PropertyForm::tr("the node's own"), true);
  fields.check(&SceneCollider::visible, PropertyForm::tr("Drawn"));
}

}  // namespace ui
