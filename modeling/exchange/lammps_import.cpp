#include "modeling/exchange/lammps_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "modeling/exchange/lammps_dump.h"
#include "modeling/run/recording.h"
#include "sim/fracture/components.h"
#include "sim/kernel/bond_layout.h"

namespace modeling {

namespace {

using sim::Problem;

/// Where the columns of nodes stand.
struct NodeColumns {
  std::size_t id = 0;
  std::array<std::size_t, 3> position{}, velocity{};
};

class Importer {
 public:
  Importer(const LammpsImport& from, const Scene& scene, const sim::Network& network)
      : from_(from),
        scene_(scene),
        network_(network),
        nodes_(from.dump, network.nodeCount()),
        layout_(network),
        components_(network, layout_) {
    broken_.bonds.assign(network.bondCount(), 0);
    broken_.cells.assign(network.cellCount(), 0);
    if (!from.bonds.empty()) bonds_ = std::make_unique<LammpsDumpReader>(from.bonds, network.bondCount());
  }

  sim::Result<std::size_t> run(const std::filesystem::path& path) {
    std::unique_ptr<sim::TakeWriter> take;
    std::size_t frames = 0;
    while (true) {
      auto more = nextMoment();
      if (more && *more && !take) {
        auto created = createTake(path, scene_, network_);
        if (!created) return created.problem();
        take = std::move(*created);
      }
      if (!more) {
        if (take) static_cast<void>(take->finish(more.problem().line()));
        return more.problem();
      }
      if (!*more) break;
      if (auto status = take->appendFrame(moment_, events_); !status) return status.problem();
      ++frames;
      if (from_.progress && !from_.progress(frames))
        return Problem{path.string(), "the import was cancelled", ""};
    }
    if (!take) return Problem{from_.dump.string(), "there is no moment in this dump", "let LAMMPS run first"};
    if (auto status = take->finish("done"); !status) return status.problem();
    return frames;
  }

 private:
  Problem at(const std::filesystem::path& file, const LammpsDumpFrame& frame, std::size_t row,
             std::string what, std::string remedy = "name the scene that the run was exported from") const {
    return {file.string() + ":" + std::to_string(frame.line + row) + ":1", std::move(what),
            std::move(remedy)};
  }

  sim::Result<bool> nextMoment() {
    const auto frame = nodes_.next();
    if (!frame) return frame.problem();
    if (!*frame) return false;
    if (auto status = readNodes(**frame); !status) return status.problem();
    events_.clear();
    if (bonds_) {
      const auto pairs = bonds_->next();
      if (!pairs) return pairs.problem();
      if (*pairs) {
        if (auto status = readBonds(**pairs, (*frame)->step); !status) return status.problem();
      }
    }
    complete();
    return true;
  }

  sim::Result<NodeColumns> columnsOf(const LammpsDumpFrame& frame) const {
    NodeColumns columns;
    const auto find = [&](const std::string& name, std::size_t& where) {
      const auto found = frame.column(name);
      if (found) where = *found;
      return found.has_value();
    };
    bool all = find("id", columns.id);
    const std::array<std::string, 3> axes{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all = find(axes[axis], columns.position[axis]) && all;
      all = find("v" + axes[axis], columns.velocity[axis]) && all;
    }
    if (!all)
      return at(from_.dump, frame, 0, "the columns id, x, y, z, vx, vy and vz are needed",
                "dump them by dump custom, as the exported input does");
    return columns;
  }

  sim::Status readNodes(const LammpsDumpFrame& frame) {
    const auto columns = columnsOf(frame);
    if (!columns) return columns.problem();
    if (frame.rows() != network_.nodeCount()) {
      return at(from_.dump, frame, 0,
                "there are " + std::to_string(frame.rows()) + " nodes, and the scene has " +
                    std::to_string(network_.nodeCount()));
    }
    std::vector<std::uint8_t> seen(network_.nodeCount(), 0);
    std::vector<Vec3> positions(network_.nodeCount()), velocities(network_.nodeCount());
    for (std::size_t row = 0; row < frame.rows(); ++row) {
      const double* const numbers = &frame.numbers[row * frame.columns.size()];
      const auto node = nodeOf(numbers[columns->id]);
      if (!node || seen[*node] != 0)
        return at(from_.dump, frame, row, "this id is no node's, or was there before");
      seen[*node] = 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        positions[*node][static_cast<Eigen::Index>(axis)] = numbers[columns->position[axis]];
        velocities[*node][static_cast<Eigen::Index>(axis)] = numbers[columns->velocity[axis]];
      }
    }
    if (!frame.time && frame.step > 0) {
      return at(from_.dump, frame, 0, "the dump does not state the time",
                "let LAMMPS write it: dump_modify ID time yes");
    }
    const double time = frame.time.value_or(0.0);
    if (time < moment_.time)
      return at(from_.dump, frame, 0, "the time goes back", "take the dump of one run");
    moment_.time = time;
    moment_.stepCount = frame.step;
    moment_.positions = std::move(positions);
    moment_.velocities = std::move(velocities);
    return sim::Done{};
  }

