#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/collider/collider.h"

namespace sim {

enum class Method {
  forwardEuler,
  symplecticEuler,
  velocityVerlet,
  rungeKutta,
  implicitEuler,
  implicitMidpoint
};
/// What people call the methods, in their order. What the program knows of them is in
/// sim/methods/method_table.h.
inline constexpr std::array<std::string_view, 6> kMethodTitles{"Forward Euler",   "Symplectic Euler",
                                                               "Velocity Verlet", "Runge-Kutta 4",
                                                               "Implicit Euler",  "Implicit midpoint"};
inline constexpr std::size_t kMethods = kMethodTitles.size();

/// Natural length of the spring between two nodes in contact (docs/numerics.md, Contact 3).
enum class ContactLength {
  nearest,  ///< min(r_i, r_j): safe where things break (default)
  sum,      ///< r_i + r_j, as the paper first states it: for what never breaks
};

/// What meets what, between fragments.
enum class ContactKind {
  surfaces,  ///< the outsides of whole cells, at a few per cent of a cell, and loose nodes
  nodes      ///< the paper's: nodes, at the natural length of a bond
};

struct ContactSettings {
  ContactKind kind = ContactKind::surfaces;
  bool between = true;  ///< nodes of different fragments repel
  bool self = false;    ///< nodes of one fragment repel too, unless they were near at rest (Contact 1)
  ContactLength length = ContactLength::nearest;
  double stiffnessScale = 1.0;  ///< of the weaker node's contact stiffness; (0, 1] keeps Breaking 5
  double dampingRatio = 0.3;    ///< relative to critical of the two nodes
  double friction = 0.4;        ///< lateral force relative to k (rho - x) (Contact 6)
};

/// What is left out of the motion of fragments where a scene does not need it (docs/numerics.md, "What is
/// skipped"). Switched off, it is computed in full, to compare.
struct SkipSettings {
  bool sleep = true;  ///< fragments at rest, until something wakes them
  bool rigid = true;  ///< deformation of fragments that fly freely with no strain to speak of

  bool operator==(const SkipSettings&) const = default;
};

struct Settings {
  Method method = Method::velocityVerlet;
  /// s; absent: automatic and stable (docs/numerics.md). Where contacts or tracks make the scene too stiff
  /// for it on the way, it is divided into equal parts.
  std::optional<double> step;
  /// Of strain, relative to the largest there was, rms over bonds, a shortest swing: then the automatic step
  /// is shortened to keep to it. Not for the paper's methods of Euler, and not with `step`.
  std::optional<double> tolerance;
  double safety = 0.5;  ///< s of dt = s (2/omega)...; at most 0.9
  ContactSettings contact;
  SkipSettings skip;
  std::uint64_t seed = 1;  ///< of the thresholds
  int threads = 0;         ///< 0: all there are. Results do not depend on it
};

/// What is in force: the steps of implicit methods are too long for the thin contact of surfaces, so nodes
/// meet there.
inline ContactSettings contactInForce(const Settings& settings) {
  ContactSettings contact = settings.contact;
  if (settings.method == Method::implicitEuler || settings.method == Method::implicitMidpoint)
    contact.kind = ContactKind::nodes;
  return contact;
}

struct Environment {
  Vec3 gravity{0.0, 0.0, -981.0};  ///< cm/s^2
  std::vector<Collider> colliders;
};

}  // namespace sim
