#include "ui/panels/field_rows.h"

#include <QCoreApplication>

#include "ui/panels/plain_fields.h"
#include "ui/panels/section.h"
#include "ui/panels/value_rows.h"

namespace ui {

using modeling::FieldInfo;

QString translatedField(std::string_view text) {
  return QCoreApplication::translate("Fields", std::string(text).c_str());
}

const FieldInfo& FieldRows::infoOf(std::string_view key) const {
  const FieldInfo* info = modeling::findField(fields_, key);
  Q_ASSERT_X(info, "FieldRows", "there is no field of this key");
  return *info;
}

RowLabel FieldRows::labelOf(const FieldInfo& info) const {
  const auto counts = [place = place_, counts = info.counts](Scene& scene, const Item& item) {
    const void* owner = place(scene, item);
    return owner != nullptr && counts(owner);
  };
  return {translatedField(info.display.label),
          translatedField(info.rule.help),
          path_ + "." + std::string(info.rule.key),
          {},
          counts};
}

RowLabel FieldRows::label(std::string_view key) {
  leaveOut(key);
  return labelOf(infoOf(key));
}

NumberFormat FieldRows::format(std::string_view key) const {
  const FieldInfo& info = infoOf(key);
  return formatOf(info.rule, info.display);
}

void FieldRows::add(std::string_view key, const Begin& begin) {
  leaveOut(key);
  const FieldInfo& info = infoOf(key);
  if (const auto* group = std::get_if<modeling::GroupAccess>(&info.access))
    return addGroup(info, *group, begin);
  std::visit([&](const auto& access) { addAs(info, access); }, info.access);
}

void FieldRows::addRest() {
  for (const FieldInfo& info : fields_) {
    if (std::holds_alternative<modeling::GroupAccess>(info.access) || done_.contains(info.rule.key)) continue;
    add(info.rule.key);
  }
  for (const FieldInfo& info : fields_) {
    if (!done_.contains(info.rule.key)) add(info.rule.key);
  }
}

template <class Value>
std::function<Value*(modeling::Scene&, const Item&)> FieldRows::reach(
    const modeling::ValueAccess<Value>& access) const {
  return [place = place_, of = access.of](Scene& scene, const Item& item) -> Value* {
    void* owner = place(scene, item);
    return owner ? &of(owner) : nullptr;
  };
}

template <class Value>
void FieldRows::addAs(const FieldInfo& info, const modeling::ValueAccess<Value>& access) {
  addRow(form_, ValueRow<Value>{labelOf(info), info.rule, info.display, reach(access),
                                modeling::standardOf(info, access)});
}

void FieldRows::addAs(const FieldInfo& info, const modeling::ChoiceAccess& access) {
  std::vector<std::pair<QString, QVariant>> choices;
  for (const modeling::ChoiceInfo& choice : access.choices())
    choices.emplace_back(translatedField(choice.label), choice.value);
  form_.addChoice(
      labelOf(info), choices,
      [place = place_, access](Scene& scene, const Item& item) {
        const void* owner = place(scene, item);
        return owner ? QVariant(access.get(owner)) : QVariant();
      },
      [place = place_, access](Scene& scene, const Item& item, const QVariant& data) {
        if (void* owner = place(scene, item)) access.set(owner, data.toInt());
      });
}

void FieldRows::addGroup(const FieldInfo& info, const modeling::GroupAccess& access, const Begin& begin) {
  Section* section = form_.beginSection(translatedField(info.display.label), open_);
  section->setToolTip(translatedField(info.rule.help));
  if (access.setPresent) addPresence(info, access, begin);
  FieldRows inner(form_, path_ + "." + std::string(info.rule.key), access.fields(),
                  [place = place_, access](Scene& scene, const Item& item) -> void* {
                    void* owner = place(scene, item);
                    return owner ? access.of(owner) : nullptr;
                  });
  inner.open_ = open_;
  inner.addRest();
}

void FieldRows::addPresence(const FieldInfo& info, const modeling::GroupAccess& access, const Begin& begin) {
  RowLabel label = labelOf(info);
  const QString what = label.text;
  auto* field = new CheckField(translatedField(info.display.present), &form_);
  field->setObjectName(QString::fromStdString(label.path));
  label.text.clear();
  form_.addRow(label, field, [form = &form_, field, place = place_, access](Scene& scene) {
    void* owner = place(scene, form->current());
    field->setChecked(owner && access.of(owner));
  });
  QObject::connect(field, &QAbstractButton::clicked, &form_,
                   [form = &form_, what, place = place_, access, begin](bool checked) {
                     form->apply(what, [&](Scene& scene, const Item& item) {
                       void* owner = place(scene, item);
                       if (!owner || (access.of(owner) != nullptr) == checked) return;
                       access.setPresent(owner, checked);
                       if (checked && begin) begin(scene, item);
                     });
                   });
}

}  // namespace ui
