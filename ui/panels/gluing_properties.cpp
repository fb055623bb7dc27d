#include <QLabel>
#include <QPushButton>

#include "ui/document/scene_edits.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"

namespace ui {
namespace {

using modeling::Gluing;
using modeling::Scene;

Gluing* gluingOf(Scene& scene, const Item& item) {
  return item.index < scene.glue.size() ? &scene.glue[item.index] : nullptr;
}

void addPartChoice(PropertyForm& form, std::string Gluing::*member, const RowLabel& label) {
  std::vector<std::pair<QString, QVariant>> parts;
  for (const std::string& name : namesOf(form.session().document().scene(), ItemKind::part))
    parts.emplace_back(QString::fromStdString(name), QString::fromStdString(name));
  form.addChoice(
      label, parts,
      [member](Scene& scene, const Item& item) -> QVariant {
        const Gluing* gluing = gluingOf(scene, item);
        return gluing ? QVariant(QString::fromStdString(gluing->*member)) : QVariant();
      },
      [member](Scene& scene, const Item& item, const QVariant& data) {
        if (Gluing* gluing = gluingOf(scene, item)) gluing->*member = data.toString().toStdString();
      });
}

QString reportText(const modeling::GlueReport& report) {
  QStringList lines;
  lines << PropertyForm::tr("Nodes glued: %L1, the farthest over %2")
               .arg(report.nodesMerged)
               .arg(quantityText(report.worstDistance, Dimension::length, 3));
  if (report.nodesReleased > 0)
    lines << PropertyForm::tr("Let go, as a cell would have been twisted: %L1").arg(report.nodesReleased);
  if (report.nodesTaken > 0)
    lines << PropertyForm::tr("Taken by an earlier gluing: %L1").arg(report.nodesTaken);
  if (report.worstCell != sim::kNone)
    lines << PropertyForm::tr("Skew of the worst cell beside it: %1")
                 .arg(report.worstScaledJacobian, 0, 'f', 2);
  return lines.join(u'\n');
}

const modeling::GlueReport* reportOf(const Session& session, const Gluing& gluing) {
  const Preview& preview = *session.preview();
  if (!preview.built) return nullptr;
  for (const modeling::GlueReport& report : preview.built->glue) {
    if (report.a == gluing.a && report.b == gluing.b) return &report;
  }
  return nullptr;
}

void addReport(PropertyForm& form) {
  auto* report = new QLabel(&form);
  report->setObjectName(QStringLiteral("glue-report"));
  report->setWordWrap(true);
  report->setForegroundRole(QPalette::PlaceholderText);
  form.addWide(report, [&form, report](Scene& scene) {
    const Gluing* gluing = gluingOf(scene, form.current());
    const modeling::GlueReport* done = gluing ? reportOf(form.session(), *gluing) : nullptr;
    report->setText(done ? reportText(*done) : QString());
    report->setVisible(done != nullptr);
  });
}

/// What was picked node by node, with a button to go back to the reach alone.
void addPicked(PropertyForm& form, const RowLabel& label) {
  auto* picked = new QWidget(&form);
  auto* row = new QHBoxLayout(picked);
  row->setContentsMargins(0, 0, 0, 0);
  auto* text = new QLabel(picked);
  text->setWordWrap(true);
  auto* clear = new QPushButton(PropertyForm::tr("By Reach Alone"), picked);
  clear->setToolTip(PropertyForm::tr("Forgets nodes that were picked or taken out one by one"));
  row->addWidget(text, 1);
  row->addWidget(clear);
  form.addWide(
      picked,
      [&form, picked, text](Scene& scene) {
        const Gluing* gluing = gluingOf(scene, form.current());
        if (!gluing) return;
        picked->setVisible(!gluing->pairs.empty() || !gluing->exclude.empty());
        text->setText(gluing->pairs.empty()
                          ? PropertyForm::tr("Nodes taken out: %L1").arg(gluing->exclude.size())
                          : PropertyForm::tr("Pairs picked by hand: %L1").arg(gluing->pairs.size()));
      },
      label);
  QObject::connect(clear, &QPushButton::clicked, &form, [&form] {
    form.apply(PropertyForm::tr("Glue"), [](Scene& scene, const Item& item) {
      Gluing* gluing = gluingOf(scene, item);
      if (!gluing) return;
      gluing->pairs.clear();
      gluing->exclude.clear();
      if (gluing->reach <= 0.0) gluing->reach = 0.5;
    });
  });
}

/// A box about the first part, in its own coordinates, to be made smaller.
void beginRegion(Scene& scene, const Item& item) {
  constexpr double kHalfSize = 20.0;  // cm
  if (Gluing* gluing = gluingOf(scene, item))
    gluing->region = modeling::Box{sim::Vec3::Constant(-kHalfSize), sim::Vec3::Constant(kHalfSize)};
}

}  // namespace

void addGluingProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Glue"));
  FieldRows gluing(form, "", gluingOf);
  addPartChoice(form, &Gluing::a, gluing.label("a"));
  addPartChoice(form, &Gluing::b, gluing.label("b"));
  const RowLabel pairs = gluing.label("pairs");
  gluing.leaveOut("exclude");
  gluing.leaveOut("region");
  gluing.addRest();
  addPicked(form, pairs);
  addReport(form);
  gluing.add("region", beginRegion);
}

}  // namespace ui
