#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "modeling/scene/scene.h"
#include "modeling/text/enum_values.h"
#include "modeling/text/json_fields.h"
#include "sim/methods/method_names.h"

/// The names that choices have in a scene file.
namespace modeling {

/// Names from `Derived::kTable`, an array of pairs of name and value. A value without a name does not
/// compile.
template <class Derived, class T>
struct NameTable {
  static std::vector<std::string> names() {
    std::vector<std::string> result;
    result.reserve(std::size(Derived::kTable));
    for (const auto& [name, value] : Derived::kTable) result.emplace_back(name);
    return result;
  }
  static std::optional<T> find(std::string_view wanted) {
    for (const auto& [name, value] : Derived::kTable) {
      if (name == wanted) return value;
    }
    return std::nullopt;
  }
  static std::string_view nameOf(T wanted) {
    static_assert(namesEachOnce(Derived::kTable), "a value has no name, or two");
    const auto entry = std::find_if(Derived::kTable.begin(), Derived::kTable.end(),
                                    [wanted](const auto& row) { return row.second == wanted; });
    return entry->first;
  }
};

template <class T>
using NameRow = std::pair<std::string_view, T>;

template <>
struct EnumNames<PatchSide> : NameTable<EnumNames<PatchSide>, PatchSide> {
  static constexpr std::array<NameRow<PatchSide>, 3> kTable{
      {{"centred", PatchSide::centred}, {"outside", PatchSide::outside}, {"inside", PatchSide::inside}}};
};

template <>
struct EnumNames<SweepSection> : NameTable<EnumNames<SweepSection>, SweepSection> {
  static constexpr std::array<NameRow<SweepSection>, 4> kTable{{{"disc", SweepSection::disc},
                                                                {"rectangle", SweepSection::rectangle},
                                                                {"ring", SweepSection::ring},
                                                                {"arc", SweepSection::arc}}};
};

template <>
struct EnumNames<ProfileCorrespondence> : NameTable<EnumNames<ProfileCorrespondence>, ProfileCorrespondence> {
  static constexpr std::array<NameRow<ProfileCorrespondence>, 2> kTable{
      {{"arcLength", ProfileCorrespondence::arcLength}, {"segments", ProfileCorrespondence::segments}}};
};

template <>
struct EnumNames<NetworkFormat> : NameTable<EnumNames<NetworkFormat>, NetworkFormat> {
  static constexpr std::array<NameRow<NetworkFormat>, 1> kTable{{{"lammps", NetworkFormat::lammps}}};
};

template <>
struct EnumNames<MeshUnit> : NameTable<EnumNames<MeshUnit>, MeshUnit> {
  static constexpr std::array<NameRow<MeshUnit>, 5> kTable{{{"guess", MeshUnit::guess},
                                                            {"mm", MeshUnit::millimetre},
                                                            {"cm", MeshUnit::centimetre},
                                                            {"m", MeshUnit::metre},
                                                            {"in", MeshUnit::inch}}};
};

template <>
struct EnumNames<MeshUp> : NameTable<EnumNames<MeshUp>, MeshUp> {
  static constexpr std::array<NameRow<MeshUp>, 3> kTable{
      {{"guess", MeshUp::guess}, {"y", MeshUp::y}, {"z", MeshUp::z}}};
};

template <>
struct EnumNames<sim::Interpolation> : NameTable<EnumNames<sim::Interpolation>, sim::Interpolation> {
  static constexpr std::array<NameRow<sim::Interpolation>, 3> kTable{
      {{"step", sim::Interpolation::step},
       {"linear", sim::Interpolation::linear},
       {"smooth", sim::Interpolation::smooth}}};
};

template <>
struct EnumNames<sim::ContactKind> : NameTable<EnumNames<sim::ContactKind>, sim::ContactKind> {
  static constexpr std::array<NameRow<sim::ContactKind>, 2> kTable{
      {{"surfaces", sim::ContactKind::surfaces}, {"nodes", sim::ContactKind::nodes}}};
};

template <>
struct EnumNames<sim::ContactLength> : NameTable<EnumNames<sim::ContactLength>, sim::ContactLength> {
  static constexpr std::array<NameRow<sim::ContactLength>, 2> kTable{
      {{"nearest", sim::ContactLength::nearest}, {"sum", sim::ContactLength::sum}}};
};

template <>
struct EnumNames<Finish> : NameTable<EnumNames<Finish>, Finish> {
  static constexpr std::array<NameRow<Finish>, 3> kTable{
      {{"glazed", Finish::glazed}, {"matte", Finish::matte}, {"glass", Finish::glass}}};
};

template <>
struct EnumNames<PictureSurface> : NameTable<EnumNames<PictureSurface>, PictureSurface> {
  static constexpr std::array<NameRow<PictureSurface>, 2> kTable{
      {{"cells", PictureSurface::cells}, {"level", PictureSurface::level}}};
};

template <>
struct EnumNames<GroundKind> : NameTable<EnumNames<GroundKind>, GroundKind> {
  static constexpr std::array<NameRow<GroundKind>, 6> kTable{{{"studio", GroundKind::studio},
                                                              {"none", GroundKind::none},
                                                              {"plain", GroundKind::plain},
                                                              {"checker", GroundKind::checker},
                                                              {"wood", GroundKind::wood},
                                                              {"shadow", GroundKind::shadow}}};
};

template <>
struct EnumNames<BackdropKind> : NameTable<EnumNames<BackdropKind>, BackdropKind> {
  static constexpr std::array<NameRow<BackdropKind>, 4> kTable{{{"studio", BackdropKind::studio},
                                                                {"colour", BackdropKind::colour},
                                                                {"gradient", BackdropKind::gradient},
                                                                {"environment", BackdropKind::environment}}};
};

template <>
struct EnumNames<sim::Method> {
  static std::vector<std::string> names() { return sim::methodNames(); }
  static std::optional<sim::Method> find(std::string_view name) { return sim::methodFromName(name); }
  static std::string_view nameOf(sim::Method method) { return sim::nameOf(method); }
};

template <>
struct EnumNames<BondPattern> {
  static std::vector<std::string> names() { return bondPatternNames(); }
  static std::optional<BondPattern> find(std::string_view name) { return bondPatternFromName(name); }
  static std::string_view nameOf(BondPattern pattern) { return modeling::nameOf(pattern); }
};

/// Kinds that name themselves.
template <class... Kinds>
requires(requires { Kinds::kName; } && ...) struct VariantNames<std::variant<Kinds...>> {
  static constexpr std::string_view kTag = "kind";
  static constexpr std::array<std::string_view, sizeof...(Kinds)> kNames{Kinds::kName...};
};

}  // namespace modeling
