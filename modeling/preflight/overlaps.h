#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "modeling/scene/build.h"

namespace modeling {

/// Two things that are in one place before anything moves.
struct Overlap {
  enum class Kind {
    partInObstacle,  ///< nodes of the part are inside: they will be let out slowly
    obstacleInPart,  ///< it stands between the part's nodes, which do not feel it yet
    parts,           ///< two parts: they will stay in each other, and part when something breaks
  };
  Kind kind = Kind::parts;
  std::string part;
  std::string other;  ///< an obstacle, or another part
  /// cm: of the deepest node or point in an obstacle; of two parts, of the shortest way apart that was found.
  double depth = 0.0;
  sim::Vec3 at = sim::Vec3::Zero();  ///< cm: the deepest place
  /// How to mend it: a move of the part that is named that frees the two from each other, cm, as short as was
  /// found. Nothing where the part is held in place, or none was found.
  struct Mend {
    std::string part;
    sim::Vec3 move = sim::Vec3::Zero();
    bool glued = false;  ///< others are glued to it, and move with it
  };
  std::optional<Mend> mend;
};

/// What begins inside an obstacle, and what parts overlap; the obstacles in their order, then pairs of parts.
/// Depths of less than a thousandth of a node's radius in an obstacle, and of two hundredths of a cell's edge
/// between parts, are rounding. Nothing is said of held nodes in obstacles, which feel nothing there, of
/// obstacles that are not active at the start, nor of parts that are glued to each other. Parts that hang
/// together by way of others overlap where they are deeper than a cell is wide.
///
/// Time: in proportion to nodes and obstacles, and to the cells of parts whose boxes meet. Empty when
/// `keepGoing`, asked now and then, says no.
std::vector<Overlap> findOverlaps(const BuiltScene& built, const std::function<bool()>& keepGoing = {});

/// Moves parts by what mends the overlaps, one after the other, each with all that hangs on it by glue; a
/// part that was moved already is left where it is. Gives how many of the overlaps were mended so. Where two
/// moves lead into each other, findOverlaps() says so afterwards.
std::size_t applyMends(const std::vector<Overlap>& overlaps, Scene& scene);

/// What a person should know, as a sentence without a full stop, and what to do, after a semicolon.
std::string sentence(const Overlap& overlap);

}  // namespace modeling
