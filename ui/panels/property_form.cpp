#include "ui/panels/property_form.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/file_field.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"
#include "ui/panels/vector_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kLabelWidth = 92;

QString sentenceOf(const sim::Problem& problem) {
  QString text = QString::fromStdString(problem.what);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  if (!problem.remedy.empty()) text += QStringLiteral(": ") + QString::fromStdString(problem.remedy);
  return text + u'.';
}

QLabel* problemLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QStringLiteral("property-problem"));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->hide();
  return label;
}

void showIn(QLabel& label, const sim::Problem& problem) {
  label.setStyleSheet(QStringLiteral("color: %1;").arg(Theme::instance().colours().bad.name()));
  label.setText(sentenceOf(problem));
  label.show();
}

/// A place is of a row where one path leads on from the other.
bool leadsOn(const std::string& from, const std::string& to) {
  if (from.empty() || !to.starts_with(from)) return false;
  return to.size() == from.size() || to[from.size()] == '.' || to[from.size()] == '[';
}

QColor colourOf(const modeling::Colour& colour) {
  return QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                          static_cast<float>(colour[2]));
}

}  // namespace

PropertyForm::PropertyForm(Session& session, std::vector<Item> items, QWidget* parent)
    : QWidget(parent), session_(session), items_(std::move(items)), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(10, 4, 10, 12);
  column_->setSpacing(4);
  problem_ = problemLabel(this);
  column_->addWidget(problem_);
  column_->addStretch(1);
}

std::string PropertyForm::itemPath() const {
  const std::string index = std::string(1, '[').append(std::to_string(current().index)).append("]");
  switch (current().kind) {
    case ItemKind::scene:
      return "";
    case ItemKind::part:
      return "parts" + index;
    case ItemKind::gluing:
      return "glue" + index;
    case ItemKind::collider:
      return "environment.colliders" + index;
    case ItemKind::material:
      return "materials" + index;
    case ItemKind::track:
      return "tracks" + index;
  }
  return "";
}

std::vector<std::string> PropertyForm::paths() const {
  std::vector<std::string> paths;
  for (const Row& row : rows_) {
    if (!row.path.empty()) paths.push_back(row.path);
  }
  return paths;
}

Section* PropertyForm::beginSection(const QString& title, bool open) {
  section_ = new Section(title, open, this);
  column_->insertWidget(column_->count() - 1, section_);
  return section_;
}

PropertyForm::Row& PropertyForm::insert(const RowLabel& label, QWidget* field, bool wide) {
  auto* row = new QWidget(this);
  auto* column = new QVBoxLayout(row);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* line = new QHBoxLayout;
  line->setSpacing(6);
  if (!wide) {
    const bool unitSaid = !label.unit.isEmpty();
    auto* name = new QLabel(unitSaid ? label.text + QStringLiteral(", ") + label.unit : label.text, row);
    name->setFixedWidth(kLabelWidth);
    name->setToolTip(label.help);
    name->setBuddy(field);
    line->addWidget(name);
  }
  line->addWidget(field, 1);
  column->addLayout(line);
  QLabel* problem = problemLabel(row);
  column->addWidget(problem);
  if (!label.help.isEmpty()) field->setToolTip(label.help);
  if (!label.text.isEmpty()) field->setAccessibleName(label.text);
  if (section_) {
    section_->add(row);
  } else {
    column_->insertWidget(column_->count() - 1, row);
  }
  const bool named = !label.path.empty();
  rows_.push_back({named ? itemPath() + label.path : std::string(), row, field, problem, label.counts, {}});
  if (named && rows_.back().path.starts_with('.')) rows_.back().path.erase(0, 1);
  return rows_.back();
}

QWidget* PropertyForm::addRow(const RowLabel& label, QWidget* field,
                              const std::function<void(Scene&)>& show) {
  Row& row = insert(label, field, false);
  row.show = show;
  return row.widget;
}

void PropertyForm::addWide(QWidget* content, const std::function<void(Scene&)>& show, const RowLabel& label) {
  const QString help = content->toolTip().isEmpty() ? label.help : content->toolTip();
  insert({{}, help, label.path, {}, label.counts}, content, true).show = show;
}