  std::optional<sim::NodeIndex> nodeOf(double id) const {
    if (!(id >= 1.0) || id > static_cast<double>(network_.nodeCount()) || id != std::floor(id))
      return std::nullopt;
    return static_cast<sim::NodeIndex>(id) - 1;
  }

  sim::Status readBonds(const LammpsDumpFrame& frame, std::uint64_t step) {
    if (frame.step != step || frame.columns.size() != 2)
      return at(from_.bonds, frame, 0, "this is not the moment of the nodes, or not two ids a row",
                "take both dumps from one run");
    std::vector<std::uint8_t> whole(network_.bondCount(), 0);
    for (std::size_t row = 0; row < frame.rows(); ++row) {
      const auto a = nodeOf(frame.numbers[2 * row]);
      const auto b = nodeOf(frame.numbers[2 * row + 1]);
      const sim::BondIndex bond = a && b && *a != *b ? network_.findBond(*a, *b) : sim::kNone;
      if (bond == sim::kNone) return at(from_.bonds, frame, row, "the scene has no bond between these");
      whole[bond] = 1;
    }
    for (sim::BondIndex bond = 0; bond < network_.bondCount(); ++bond) {
      if (whole[bond] == 0 && broken_.bonds[bond] == 0) breakBond(bond);
    }
    return sim::Done{};
  }

  void breakBond(sim::BondIndex bond) {
    const sim::NodeIndex a = network_.bondStart(bond);
    const sim::NodeIndex b = network_.bondEnds[bond];
    const double length = (moment_.positions[b] - moment_.positions[a]).norm();
    broken_.bonds[bond] = 1;
    layout_.remove(network_, bond);
    events_.push_back({.time = moment_.time,
                       .bond = bond,
                       .a = a,
                       .b = b,
                       .strain = static_cast<float>(length / network_.bond(bond).restLength - 1.0)});
  }

  /// A cell two of whose corners have lost their bond is broken.
  void breakCells() {
    std::vector<std::uint8_t> touched(network_.nodeCount(), 0);
    for (const sim::BreakEvent& event : events_) touched[event.a] = touched[event.b] = 1;
    for (sim::CellIndex cell = 0; cell < network_.cellCount(); ++cell) {
      const sim::CellCorners& corners = network_.cells[cell];
      if (std::none_of(corners.begin(), corners.end(),
                       [&](sim::NodeIndex node) { return touched[node] != 0; }))
        continue;
      for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = i + 1; j < 8; ++j) {
          const sim::BondIndex bond = network_.findBond(corners[i], corners[j]);
          if (bond != sim::kNone && broken_.bonds[bond] != 0) broken_.cells[cell] = 1;
        }
      }
    }
  }

  void complete() {
    if (!events_.empty()) {
      breakCells();
      components_.relabel(layout_, events_, moment_.time);
    }
    if (!events_.empty() || moment_.broken == sim::nothingBroken()) {
      broken_.fragmentOfNode = components_.fragmentOfNode();
      broken_.fragments = sim::describeFragments(network_, components_);
      moment_.broken = sim::sealed(broken_);
    }
    moment_.fragments = sim::describeMotion(network_, moment_);
    moment_.ledger = ledger();
  }

  sim::LedgerRow ledger() const {
    sim::LedgerRow row;
    row.time = moment_.time;
    for (std::size_t node = 0; node < network_.nodeCount(); ++node) {
      const double mass = network_.masses[node];
      if (!std::isfinite(mass)) continue;
      const Vec3& velocity = moment_.velocities[node];
      row.energy.kinetic += 0.5 * mass * velocity.squaredNorm();
      row.energy.gravity -=
          mass * scene_.environment.gravity.dot(moment_.positions[node] - network_.positions[node]);
      row.linearMomentum += mass * velocity;
      row.angularMomentum += mass * moment_.positions[node].cross(velocity);
    }
    for (sim::NodeIndex a = 0; a < network_.nodeCount(); ++a) {
      for (sim::BondIndex b = network_.firstBond[a]; b < network_.firstBond[a + 1]; ++b) {
        if (broken_.bonds[b] != 0) continue;
        const sim::BondClass& bond = network_.bond(b);
        const double stretch =
            (moment_.positions[network_.bondEnds[b]] - moment_.positions[a]).norm() - bond.restLength;
        row.energy.elastic += 0.5 * bond.stiffness * stretch * stretch;
      }
    }
    return row;
  }

  const LammpsImport& from_;
  const Scene& scene_;
  const sim::Network& network_;
  LammpsDumpReader nodes_;
  std::unique_ptr<LammpsDumpReader> bonds_;
  sim::BondLayout layout_;
  sim::Components components_;
  sim::Snapshot moment_;
  sim::Broken broken_;  ///< of the moment, while it is being read
  std::vector<sim::BreakEvent> events_;
};

}  // namespace

sim::Result<std::size_t> importLammps(const LammpsImport& from, const Scene& scene,
                                      const sim::Network& network, const std::filesystem::path& take) {
  return Importer(from, scene, network).run(take);
}

}  // namespace modeling
