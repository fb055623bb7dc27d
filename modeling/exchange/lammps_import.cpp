#include "modeling/exchange/lammps_import.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Geometry>

#include "modeling/exchange/lammps_dump.h"
#include "modeling/exchange/lammps_moment.h"
#include "modeling/run/recording.h"
#include "sim/fracture/components.h"
#include "sim/kernel/bond_layout.h"

namespace modeling {

namespace {

using sim::Problem;

/// A whole bond is never longer than so many times the length at which it breaks, nor one that cannot break
/// than so many times its own: nodes that are, are those of other bonds.
constexpr double kMostStretch = 1.5;
constexpr double kMostUnbreakable = 10.0;

class Importer {
 public:
  Importer(const LammpsImport& from, const Scene& scene, const sim::Network& network)
      : from_(from),
        scene_(scene),
        network_(network),
        nodes_(from.dump, network.nodeCount(), lammpsNodeColumns()),
        layout_(network),
        components_(network, layout_) {
    broken_.bonds.assign(network.bondCount(), 0);
    broken_.cells.assign(network.cellCount(), 0);
    moment_.positions = network.positions;
    // Bonds that may break are there twice (LammpsModel).
    if (!from.bonds.empty()) bonds_ = std::make_unique<LammpsDumpReader>(from.bonds, 2 * network.bondCount());
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
    if (isFirst_) {
      if (auto status = checkStretch(**frame); !status) return status.problem();
    }
    isFirst_ = false;
    complete();
    return true;
  }

  sim::Status readNodes(const LammpsDumpFrame& frame) {
    auto read = readLammpsMoment(frame, from_.dump, moment_.positions);
    if (!read) return read.problem();
    if (read->time < moment_.time)
      return at(from_.dump, frame, 0, "the time goes back", "take the dump of one run");
    moment_.time = read->time;
    moment_.stepCount = frame.step;
    moment_.positions = std::move(read->positions);
    moment_.velocities = std::move(read->velocities);
    return isFirst_ && frame.step == 0 ? checkStart(frame) : sim::Status(sim::Done{});
  }

  /// Whether the nodes begin where the scene has them, as a whole: other programs number them otherwise. A
  /// run that goes on from a later frame begins with that frame's step.
  sim::Status checkStart(const LammpsDumpFrame& frame) const {
    const auto boxOf = [](const std::vector<Vec3>& places) {
      Eigen::AlignedBox3d box;
      for (const Vec3& place : places) box.extend(place);
      return box;
    };
    const Eigen::AlignedBox3d here = boxOf(network_.positions);
    const Eigen::AlignedBox3d there = boxOf(moment_.positions);
    const double apart = std::max((here.min() - there.min()).norm(), (here.max() - there.max()).norm());
    const double allowed = *std::max_element(network_.radii.begin(), network_.radii.end());
    if (apart <= std::max(allowed, 1e-6)) return sim::Done{};
    return at(from_.dump, frame, 0,
              "in step 0 the box around all nodes is " + std::to_string(apart) +
                  " cm from where the scene has it: this is the dump of another scene");
  }

  /// Of bonds that are whole in this moment.
  sim::Status checkStretch(const LammpsDumpFrame& frame) const {
    for (sim::NodeIndex a = 0; a < network_.nodeCount(); ++a) {
      for (sim::BondIndex bond = network_.firstBond[a]; bond < network_.firstBond[a + 1]; ++bond) {
        if (broken_.bonds[bond] != 0) continue;
        const sim::NodeIndex b = network_.bondEnds[bond];
        const double length = (moment_.positions[b] - moment_.positions[a]).norm();
        const auto threshold = static_cast<double>(network_.thresholds[bond]);
        const double most = std::isfinite(threshold) ? kMostStretch * (1.0 + threshold) : kMostUnbreakable;
        const double stretch = length / network_.bond(bond).restLength;
        if (stretch <= most) continue;
        return at(from_.dump, frame, 0,
                  "the bond between nodes " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                      " would be whole and " + std::to_string(stretch) +
                      " times as long as at rest: this is the dump of another scene" +
                      (bonds_ ? "" : ", or the dump of its bonds is missing"));
      }
    }
    return sim::Done{};
  }

  sim::Status readBonds(const LammpsDumpFrame& frame, std::uint64_t step) {
    if (frame.step != step || frame.columns.size() != 2)
      return at(from_.bonds, frame, 0, "this is not the moment of the nodes, or not two ids a row",
                "take both dumps from one run");
    std::vector<std::uint8_t> whole(network_.bondCount(), 0);
    for (std::size_t row = 0; row < frame.rows(); ++row) {
      const auto a = lammpsNode(frame.numbers[2 * row], network_.nodeCount());
      const auto b = lammpsNode(frame.numbers[2 * row + 1], network_.nodeCount());
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
  bool isFirst_ = true;
};

}  // namespace

sim::Result<std::size_t> importLammps(const LammpsImport& from, const Scene& scene,
                                      const sim::Network& network, const std::filesystem::path& take) {
  return Importer(from, scene, network).run(take);
}

}  // namespace modeling
