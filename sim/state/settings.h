#pragma once

#include <optional>
#include <string>
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
inline constexpr std::size_t kMethods = 6;

/// What forces of bonds are computed in; the state is double (docs/numerics.md, "Precision").
enum class Precision { float64, float32 };

/// "double", "float"; nothing for any other name.
std::optional<Precision> precisionFromName(std::string_view name);
std::string_view nameOf(Precision precision);
const std::vector<std::string>& precisionNames();

/// Natural length of the spring between two nodes in contact (docs/numerics.md, Contact 3).
enum class ContactLength {
  nearest,  ///< min(r_i, r_j): safe where things break (default)
  sum,      ///< r_i + r_j, as the paper first states it: for what never breaks
};

struct ContactSettings {
  bool between = true;  ///< nodes of different fragments repel
  bool self = false;    ///< nodes of one fragment repel too, unless they were near at rest (Contact 1)
  ContactLength length = ContactLength::nearest;
  double stiffnessScale = 1.0;  ///< of the weaker node's contact stiffness; (0, 1] keeps Breaking 5
  double dampingRatio = 0.3;    ///< relative to critical of the two nodes
  double friction = 0.4;        ///< lateral force relative to k (rho - x) (Contact 6)
};

/// What is left out where a scene does not need it (docs/numerics.md, "What is skipped"). Switched off, the
/// same is computed in full, to compare.
struct SkipSettings {
  bool sleep = true;          ///< fragments at rest, until something wakes them
  bool rigid = true;          ///< deformation of fragments that fly freely with no strain to speak of
  bool contactSearch = true;  ///< where boxes of fragments and colliders are not near each other
  bool labelling = true;      ///< fragments where nothing broke
  bool recording = true;      ///< in takes, nodes that are where they were in a frame before
  bool thresholds = true;     ///< tests of bonds that cannot break
  bool damping = true;        ///< dampers of no strength
  bool ledger = true;         ///< the account of energy between the moments at which it is read

  bool operator==(const SkipSettings&) const = default;
};

struct Settings {
  Method method = Method::velocityVerlet;
  Precision precision = Precision::float64;
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

struct Environment {
  Vec3 gravity{0.0, 0.0, -981.0};  ///< cm/s^2
  std::vector<Collider> colliders;
};

}  // namespace sim
