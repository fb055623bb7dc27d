#include "ui/panels/rotation_rows.h"

#include <numbers>

#include "ui/panels/vector_field.h"

namespace ui {

sim::Vec3 anglesOf(const modeling::Rotation& rotation) {
  if (const auto* angles = std::get_if<sim::Vec3>(&rotation.value)) return *angles;
  // R = Rz Ry Rx: the angles of Eigen's z, y, x, turned round.
  const sim::Vec3 zyx = rotation.quaternion().toRotationMatrix().eulerAngles(2, 1, 0);
  return sim::Vec3(zyx[2], zyx[1], zyx[0]) * (180.0 / std::numbers::pi);
}

void addRotation(PropertyForm& form, const RowLabel& label, const NumberFormat& format,
                 const std::function<modeling::Rotation*(modeling::Scene&, const Item&)>& place) {
  auto* field = new VectorField(format, &form);
  field->setDefault(sim::Vec3::Zero());
  field->setObjectName(QString::fromStdString(label.path));
  form.addRow(label, field, [&form, field, place](modeling::Scene& scene) {
    const modeling::Rotation* shown = place(scene, form.current());
    if (!shown) return;
    const sim::Vec3 angles = anglesOf(*shown);
    field->setValue(angles);
    for (const Item& item : form.items()) {
      const modeling::Rotation* other = place(scene, item);
      if (!other) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = static_cast<Eigen::Index>(axis);
        if (anglesOf(*other)[number] != angles[number]) field->field(axis).setMixed(true);
      }
    }
  });
  QObject::connect(field, &VectorField::edited, &form,
                   [&form, label, place](std::size_t axis, double value, bool finished) {
                     form.apply(
                         label.text,
                         [&](modeling::Scene& scene, const Item& item) {
                           modeling::Rotation* rotation = place(scene, item);
                           if (!rotation) return;
                           sim::Vec3 angles = anglesOf(*rotation);
                           angles[static_cast<Eigen::Index>(axis)] = value;
                           rotation->value = angles;
                         },
                         finished);
                   });
}

}  // namespace ui
