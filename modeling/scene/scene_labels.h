#pragma once

#include "modeling/scene/scene.h"
#include "modeling/text/choice_labels.h"

/// What people call the choices of a scene, in the order of menus.
namespace modeling {

template <>
struct ChoiceLabels<PatchSide> {
  static constexpr std::array<ChoiceLabel<PatchSide>, 3> kList{{{PatchSide::centred, "Half on each side"},
                                                                {PatchSide::outside, "Outside"},
                                                                {PatchSide::inside, "Inside"}}};
};
static_assert(labelsEachValue(ChoiceLabels<PatchSide>::kList));

template <>
struct ChoiceLabels<SweepSection> {
  static constexpr std::array<ChoiceLabel<SweepSection>, 4> kList{{{SweepSection::disc, "Disc"},
                                                                   {SweepSection::rectangle, "Rectangle"},
                                                                   {SweepSection::ring, "Ring"},
                                                                   {SweepSection::arc, "Arc"}}};
};
static_assert(labelsEachValue(ChoiceLabels<SweepSection>::kList));

template <>
struct ChoiceLabels<ProfileCorrespondence> {
  static constexpr std::array<ChoiceLabel<ProfileCorrespondence>, 2> kList{
      {{ProfileCorrespondence::arcLength, "By length"},
       {ProfileCorrespondence::segments, "Segment by segment"}}};
};
static_assert(labelsEachValue(ChoiceLabels<ProfileCorrespondence>::kList));

template <>
struct ChoiceLabels<NetworkFormat> {
  static constexpr std::array<ChoiceLabel<NetworkFormat>, 1> kList{{{NetworkFormat::lammps, "LAMMPS data"}}};
};
static_assert(labelsEachValue(ChoiceLabels<NetworkFormat>::kList));

template <>
struct ChoiceLabels<MeshUnit> {
  static constexpr std::array<ChoiceLabel<MeshUnit>, 5> kList{{{MeshUnit::guess, "Guess"},
                                                               {MeshUnit::millimetre, "Millimetre"},
                                                               {MeshUnit::centimetre, "Centimetre"},
                                                               {MeshUnit::metre, "Metre"},
                                                               {MeshUnit::inch, "Inch"}}};
};
static_assert(labelsEachValue(ChoiceLabels<MeshUnit>::kList));

template <>
struct ChoiceLabels<MeshUp> {
  static constexpr std::array<ChoiceLabel<MeshUp>, 3> kList{
      {{MeshUp::guess, "Guess"}, {MeshUp::y, "y"}, {MeshUp::z, "z"}}};
};
static_assert(labelsEachValue(ChoiceLabels<MeshUp>::kList));

template <>
struct ChoiceLabels<BondPattern> {
  static constexpr std::array<ChoiceLabel<BondPattern>, 4> kList{
      {{BondPattern::full, "Full: rigid, alike all ways"},
       {BondPattern::fig1, "Edges and body diagonals"},
       {BondPattern::fig2, "Edges and one diagonal a face"},
       {BondPattern::faces, "Edges and face diagonals"}}};
};
static_assert(labelsEachValue(ChoiceLabels<BondPattern>::kList));

template <>
struct ChoiceLabels<Finish> {
  static constexpr std::array<ChoiceLabel<Finish>, 3> kList{
      {{Finish::glazed, "Glazed"}, {Finish::matte, "Matte"}, {Finish::glass, "Glass"}}};
};
static_assert(labelsEachValue(ChoiceLabels<Finish>::kList));

template <>
struct ChoiceLabels<sim::Interpolation> {
  static constexpr std::array<ChoiceLabel<sim::Interpolation>, 3> kList{
      {{sim::Interpolation::step, "Step"},
       {sim::Interpolation::linear, "Linear"},
       {sim::Interpolation::smooth, "Smooth"}}};
};
static_assert(labelsEachValue(ChoiceLabels<sim::Interpolation>::kList));

template <>
struct ChoiceLabels<sim::Method> {
  static constexpr std::array<ChoiceLabel<sim::Method>, sim::kMethods> kList = [] {
    std::array<ChoiceLabel<sim::Method>, sim::kMethods> list{};
    for (std::size_t m = 0; m < list.size(); ++m)
      list[m] = {static_cast<sim::Method>(m), sim::kMethodTitles[m]};
    return list;
  }();
};
static_assert(labelsEachValue(ChoiceLabels<sim::Method>::kList));

template <>
struct ChoiceLabels<sim::ContactKind> {
  static constexpr std::array<ChoiceLabel<sim::ContactKind>, 2> kList{
      {{sim::ContactKind::surfaces, "Surfaces"}, {sim::ContactKind::nodes, "Nodes (the paper's)"}}};
};
static_assert(labelsEachValue(ChoiceLabels<sim::ContactKind>::kList));

template <>
struct ChoiceLabels<sim::ContactLength> {
  static constexpr std::array<ChoiceLabel<sim::ContactLength>, 2> kList{
      {{sim::ContactLength::nearest, "The nearer's (safe)"},
       {sim::ContactLength::sum, "Sum (never breaks)"}}};
};
static_assert(labelsEachValue(ChoiceLabels<sim::ContactLength>::kList));

template <>
struct ChoiceLabels<PictureSurface> {
  static constexpr std::array<ChoiceLabel<PictureSurface>, 2> kList{
      {{PictureSurface::cells, "Of the cells"}, {PictureSurface::level, "Level surface"}}};
};
static_assert(labelsEachValue(ChoiceLabels<PictureSurface>::kList));

template <>
struct ChoiceLabels<GroundKind> {
  static constexpr std::array<ChoiceLabel<GroundKind>, 6> kList{{{GroundKind::studio, "Studio floor"},
                                                                 {GroundKind::none, "None"},
                                                                 {GroundKind::plain, "Plain"},
                                                                 {GroundKind::checker, "Checker"},
                                                                 {GroundKind::wood, "Wood"},
                                                                 {GroundKind::shadow, "Shadows only"}}};
};
static_assert(labelsEachValue(ChoiceLabels<GroundKind>::kList));

template <>
struct ChoiceLabels<BackdropKind> {
  static constexpr std::array<ChoiceLabel<BackdropKind>, 4> kList{
      {{BackdropKind::studio, "Studio"},
       {BackdropKind::colour, "Colour"},
       {BackdropKind::gradient, "Gradient"},
       {BackdropKind::environment, "Environment"}}};
};
static_assert(labelsEachValue(ChoiceLabels<BackdropKind>::kList));

}  // namespace modeling
