#include <cmath>
#include <map>

#include "modeling/exchange/export.h"
#include "modeling/exchange/frame_loop.h"
#include "modeling/exchange/rigid_fit.h"
#include "modeling/text/text_output.h"
#include "sim/base/spin.h"

namespace modeling {

namespace {

constexpr const char* kStateNames[] = {"deforming", "rigid", "asleep"};

void addVector(const Vec3& vector, TextOutput& out) {
  for (const double number : vector) out << "," << number;
}

void addId(std::uint32_t id, TextOutput& out) {
  if (id != sim::kNone) out << std::uint64_t{id};
}

/// How a fragment turns: L = I omega about its centre of mass. Held nodes, whose mass is infinite, count as
/// if all nodes weighed the same; what its nodes leave open (a line, a point) is 0.
Vec3 angularVelocity(const FinalFragment& fragment, const sim::Network& network, const sim::Snapshot& frame) {
  // By rounding, the mean of one place is not that place.
  if (fragment.nodes.size() == 1) return Vec3::Zero();
  const bool held = !std::isfinite(fragment.fragment.mass);
  const auto massOf = [&](sim::NodeIndex node) { return held ? 1.0 : network.masses[node]; };
  double mass = 0.0;
  Vec3 centre = Vec3::Zero(), velocity = Vec3::Zero();
  for (const sim::NodeIndex node : fragment.nodes) {
    mass += massOf(node);
    centre += massOf(node) * frame.positions[node];
    velocity += massOf(node) * frame.velocities[node];
  }
  centre /= mass;
  velocity /= mass;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vec3 momentum = Vec3::Zero();
  for (const sim::NodeIndex node : fragment.nodes) {
    const Vec3 arm = frame.positions[node] - centre;
    inertia += massOf(node) * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    momentum += massOf(node) * arm.cross(frame.velocities[node] - velocity);
  }
  return sim::spinOf(inertia, momentum);
}

class FragmentTable {
 public:
  FragmentTable(const std::filesystem::path& path, const sim::Network& network, const sim::Snapshot& first)
      : network_(network), first_(first), out_(path) {
    out_ << "frame,time_s,fragment,parent,birth_time_s,nodes,mass_g,state,x_cm,y_cm,z_cm,qw,qx,qy,qz,"
            "vx_cm_per_s,vy_cm_per_s,vz_cm_per_s,wx_rad_per_s,wy_rad_per_s,wz_rad_per_s\n";
  }

  sim::Status add(std::size_t index, const sim::Snapshot& frame) {
    for (const FinalFragment& fragment : finalFragments(first_, frame)) addRow(index, frame, fragment);
    return out_.good() ? sim::Status(sim::Done{}) : out_.finish();
  }

  sim::Status finish() { return out_.finish(); }

 private:
  void addRow(std::size_t index, const sim::Snapshot& frame, const FinalFragment& fragment) {
    const sim::Fragment& of = fragment.fragment;
    out_ << std::uint64_t{index} << "," << frame.time << "," << std::uint64_t{of.id} << ",";
    addId(of.parent, out_);
    out_ << "," << of.born << "," << std::uint64_t{of.nodeCount} << "," << of.mass << ","
         << kStateNames[static_cast<std::size_t>(fragment.moving.state)];
    addVector(fragment.moving.centre, out_);
    const Eigen::Quaterniond& turn = turnOf(frame, fragment);
    out_ << "," << turn.w() << "," << turn.x() << "," << turn.y() << "," << turn.z();
    addVector(fragment.moving.velocity, out_);
    addVector(angularVelocity(fragment, network_, frame), out_);
    out_ << "\n";
  }

  const Eigen::Quaterniond& turnOf(const sim::Snapshot& frame, const FinalFragment& fragment) {
    Vec3 mean = Vec3::Zero();
    for (const sim::NodeIndex node : fragment.nodes) mean += frame.positions[node];
    mean /= static_cast<double>(fragment.nodes.size());
    std::vector<Vec3> from, to;
    for (const sim::NodeIndex node : fragment.nodes) {
      from.push_back(first_.positions[node] - fragment.origin);
      to.push_back(frame.positions[node] - mean);
    }
    Eigen::Quaterniond& turn =
        turns_.try_emplace(fragment.fragment.id, Eigen::Quaterniond::Identity()).first->second;
    return turn = bestRotation(from, to, turn);
  }

  const sim::Network& network_;
  const sim::Snapshot& first_;
  TextOutput out_;
  std::map<sim::FragmentId, Eigen::Quaterniond> turns_;
};

void addLedger(std::size_t index, const sim::LedgerRow& row, TextOutput& out) {
  const sim::Energy& energy = row.energy;
  out << std::uint64_t{index} << "," << row.time << "," << row.step;
  for (const double number : {energy.kinetic, energy.elastic, energy.gravity, energy.contact,
                              energy.dissipated, energy.released, energy.outsideWork, energy.residual})
    out << "," << number;
  addVector(row.linearMomentum, out);
  addVector(row.angularMomentum, out);
  out << "\n";
}

void addEvent(std::size_t index, const sim::BreakEvent& event, TextOutput& out) {
  out << std::uint64_t{index} << "," << event.time << "," << std::uint64_t{event.bond} << ","
      << std::uint64_t{event.a} << "," << std::uint64_t{event.b} << "," << static_cast<double>(event.strain)
      << ",";
  addId(event.cell, out);
  out << "\n";
}

}  // namespace

sim::Status writeCsv(const sim::TakeReader& take, const ExportRequest& request) {
  const auto first = take.frame(request.firstFrame);
  if (!first) return first.problem();
  FragmentTable fragments(request.path, take.network(), **first);
  TextOutput events(sideTable(request.path, "events"));
  TextOutput ledger(sideTable(request.path, "ledger"));
  events << "frame,time_s,bond,node_a,node_b,strain,cell\n";
  ledger << "frame,time_s,step_s,kinetic_erg,elastic_erg,gravity_erg,contact_erg,dissipated_erg,released_erg,"
            "outside_work_erg,residual_erg,px_g_cm_per_s,py_g_cm_per_s,pz_g_cm_per_s,lx_g_cm2_per_s,"
            "ly_g_cm2_per_s,lz_g_cm2_per_s\n";
  const auto status =
      forEachFrame(take, request, [&](std::size_t index, const sim::Snapshot& frame) -> sim::Status {
        const auto breaks = take.eventsOf(index);
        if (!breaks) return breaks.problem();
        for (const sim::BreakEvent& event : *breaks) addEvent(index, event, events);
        addLedger(index, frame.ledger, ledger);
        return fragments.add(index, frame);
      });
  if (!status) return status;
  if (auto done = events.finish(); !done) return done;
  if (auto done = ledger.finish(); !done) return done;
  return fragments.finish();
}

}  // namespace modeling
