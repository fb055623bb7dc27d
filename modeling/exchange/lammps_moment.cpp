#include "modeling/exchange/lammps_moment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "modeling/text/spelling.h"

namespace modeling {

namespace {

using sim::Problem;
using sim::Vec3;

using Columns = std::array<std::size_t, 3>;

/// A way to state positions: names of columns are PREFIX x SUFFIX and so on.
struct PositionStyle {
  const char* suffix;
  bool scaled;
  bool unwrapped;
};
/// Those that leave no doubt come first.
constexpr std::array<PositionStyle, 4> kPositionStyles{
    {{"u", false, true}, {"su", true, true}, {"", false, false}, {"s", true, false}}};

/// LAMMPS' styles of units, in ours.
struct Units {
  std::string_view name;
  double length, time, velocity;  ///< cm, s, cm/s
};
constexpr std::array<Units, 8> kUnits{{{"lj", 1.0, 1.0, 1.0},
                                       {"cgs", 1.0, 1.0, 1.0},
                                       {"si", 1e2, 1.0, 1e2},
                                       {"real", 1e-8, 1e-15, 1e7},
                                       {"metal", 1e-8, 1e-12, 1e4},
                                       {"electron", 5.29177249e-9, 1e-15, 5.29177249e-9 / 1.03275e-15},
                                       {"micro", 1e-4, 1e-6, 1e2},
                                       {"nano", 1e-7, 1e-9, 1e2}}};

std::optional<Columns> columnsOf(const LammpsDumpFrame& frame, const std::string& prefix,
                                 const std::string& suffix) {
  Columns columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto found = frame.column(prefix + "xyz"[axis] + suffix);
    if (!found) return std::nullopt;
    columns[axis] = *found;
  }
  return columns;
}

class MomentReader {
 public:
  MomentReader(const LammpsDumpFrame& frame, const std::filesystem::path& file,
               const std::vector<Vec3>& before)
      : frame_(frame), file_(file), before_(before) {}

  sim::Result<LammpsMoment> read() {
    if (auto status = findColumns(); !status) return status.problem();
    if (auto status = findUnits(); !status) return status.problem();
    if (frame_.rows() != before_.size()) {
      return at(0, "there are " + std::to_string(frame_.rows()) + " nodes, and the scene has " +
                       std::to_string(before_.size()));
    }
    LammpsMoment moment;
    moment.time = units_.time * frame_.time.value_or(0.0);
    moment.positions.resize(before_.size());
    moment.velocities.resize(before_.size());
    std::vector<bool> seen(before_.size(), false);
    for (std::size_t row = 0; row < frame_.rows(); ++row) {
      const auto node = lammpsNode(number(row, id_), before_.size());
      if (!node || seen[*node]) return at(row, "this id is no node's, or was there before");
      seen[*node] = true;
      moment.positions[*node] = place(row, before_[*node]);
      moment.velocities[*node] = units_.velocity * vector(row, velocity_);
      if (!moment.positions[*node].allFinite() || !moment.velocities[*node].allFinite())
        return at(row, "this node is too far off for numbers to say where");
    }
    return moment;
  }

 private:
  Problem at(std::size_t row, std::string what,
             std::string remedy = "name the scene that the run was exported from") const {
    return {file_.string() + ":" + std::to_string(frame_.line + row) + ":1", std::move(what),
            std::move(remedy)};
  }

  double number(std::size_t row, std::size_t column) const {
    return frame_.numbers[row * frame_.columns.size() + column];
  }
  Vec3 vector(std::size_t row, const Columns& columns) const {
    return {number(row, columns[0]), number(row, columns[1]), number(row, columns[2])};
  }

  sim::Status findColumns() {
    const auto id = frame_.column("id");
    const auto velocity = columnsOf(frame_, "v", "");
    for (const PositionStyle& style : kPositionStyles) {
      const auto position = columnsOf(frame_, "", style.suffix);
      if (!position) continue;
      position_ = *position;
      style_ = style;
      found_ = true;
      break;
    }
    if (!id || !velocity || !found_) {
      return at(0, "the columns id, x, y, z (or xs, xu, xsu and so on), vx, vy and vz are needed",
                "dump them by dump custom, as the exported input does");
    }
    id_ = *id;
    velocity_ = *velocity;
    image_ = columnsOf(frame_, "i", "");
    if (style_.scaled && !frame_.box)
      return at(0, "positions are in parts of the box, and the dump does not state the box",
                "dump x, y and z, or xu, yu and zu");
    return sim::Done{};
  }

  sim::Status findUnits() {
    if (!frame_.units.empty()) {
      const auto known = std::find_if(kUnits.begin(), kUnits.end(),
                                      [&](const Units& units) { return units.name == frame_.units; });
      if (known == kUnits.end())
        return at(0, "the units " + inQuotes(frame_.units) + " are not known", "write the dump in cgs");
      units_ = *known;
    }
    const auto centimetres = frame_.column("v_cm");
    if (centimetres && frame_.rows() > 0) {
      const double unit = number(0, *centimetres);
      if (!(unit > 0.0)) return at(0, "v_cm is not above 0", "take the dump as LAMMPS left it");
      units_.length *= unit;
      units_.velocity *= unit;
    }
    if (!frame_.time && frame_.step > 0) {
      return at(0, "the dump does not state the time", "let LAMMPS write it: dump_modify ID time yes");
    }
    return sim::Done{};
  }

  Vec3 place(std::size_t row, const Vec3& before) const {
    Vec3 position = vector(row, position_);
    if (style_.scaled) position = frame_.box->origin + frame_.box->edges * position;
    if (!style_.unwrapped && frame_.box) {
      const LammpsBox& box = *frame_.box;
      if (image_)
        position += box.edges * vector(row, *image_);
      else
        position += box.wholeBoxes(before / units_.length - position, box.periodic);
    }
    return units_.length * position;
  }

  const LammpsDumpFrame& frame_;
  const std::filesystem::path& file_;
  const std::vector<Vec3>& before_;
  std::size_t id_ = 0;
  Columns position_{}, velocity_{};
  std::optional<Columns> image_;
  PositionStyle style_ = kPositionStyles[0];
  bool found_ = false;
  Units units_ = kUnits[0];
};

}  // namespace

std::vector<std::string> lammpsNodeColumns() {
  std::vector<std::string> names{"id", "v_cm"};
  for (const std::string axis : {"x", "y", "z"}) {
    for (const PositionStyle& style : kPositionStyles) names.push_back(axis + style.suffix);
    names.push_back("v" + axis);
    names.push_back("i" + axis);
  }
  return names;
}

std::optional<sim::NodeIndex> lammpsNode(double id, std::size_t nodes) {
  if (!(id >= 1.0) || id > static_cast<double>(nodes) || id != std::floor(id)) return std::nullopt;
  return static_cast<sim::NodeIndex>(id) - 1;
}

sim::Result<LammpsMoment> readLammpsMoment(const LammpsDumpFrame& frame, const std::filesystem::path& file,
                                           const std::vector<Vec3>& before) {
  return MomentReader(frame, file, before).read();
}

}  // namespace modeling
