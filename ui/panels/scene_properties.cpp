#include "modeling/scene/scene_ranges.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"

namespace ui {
namespace {

using modeling::Scene;
using MaybeNumber = std::optional<double>;

/// A step is given as a time or by a tolerance, or is automatic: two rows, each of which takes the other
/// back.
void addStep(PropertyForm& form, const RowLabel& label, const NumberFormat& time) {
  form.addNumber(
      label, time, [](Scene& scene, const Item&) { return scene.solver.step.seconds; },
      [](Scene& scene, const Item&, const MaybeNumber& value) {
        scene.solver.step.seconds = value;
        if (value) scene.solver.step.tolerance.reset();
      },
      std::nullopt);
  NumberFormat share;
  share.least = modeling::kToleranceRule.range.least;
  share.most = modeling::kToleranceRule.range.most;
  share.step = 1e-4;
  share.logarithmic = true;
  share.autoText = PropertyForm::tr("none");
  form.addNumber(
      {PropertyForm::tr("Tolerance"),
       PropertyForm::tr("Error of strain, relative to the largest there was: the automatic step is "
                        "shortened to keep to it."),
       label.path + ".tolerance"},
      share, [](Scene& scene, const Item&) { return scene.solver.step.tolerance; },
      [](Scene& scene, const Item&, const MaybeNumber& value) {
        scene.solver.step.tolerance = value;
        if (value) scene.solver.step.seconds.reset();
      },
      std::nullopt);
}

void addSolver(PropertyForm& form, const RowLabel& label) {
  form.beginSection(label.text);
  FieldRows solver(form, label.path, [](Scene& scene, const Item&) { return &scene.solver; });
  solver.add("method");
  addStep(form, solver.label("step"), solver.format("step"));
  solver.addRest();
}

void addOutput(PropertyForm& form, const RowLabel& label) {
  form.beginSection(label.text);
  FieldRows output(form, label.path, [](Scene& scene, const Item&) { return &scene.output; });
  output.add("duration");
  output.addRest();
}

void addView(PropertyForm& form, const RowLabel& label) {
  FieldRows view(form, label.path, [](Scene& scene, const Item&) { return &scene.view; });
  view.foldSections();
  view.addRest();
}

}  // namespace

void addSceneProperties(PropertyForm& form) {
  FieldRows scene(form, "", [](Scene& shown, const Item&) { return &shown; });
  scene.leaveOut("name");
  addOutput(form, scene.label("output"));
  scene.add("environment");
  addSolver(form, scene.label("solver"));
  addView(form, scene.label("view"));
  scene.addRest();
}

}  // namespace ui
