#include <QLabel>

#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::Vec3;

template <class Shape>
Shape* shapeOf(Scene& scene, const Item& item) {
  return item.index < scene.parts.size() ? std::get_if<Shape>(&scene.parts[item.index].shape) : nullptr;
}

/// What u, v and w are called in a shape of this kind.
std::array<QString, 3> axesOf(const modeling::PartShape& shape) {
  if (std::holds_alternative<modeling::RevolutionShape>(shape))
    return {PropertyForm::tr("Around"), PropertyForm::tr("Along"), PropertyForm::tr("Through")};
  if (const auto* sweep = std::get_if<modeling::CurvedCylinderShape>(&shape)) {
    const bool flat = sweep->section == modeling::SweepSection::rectangle;
    return {PropertyForm::tr("Along"), flat ? PropertyForm::tr("Across") : PropertyForm::tr("Around"),
            flat ? PropertyForm::tr("Deep") : PropertyForm::tr("Through")};
  }
  if (std::holds_alternative<modeling::BezierPatchShape>(shape))
    return {PropertyForm::tr("Along u"), PropertyForm::tr("Along v"), PropertyForm::tr("Through")};
  return {PropertyForm::tr("Along x"), PropertyForm::tr("Along y"), PropertyForm::tr("Along z")};
}

