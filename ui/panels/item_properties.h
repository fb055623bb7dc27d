#pragma once

#include <string>
#include <vector>

#include "ui/document/selection.h"

/// The rows of each kind of thing.
namespace ui {

class PropertyForm;

void addSceneProperties(PropertyForm& form);
void addPartProperties(PropertyForm& form);
/// Of the part's shape; for parts of one kind of shape.
void addShapeProperties(PropertyForm& form);
void addColliderProperties(PropertyForm& form);
void addGluingProperties(PropertyForm& form);
void addMaterialProperties(PropertyForm& form);
void addTrackProperties(PropertyForm& form);

/// What the rows depend on beside the kind: where it changes, other rows are needed.
std::string structureOf(const modeling::Scene& scene, const std::vector<Item>& items);

}  // namespace ui
