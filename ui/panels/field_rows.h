#pragma once

#include <functional>
#include <set>
#include <string>
#include <type_traits>

#include "modeling/scene/field_info.h"
#include "ui/panels/property_form.h"

namespace ui {

/// The rows of one struct of the scene, made from its list of fields: label, unit, range, step and help are
/// those that stand beside the field there, so that a field that is added to the list gets a row by itself.
/// Fields that need a widget of their own are put in by hand, with the label that `label` gives them.
class FieldRows {
 public:
  using Scene = modeling::Scene;
  /// What makes usual values of a group that a person has just given.
  using Begin = std::function<void(Scene&, const Item&)>;

  /// `path` leads to the struct from the item, as in ".resolution". `place` answers a pointer to the struct
  /// in an item, or null where the item has none; rows of what is not there are hidden.
  template <class Place>
  FieldRows(PropertyForm& form, std::string path, Place place)
      : FieldRows(form, std::move(path), modeling::fieldsOf<OwnerOf<Place>>(),
                  Erased([place](Scene& scene, const Item& item) -> void* { return place(scene, item); })) {}

  /// The row of one field, or its section where it is a group.
  void add(std::string_view key, const Begin& begin = {});
  /// The rows of all fields that were neither added nor labelled nor left out: those with one value first, in
  /// the present section, then a section for each group.
  void addRest();
  /// For a row made by hand.
  RowLabel label(std::string_view key);
  /// How a number of the field is shown, for a row made by hand.
  NumberFormat format(std::string_view key) const;
  /// It is shown elsewhere.
  void leaveOut(std::string_view key) { done_.insert(std::string(key)); }
  /// Sections that follow are folded until a person opens them.
  void foldSections() { open_ = false; }

 private:
  using Erased = std::function<void*(Scene&, const Item&)>;
  template <class Place>
  using OwnerOf = std::remove_pointer_t<std::invoke_result_t<Place, Scene&, const Item&>>;

  FieldRows(PropertyForm& form, std::string path, std::span<const modeling::FieldInfo> fields, Erased place)
      : form_(form), path_(std::move(path)), fields_(fields), place_(std::move(place)) {}

  const modeling::FieldInfo& infoOf(std::string_view key) const;
  RowLabel labelOf(const modeling::FieldInfo& info) const;
  // One a kind of access: a kind without one does not compile.
  template <class Value>
  void addAs(const modeling::FieldInfo& info, const modeling::ValueAccess<Value>& access);
  void addAs(const modeling::FieldInfo& info, const modeling::ChoiceAccess& access);
  void addAs(const modeling::FieldInfo& info, const modeling::GroupAccess& access) {
    addGroup(info, access, {});
  }
  /// A form puts it in by hand (tests/ui/form_coverage_test.cpp).
  void addAs(const modeling::FieldInfo&, const modeling::OtherAccess&) {}
  void addGroup(const modeling::FieldInfo& info, const modeling::GroupAccess& access, const Begin& begin);
  void addPresence(const modeling::FieldInfo& info, const modeling::GroupAccess& access, const Begin& begin);
  template <class Value>
  std::function<Value*(Scene&, const Item&)> reach(const modeling::ValueAccess<Value>& access) const;

  PropertyForm& form_;
  std::string path_;
  std::span<const modeling::FieldInfo> fields_;
  Erased place_;
  std::set<std::string, std::less<>> done_;
  bool open_ = true;
};

/// What the list of fields says, in the window's language.
QString translatedField(std::string_view text);

}  // namespace ui