void addCount(PropertyForm& form, std::size_t axis, const QString& name,
              const Fieldset<modeling::Resolution>::Place& place) {
  NumberFormat format;
  format.whole = true;
  format.least = 1.0;
  format.most = 1e6;
  format.step = 1.0;
  format.autoText = PropertyForm::tr("auto");
  const RowLabel label{
      name, PropertyForm::tr("Cells in this direction; auto: as many as make them nearest to the cell size."),
      ".resolution.counts[" + std::to_string(axis) + "]"};
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

template <class Shape>
void addResolution(PropertyForm& form) {
  const auto place = [](Scene& scene, const Item& item) -> modeling::Resolution* {
    Shape* shape = shapeOf<Shape>(scene, item);
    return shape ? &shape->resolution : nullptr;
  };
  form.beginSection(PropertyForm::tr("Cells"));
  Fieldset<modeling::Resolution> fields(form, ".resolution", place);
  fields.number(&modeling::Resolution::cellSize, PropertyForm::tr("Cell size"), Dimension::length, 0.05);
  const Scene& scene = form.session().document().scene();
  const std::array<QString, 3> axes = axesOf(scene.parts[form.current().index].shape);
  for (std::size_t axis = 0; axis < 3; ++axis) addCount(form, axis, axes[axis], place);
  addLatticeReport(form);
}

void addHint(PropertyForm& form, const QString& text) {
  auto* label = new QLabel(text, &form);
  label->setWordWrap(true);
  label->setForegroundRole(QPalette::PlaceholderText);
  form.addWide(label);
}

void addSlab(PropertyForm& form) {
  Fieldset<modeling::SlabShape> fields(form, "", shapeOf<modeling::SlabShape>);
  fields.vector(&modeling::SlabShape::size, PropertyForm::tr("Size, cm"), Dimension::length, 0.2);
  addResolution<modeling::SlabShape>(form);
}

void addPatch(PropertyForm& form) {
  using Shape = modeling::BezierPatchShape;
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  fields.number(&Shape::thickness, PropertyForm::tr("Thickness"), Dimension::length, 0.05);
  fields.choice(
      &Shape::side, PropertyForm::tr("Wall lies"),
      {PropertyForm::tr("Half on each side"), PropertyForm::tr("Outside"), PropertyForm::tr("Inside")});
  addHint(form, PropertyForm::tr("Drag its control points in the viewport."));
  addResolution<Shape>(form);
}

void addRevolution(PropertyForm& form) {
  using Shape = modeling::RevolutionShape;
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  fields.number(&Shape::turnAngle, PropertyForm::tr("Turn"), Dimension::angle, std::numbers::pi / 36.0);
  fields.number(&Shape::startAngle, PropertyForm::tr("Starts at"), Dimension::angle, std::numbers::pi / 36.0);
  fields.choice(&Shape::correspondence, PropertyForm::tr("Profiles match"),
                {PropertyForm::tr("By length"), PropertyForm::tr("Segment by segment")});
  addResolution<Shape>(form);
}

/// A width that is the same all along; one that varies is left to the handles in the viewport.
void addExtent(PropertyForm& form, modeling::ValueChain modeling::CurvedCylinderShape::*member,
               const QString& text) {
  using Shape = modeling::CurvedCylinderShape;
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  const RowLabel label = fields.labelOf(member, text);
  NumberFormat format;
  format.dimension = Dimension::length;
  format.least = 0.0;
  format.leastExcluded = true;
  format.step = 0.05;
  format.autoText = PropertyForm::tr("varies");
  form.addNumber(
      label, format,
      [member](Scene& scene, const Item& item) -> std::optional<double> {
        Shape* shape = shapeOf<Shape>(scene, item);
        if (!shape || (shape->*member).empty()) return std::nullopt;
        const double first = (shape->*member).front()[0];
        const bool constant =
            shape->*member == modeling::ValueChain((shape->*member).size(), {first, first, first, first});
        return constant ? std::optional(first) : std::nullopt;
      },
      [member](Scene& scene, const Item& item, const std::optional<double>& value) {
        Shape* shape = shapeOf<Shape>(scene, item);
        if (shape && value) shape->*member = modeling::constantValue(*value);
      },
      0.5);
}

void addCurvedCylinder(PropertyForm& form) {
  using Shape = modeling::CurvedCylinderShape;
  const Scene& scene = form.session().document().scene();
  const Shape& shape = std::get<Shape>(scene.parts[form.current().index].shape);
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  fields.choice(&Shape::section, PropertyForm::tr("Section"),
                {PropertyForm::tr("Disc"), PropertyForm::tr("Rectangle"), PropertyForm::tr("Ring"),
                 PropertyForm::tr("Arc")});
  if (shape.secondRail.empty()) addExtent(form, &Shape::halfWidth, PropertyForm::tr("Half width"));
  addExtent(form, &Shape::halfDepth, PropertyForm::tr("Half depth"));
  const bool hollow =
      shape.section == modeling::SweepSection::ring || shape.section == modeling::SweepSection::arc;
  if (hollow) fields.number(&Shape::wallThickness, PropertyForm::tr("Wall"), Dimension::length, 0.05);
  if (shape.section == modeling::SweepSection::arc) {
    fields.number(&Shape::startAngle, PropertyForm::tr("Arc from"), Dimension::angle,
                  std::numbers::pi / 36.0);
    fields.number(&Shape::endAngle, PropertyForm::tr("Arc to"), Dimension::angle, std::numbers::pi / 36.0);
  }
  if (shape.secondRail.empty()) {
    fields.vector(&Shape::firstAxis, PropertyForm::tr("First axis"), Dimension::number, 0.1);
    fields.check(&Shape::keepFirstAxis, PropertyForm::tr("Keep it all along"));
  }
  addHint(form, PropertyForm::tr("Drag its curve and its widths in the viewport."));
  addResolution<Shape>(form);
}

modeling::BondType* bondTypeOf(Scene& scene, const Item& item, std::size_t type) {
  auto* shape = shapeOf<modeling::NetworkShape>(scene, item);
  return shape && type < shape->bondTypes.size() ? &shape->bondTypes[type].constants : nullptr;
}

/// Of shapes that stand in a file of their own.
template <class Shape>
void addFile(PropertyForm& form, Fieldset<Shape>& fields) {
  form.addText(
      fields.labelOf(&Shape::file, PropertyForm::tr("File")),
      [](Scene& scene, const Item& item) {
        const Shape* shape = shapeOf<Shape>(scene, item);
        return shape ? QString::fromStdString(shape->file) : QString();
      },
      [](Scene& scene, const Item& item, const QString& file) {
        if (Shape* shape = shapeOf<Shape>(scene, item)) shape->file = file.toStdString();
      });
}

void addNetwork(PropertyForm& form) {
  using Shape = modeling::NetworkShape;
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  addFile(form, fields);
  const Scene& scene = form.session().document().scene();
  const Shape& shape = std::get<Shape>(scene.parts[form.current().index].shape);
  for (std::size_t type = 0; type < shape.bondTypes.size(); ++type) {
    const std::string& name = shape.bondTypes[type].type;
    form.beginSection(PropertyForm::tr("Bonds of Type %1").arg(QString::fromStdString(name)));
    Fieldset<modeling::BondType> bonds(form, ".bondTypes." + name, [type](Scene& changed, const Item& item) {
      return bondTypeOf(changed, item, type);
    });
    bonds.number(&modeling::BondType::stiffness, PropertyForm::tr("Stiffness"), Dimension::stiffness, 100.0,
                 true);
    bonds.number(&modeling::BondType::restLength, PropertyForm::tr("Length at rest"), Dimension::length, 0.05,
                 PropertyForm::tr("as in the file"));
    bonds.number(&modeling::BondType::damping, PropertyForm::tr("Damping"), Dimension::damping, 0.1, true);
    bonds.number(&modeling::BondType::threshold, PropertyForm::tr("Breaks at"), Dimension::share, 0.01,
                 PropertyForm::tr("never"));
  }
}

void addMesh(PropertyForm& form) {
  using Shape = modeling::MeshShape;
  Fieldset<Shape> fields(form, "", shapeOf<Shape>);
  addFile(form, fields);
  fields.number(&Shape::cellSize, PropertyForm::tr("Cell size"), Dimension::length, 0.05);
}

}  // namespace

void addShapeProperties(PropertyForm& form) {
  const Scene& scene = form.session().document().scene();
  const modeling::PartShape& shape = scene.parts[form.current().index].shape;
  for (const Item& item : form.items()) {
    // Different shapes have no fields in common.
    if (scene.parts[item.index].shape.index() != shape.index()) return;
  }
  form.beginSection(PropertyForm::tr("Shape"));
  if (std::holds_alternative<modeling::SlabShape>(shape)) return addSlab(form);
  if (std::holds_alternative<modeling::BezierPatchShape>(shape)) return addPatch(form);
  if (std::holds_alternative<modeling::RevolutionShape>(shape)) return addRevolution(form);
  if (std::holds_alternative<modeling::CurvedCylinderShape>(shape)) return addCurvedCylinder(form);
  if (std::holds_alternative<modeling::MeshShape>(shape)) return addMesh(form);
  if (std::holds_alternative<modeling::NetworkShape>(shape)) addNetwork(form);
}

}  // namespace ui