NumberField* PropertyForm::addNumber(const RowLabel& label, const NumberFormat& format,
                                     const Read<MaybeNumber>& read, const Write<MaybeNumber>& write,
                                     MaybeNumber standard) {
  auto* field = new NumberField(format, this);
  field->setDefault(standard);
  field->setObjectName(QString::fromStdString(label.path));
  addRow(label, field, [this, field, read](Scene& scene) {
    field->setValue(read(scene, current()));
    for (const Item& item : items_) {
      if (read(scene, item) != field->value()) field->setMixed(true);
    }
  });
  connect(field, &NumberField::edited, this, [this, label, write](MaybeNumber value, bool finished) {
    apply(
        label.text, [&](Scene& scene, const Item& item) { write(scene, item, value); }, finished);
  });
  return field;
}

VectorField* PropertyForm::addVector(const RowLabel& label, const NumberFormat& format,
                                     const std::function<sim::Vec3*(Scene&, const Item&)>& place,
                                     const sim::Vec3& standard) {
  auto* field = new VectorField(format, this);
  field->setDefault(standard);
  field->setObjectName(QString::fromStdString(label.path));
  addRow(label, field, [this, field, place](Scene& scene) {
    const sim::Vec3* shown = place(scene, current());
    if (!shown) return;
    field->setValue(*shown);
    for (const Item& item : items_) {
      const sim::Vec3* other = place(scene, item);
      for (std::size_t axis = 0; other && axis < 3; ++axis) {
        const auto number = static_cast<Eigen::Index>(axis);
        if ((*other)[number] != (*shown)[number]) field->field(axis).setMixed(true);
      }
    }
  });
  connect(field, &VectorField::edited, this,
          [this, label, place](std::size_t axis, double value, bool finished) {
            apply(
                label.text,
                [&](Scene& scene, const Item& item) {
                  if (sim::Vec3* vector = place(scene, item))
                    (*vector)[static_cast<Eigen::Index>(axis)] = value;
                },
                finished);
          });
  return field;
}

QWidget* PropertyForm::addCheck(const RowLabel& label,
                                const std::function<bool*(Scene&, const Item&)>& place) {
  auto* field = new CheckField(label.text, this);
  field->setObjectName(QString::fromStdString(label.path));
  RowLabel unnamed = label;
  unnamed.text.clear();
  addRow(unnamed, field, [this, field, place](Scene& scene) {
    const bool* shown = place(scene, current());
    if (shown) field->setChecked(*shown);
  });
  connect(field, &QAbstractButton::clicked, this, [this, label, place](bool checked) {
    apply(label.text, [&](Scene& scene, const Item& item) {
      if (bool* value = place(scene, item)) *value = checked;
    });
  });
  return field;
}

ChoiceField* PropertyForm::addChoice(const RowLabel& label,
                                     const std::vector<std::pair<QString, QVariant>>& choices,
                                     const Read<QVariant>& read, const Write<QVariant>& write) {
  auto* field = new ChoiceField(this);
  field->setObjectName(QString::fromStdString(label.path));
  for (const auto& [text, key] : choices) field->addItem(text, key);
  addRow(label, field, [this, field, read](Scene& scene) {
    const QVariant shown = read(scene, current());
    field->setValue(shown);
    for (const Item& item : items_) {
      if (read(scene, item) != shown) field->setValue({});
    }
  });
  connect(field, &ChoiceField::edited, this, [this, label, write](const QVariant& key) {
    apply(label.text, [&](Scene& scene, const Item& item) { write(scene, item, key); });
  });
  return field;
}

TextField* PropertyForm::addText(const RowLabel& label, const Read<QString>& read,
                                 const Write<QString>& write) {
  auto* field = new TextField(this);
  field->setObjectName(QString::fromStdString(label.path));
  addRow(label, field, [this, field, read](Scene& scene) { field->setValue(read(scene, current())); });
  connect(field, &TextField::edited, this, [this, label, write](const QString& text) {
    apply(label.text, [&](Scene& scene, const Item& item) { write(scene, item, text); });
    showScene();
  });
  return field;
}

FileField* PropertyForm::addFile(const RowLabel& label, const QString& patterns,
                                 const std::function<std::string*(Scene&, const Item&)>& place) {
  auto* field = new FileField(patterns, this);
  field->setObjectName(QString::fromStdString(label.path));
  addRow(label, field, [this, field, place](Scene& scene) {
    field->setFolder(QString::fromStdString(session_.document().folder().string()));
    if (const std::string* path = place(scene, current())) field->setValue(QString::fromStdString(*path));
  });
  connect(field, &FileField::edited, this, [this, label, place](const QString& path) {
    apply(label.text, [&](Scene& scene, const Item& item) {
      if (std::string* value = place(scene, item)) *value = path.toStdString();
    });
    showScene();
  });
  return field;
}

