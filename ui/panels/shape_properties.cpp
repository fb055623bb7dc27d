#include <QLabel>

#include "ui/kinds/part_kinds.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"

namespace ui {
namespace {

using modeling::Scene;

template <class Shape>
Shape* shapeOf(Scene& scene, const Item& item) {
  return item.index < scene.parts.size() ? std::get_if<Shape>(&scene.parts[item.index].shape) : nullptr;
}

/// How many cells there are in one direction.
void addCount(PropertyForm& form, std::size_t axis, RowLabel label, NumberFormat format,
              const std::function<modeling::Resolution*(Scene&, const Item&)>& place) {
  format.whole = true;
  format.step = 1.0;
  label.path.append("[").append(std::to_string(axis)).append("]");
  form.addNumber(
      label, format,
      [place, axis](Scene& scene, const Item& item) -> std::optional<double> {
        modeling::Resolution* resolution = place(scene, item);
        if (!resolution || !resolution->counts[axis]) return std::nullopt;
        return *resolution->counts[axis];
      },
      [place, axis](Scene& scene, const Item& item, const std::optional<double>& value) {
        modeling::Resolution* resolution = place(scene, item);
        if (!resolution) return;
        resolution->counts[axis].reset();
        if (value) resolution->counts[axis] = static_cast<int>(*value);
      },
      std::nullopt);
}

/// What the lattice came to: of the scene as built last.
void addLatticeReport(PropertyForm& form) {
  auto* report = new QLabel(&form);
  report->setObjectName(QStringLiteral("lattice-report"));
  report->setForegroundRole(QPalette::PlaceholderText);
  report->setWordWrap(true);
  report->setToolTip(
      PropertyForm::tr("Skew is 1 for a cube and 0 for a flat cell; stretch is the longest over the "
                       "shortest edge. Narrow cells make the step short."));
  form.addWide(report, [&form, report](Scene& scene) {
    const Preview& preview = *form.session().preview();
    const std::string name = scene.parts[form.current().index].name;
    report->clear();
    if (!preview.built) return;
    for (const modeling::PartReport& part : preview.built->parts) {
      if (part.name != name) continue;
      report->setText(PropertyForm::tr("%L1 nodes; worst cell: skew %2, stretch %3")
                          .arg(part.nodes)
                          .arg(part.quality.minScaledJacobian, 0, 'f', 2)
                          .arg(part.quality.maxAspect, 0, 'f', 1));
    }
  });
}

/// The rows that follow a shape's own.
template <class Shape>
void addResolution(PropertyForm& form, const RowLabel& label, const Shape& shown) {
  const auto place = [](Scene& scene, const Item& item) -> modeling::Resolution* {
    Shape* shape = shapeOf<Shape>(scene, item);
    return shape ? &shape->resolution : nullptr;
  };
  form.beginSection(label.text);
  FieldRows resolution(form, label.path, place);
  resolution.add("cellSize");
  RowLabel counts = resolution.label("counts");
  const std::array<QString, 3> axes = kindOf(shown).axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts.text = axes[axis];
    addCount(form, axis, counts, resolution.format("counts"), place);
  }
  resolution.addRest();
  addLatticeReport(form);
}

/// Where something is edited that has no field.
void addHint(PropertyForm& form, const QString& text, const RowLabel& label) {
  auto* hint = new QLabel(text, &form);
  hint->setWordWrap(true);
  hint->setForegroundRole(QPalette::PlaceholderText);
  form.addWide(hint, {}, label);
}

/// The rows of a shape: its plain values and its cells. A kind with more has a function of its own.
template <class Shape>
void addShape(PropertyForm& form, const Shape& shape) {
  FieldRows rows(form, "", shapeOf<Shape>);
  const RowLabel resolution = rows.label("resolution");
  rows.addRest();
  addResolution(form, resolution, shape);
}

void addShape(PropertyForm& form, const modeling::BezierPatchShape& shape) {
  using Shape = modeling::BezierPatchShape;
  FieldRows patch(form, "", shapeOf<Shape>);
  const RowLabel net = patch.label("net");
  const RowLabel resolution = patch.label("resolution");
  patch.addRest();
  addHint(form, PropertyForm::tr("Drag its control points in the viewport."), net);
  addResolution(form, resolution, shape);
}

void addShape(PropertyForm& form, const modeling::RevolutionShape& shape) {
  using Shape = modeling::RevolutionShape;
  FieldRows body(form, "", shapeOf<Shape>);
  const RowLabel outside = body.label("outside");
  const RowLabel resolution = body.label("resolution");
  body.add("turnAngle");
  body.add("startAngle");
  body.addRest();
  addHint(form, PropertyForm::tr("Draw its two profiles in the profile editor."), outside);
  addResolution(form, resolution, shape);
}

void addShape(PropertyForm& form, const modeling::CurvedCylinderShape& shape) {
  using Shape = modeling::CurvedCylinderShape;
  FieldRows sweep(form, "", shapeOf<Shape>);
  const RowLabel curve = sweep.label("curve");
  const RowLabel resolution = sweep.label("resolution");
  for (const char* first : {"section", "halfWidth", "halfDepth", "wallThickness", "startAngle", "endAngle"})
    sweep.add(first);
  sweep.addRest();
  addHint(form, PropertyForm::tr("Drag its curve and its widths in the viewport."), curve);
  addResolution(form, resolution, shape);
}

modeling::BondType* bondTypeOf(Scene& scene, const Item& item, std::size_t type) {
  auto* shape = shapeOf<modeling::NetworkShape>(scene, item);
  return shape && type < shape->bondTypes.size() ? &shape->bondTypes[type].constants : nullptr;
}

void addShape(PropertyForm& form, const modeling::NetworkShape& shape) {
  FieldRows network(form, "", shapeOf<modeling::NetworkShape>);
  const RowLabel types = network.label("bondTypes");
  network.addRest();
  for (std::size_t type = 0; type < shape.bondTypes.size(); ++type) {
    const std::string& name = shape.bondTypes[type].type;
    form.beginSection(PropertyForm::tr("Bonds of Type %1").arg(QString::fromStdString(name)));
    FieldRows bonds(form, types.path + "." + name,
                    [type](Scene& scene, const Item& item) { return bondTypeOf(scene, item, type); });
    bonds.addRest();
  }
}

void addShape(PropertyForm& form, const modeling::MeshShape&) {
  FieldRows mesh(form, "", shapeOf<modeling::MeshShape>);
  mesh.addRest();
  addLatticeReport(form);
}

}  // namespace

void addShapeProperties(PropertyForm& form) {
  const Scene& scene = form.session().document().scene();
  const modeling::PartShape& shown = scene.parts[form.current().index].shape;
  for (const Item& item : form.items()) {
    // Different shapes have no fields in common.
    if (scene.parts[item.index].shape.index() != shown.index()) return;
  }
  form.beginSection(PropertyForm::tr("Shape"));
  std::visit([&form](const auto& shape) { addShape(form, shape); }, shown);
}

}  // namespace ui
