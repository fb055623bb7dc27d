#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ui/document/selection.h"

namespace ui {

enum class TransformMode : std::uint8_t { move, rotate, scale };

/// What is done to parts and colliders, about a pivot. World coordinates, but for the scale, which is along
/// the things' own axes, because a turned lattice cannot be sheared.
struct Transform {
  TransformMode mode = TransformMode::move;
  sim::Vec3 pivot = sim::Vec3::Zero();    ///< cm
  sim::Vec3 offset = sim::Vec3::Zero();   ///< move: cm
  sim::Vec3 axis = sim::Vec3::UnitZ();    ///< rotate: unit
  double angle = 0.0;                     ///< rotate: radians
  sim::Vec3 factors = sim::Vec3::Ones();  ///< scale: each above 0
};

/// Parts and colliders as they stood when a transform began.
class TransformStart {
 public:
  /// What can be moved of a selection.
  TransformStart(const modeling::Scene& scene, const std::vector<Item>& items);

  bool operator==(const TransformStart&) const = default;
  bool isEmpty() const { return parts_.empty() && colliders_.empty(); }
  /// Mean of where they are, cm.
  sim::Vec3 middle() const;
  /// worldFromThing of the last one.
  Eigen::Quaterniond orientation() const { return orientation_; }
  /// Puts them where the transform brings them; the rest of the scene stays.
  void apply(const Transform& transform, modeling::Scene& scene) const;

 private:
  std::vector<std::pair<std::size_t, modeling::Placement>> parts_;
  std::vector<std::string> partNames_;  ///< likewise
  std::vector<std::pair<std::size_t, modeling::SceneCollider>> colliders_;
  Eigen::Quaterniond orientation_ = Eigen::Quaterniond::Identity();
};

/// As it is written: degrees stay degrees, a quaternion one.
modeling::Rotation turned(const modeling::Rotation& rotation, const Eigen::Quaterniond& turn);

}  // namespace ui
