#include <QLabel>
#include <QPushButton>

#include "ui/document/scene_edits.h"
#include "ui/panels/fieldset.h"
#include "ui/panels/item_properties.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"

namespace ui {
namespace {

using modeling::Gluing;
using modeling::Scene;

Gluing* gluingOf(Scene& scene, const Item& item) {
  return item.index < scene.glue.size() ? &scene.glue[item.index] : nullptr;
}

void addPartChoice(PropertyForm& form, std::string Gluing::*member, const QString& text) {
  Fieldset<Gluing> fields(form, "", gluingOf);
  std::vector<std::pair<QString, QVariant>> parts;
  for (const std::string& name : namesOf(form.session().document().scene(), ItemKind::part))
    parts.emplace_back(QString::fromStdString(name), QString::fromStdString(name));
  form.addChoice(
      fields.labelOf(member, text), parts,
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
void addPicked(PropertyForm& form) {
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
      ".pairs");
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

void addRegion(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Only Within"));
  auto* limit = new QPushButton(&form);
  limit->setToolTip(
      PropertyForm::tr("A box in coordinates of the first part: only its nodes inside are glued"));
  form.addWide(limit, [&form, limit](Scene& scene) {
    const Gluing* gluing = gluingOf(scene, form.current());
    limit->setText(gluing && gluing->region ? PropertyForm::tr("Glue Everywhere")
                                            : PropertyForm::tr("Limit to a Box"));
  });
  QObject::connect(limit, &QPushButton::clicked, &form, [&form] {
    form.apply(PropertyForm::tr("Region"), [](Scene& scene, const Item& item) {
      Gluing* gluing = gluingOf(scene, item);
      if (!gluing) return;
      const bool limited = gluing->region.has_value();
      gluing->region.reset();
      if (!limited) gluing->region = modeling::Box{sim::Vec3::Constant(-20.0), sim::Vec3::Constant(20.0)};
    });
  });
  const Gluing& shown = form.session().document().scene().glue[form.current().index];
  if (!shown.region) return;
  Fieldset<modeling::Box> box(form, ".region", [](Scene& scene, const Item& item) -> modeling::Box* {
    Gluing* gluing = gluingOf(scene, item);
    return gluing && gluing->region ? &*gluing->region : nullptr;
  });
  box.vector(&modeling::Box::min, PropertyForm::tr("From, cm"), Dimension::length, 0.2);
  box.vector(&modeling::Box::max, PropertyForm::tr("To, cm"), Dimension::length, 0.2);
}

}  // namespace

void addGluingProperties(PropertyForm& form) {
  form.beginSection(PropertyForm::tr("Glue"));
  addPartChoice(form, &Gluing::a, PropertyForm::tr("Part"));
  addPartChoice(form, &Gluing::b, PropertyForm::tr("Glued to"));
  Fieldset<Gluing> fields(form, "", gluingOf);
  fields.number(&Gluing::reach, PropertyForm::tr("Reach"), Dimension::length, 0.05);
  addPicked(form);
  addReport(form);
  addRegion(form);
}

}  // namespace ui