ColourField* PropertyForm::addColour(const RowLabel& label,
                                     const std::function<modeling::Colour*(Scene&, const Item&)>& place) {
  auto* field = new ColourField(this);
  field->setObjectName(QString::fromStdString(label.path));
  addRow(label, field, [this, field, place](Scene& scene) {
    if (const modeling::Colour* colour = place(scene, current())) field->setValue(colourOf(*colour));
  });
  connect(field, &ColourField::edited, this, [this, label, place](const QColor& colour, bool finished) {
    apply(
        label.text,
        [&](Scene& scene, const Item& item) {
          modeling::Colour* value = place(scene, item);
          // The same colour to the eye keeps the digits of the file.
          if (value && colourOf(*value) != colour) *value = {colour.redF(), colour.greenF(), colour.blueF()};
        },
        finished);
  });
  return field;
}

ColourField* PropertyForm::addColour(
    const RowLabel& label, const QString& absent,
    const std::function<std::optional<modeling::Colour>*(Scene&, const Item&)>& place) {
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  auto* field = new ColourField(both);
  field->setAbsentText(absent);
  field->setObjectName(QString::fromStdString(label.path));
  auto* remove = new QToolButton(both);
  remove->setIcon(Theme::icon(QStringLiteral("remove")));
  remove->setToolTip(tr("Back to “%1”").arg(absent));
  row->addWidget(field, 1);
  row->addWidget(remove);
  both->setFocusProxy(field);
  addRow(label, both, [this, field, remove, place](Scene& scene) {
    const std::optional<modeling::Colour>* colour = place(scene, current());
    const bool given = colour && *colour;
    field->setValue(given ? colourOf(**colour) : QColor());
    remove->setEnabled(given);
  });
  const auto take = [this, label, place](const QColor& colour, bool finished) {
    apply(
        label.text,
        [&](Scene& scene, const Item& item) {
          std::optional<modeling::Colour>* value = place(scene, item);
          if (!value) return;
          if (!colour.isValid()) {
            value->reset();
          } else if (!*value || colourOf(**value) != colour) {
            *value = {colour.redF(), colour.greenF(), colour.blueF()};
          }
        },
        finished);
  };
  connect(field, &ColourField::edited, this, take);
  connect(remove, &QToolButton::clicked, this, [take] { take(QColor(), true); });
  return field;
}

void PropertyForm::apply(const QString& what, const std::function<void(Scene&, const Item&)>& change,
                         bool finished) {
  if (forsaken_) return;
  const QString name = what.isEmpty() ? tr("Change") : tr("Change %1").arg(what.toLower());
  const std::vector<Item> items = items_;
  Document& document = session_.document();
  document.edit(
      name,
      [&](Scene& scene) {
        for (const Item& item : items) {
          if (item.index < countOf(scene, item.kind)) change(scene, item);
        }
      },
      QStringLiteral("property ") + what);
  if (finished) document.endGesture();
}

void PropertyForm::showScene() {
  Scene scene = session_.document().scene();
  if (current().index >= countOf(scene, current().kind)) return;
  for (const Row& row : rows_) {
    const bool counts = !row.counts || row.counts(scene, current());
    row.widget->setVisible(counts);
    if (counts && row.show) row.show(scene);
  }
}

const PropertyForm::Row* PropertyForm::rowOf(const std::string& place) const {
  const Row* best = nullptr;
  for (const Row& row : rows_) {
    if (leadsOn(row.path, place) && (!best || row.path.size() > best->path.size())) best = &row;
  }
  for (const Row& row : rows_) {
    if (!best && leadsOn(place, row.path)) best = &row;
  }
  return best;
}

bool PropertyForm::showProblem(const sim::Problem* problem) {
  problem_->hide();
  for (const Row& row : rows_) {
    row.problem->hide();
    if (auto* number = qobject_cast<NumberField*>(row.field)) number->setProblem(false);
  }
  if (!problem) return false;
  const bool ofItem = itemPath().empty() || leadsOn(itemPath(), problem->place);
  const Row* row = ofItem && problem->place != itemPath() ? rowOf(problem->place) : nullptr;
  if (row) {
    showIn(*row->problem, *problem);
    if (auto* number = qobject_cast<NumberField*>(row->field)) number->setProblem(true);
    return true;
  }
  if (!ofItem || itemPath().empty()) return false;
  showIn(*problem_, *problem);
  return true;
}

}  // namespace ui
