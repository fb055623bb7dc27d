#pragma once

#include "sim/contact/contact_model.h"
#include "sim/contact/fragment_boxes.h"
#include "sim/contact/surface_rows.h"
#include "sim/fracture/components.h"

namespace sim {

/// Where everything is when surfaces are searched.
struct SurfaceScene {
  const Outside& outside;
  const Components& components;
  const NodeVectors& positions;
  const FragmentBoxes& boxes;
};

/// cm: the gap below which the surfaces at two nodes push each other.
double reachOf(const ContactModel& model, NodeIndex a, NodeIndex b);
/// cm: how much earlier a node is met that no cell holds any more: it stands for a crumb.
double looseReach(const ContactModel& model, const Outside& outside, NodeIndex node);
/// cm: no gap at which something pushes is wider.
double largestSurfaceReach(const ContactModel& model);

/// Finds what is near what. Contacts are kept where they still name something.
void findSurfaceRows(const ContactModel& model, const SurfaceScene& scene, SurfaceRows& rows);

}  // namespace sim
