#include "diagnose/rig/arm_history.hpp"

#include <algorithm>
#include <limits>

#include "diagnose/bench/nominal_arm.hpp"
#include "diagnose/rig/arm_traveller.hpp"
#include "diagnose/rig/substeps.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether a run reads orientations.
bool reads_turns(const Run& run) {
  const std::vector<Channel> measured = run.measured();
  return std::any_of(measured.begin(), measured.end(),
                     [](const Channel& channel) { return channel.name == Channel::Name::turn; });
}

/// By point: its orientation on the nominal arm, by which that of a reading is told.
std::vector<Eigen::Matrix3d> told_orientations(const Experiment& experiment, const Reading& reading) {
  std::vector<Eigen::Matrix3d> all;
  for (const MeasuredPoint& point : experiment.arm_bench.points)
    all.push_back(nominal_pose(experiment.arm->arm, point.at, reading.rest).linear());
  return all;
}

/// Whether the arm is a chain in a plane: all joints turn about one direction.
bool turns_in_a_plane(const SerialArm<double>& arm) {
  constexpr double rounding = 1e-9;
  Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
  const Vector3<double> first = arm.links.front().frame.linear() * arm.links.front().axis;
  return std::all_of(arm.links.begin(), arm.links.end(), [&](const ArmLink<double>& link) {
    turned *= link.frame.linear();
    return link.kind == JointKind::revolute && first.cross(turned * link.axis).norm() < rounding;
  });
}

/// An arm along one run, with its variations beside it. Between poses in space its way is that of a planner
/// that nobody tells: it goes there in one step. In a plane it goes as a chain does.
class ArmWalk {
 public:
  ArmWalk(const Experiment& experiment, const Run& run, const Rig& rig, const std::vector<Rig>& variations)
      : ArmWalk(experiment, run, rig, variations, most_contacts(rig, variations)) {}

  bool walk(Trace& trace, const std::vector<Trace*>& beside) {
    Eigen::ArrayXd row = Eigen::ArrayXd::Constant(trace.cols(), std::numeric_limits<double>::quiet_NaN()),
                   other = row;
    const bool turns = reads_turns(run_);
    std::vector<Eigen::Matrix3d> told;
    for (std::size_t r = 0; r < run_.readings.size(); ++r) {
      const auto at = static_cast<Eigen::Index>(r);
      if (turns) told = told_orientations(experiment_, run_.readings[r]);
      if (!follow(r) || !arrive({run_.readings[r], last_, r})) return false;
      main_.write(row, told);
      trace.row(at) = row.transpose();
      for (std::size_t p = 0; p < beside_.size(); ++p) {
        beside_[p].write(other, told);
        beside[p]->row(at) = (other - row).transpose();
      }
      remember();
      last_ = r;
    }
    return true;
  }

 private:
  /// \param contacts  of each joint, the most that any of the rigs has
  ArmWalk(const Experiment& experiment, const Run& run, const Rig& rig, const std::vector<Rig>& variations,
          std::size_t contacts)
      : experiment_(experiment), run_(run), main_(experiment, rig, run, contacts) {
    beside_.reserve(variations.size());
    for (const Rig& one : variations) beside_.emplace_back(experiment, one, run, contacts);
    const auto remembers_any = [&](const Rig& one) { return remembers(one, contact_count(one)); };
    if (turns_in_a_plane(experiment.arm->arm) &&
        (remembers_any(rig) || std::any_of(variations.begin(), variations.end(), remembers_any)))
      parts_ = substeps(run, contacts, rig);
    else
      parts_.assign(run.readings.size(), 1);
  }

  static std::size_t most_contacts(const Rig& rig, const std::vector<Rig>& variations) {
    std::size_t most = contact_count(rig);
    for (const Rig& one : variations) most = std::max(most, contact_count(one));
    return most;
  }

  /// The way to a reading.
  bool follow(std::size_t r) {
    for (std::size_t part = 1; last_ && part < parts_[r]; ++part) {
      const double share = static_cast<double>(part) / static_cast<double>(parts_[r]);
      if (!arrive({between(run_.readings[*last_], run_.readings[r], share), last_, r, share})) return false;
      remember();
    }
    return true;
  }

  bool arrive(const Stop& stop) {
    main_.head_for(stop);
    if (!main_.settle()) return false;
    return std::all_of(beside_.begin(), beside_.end(), [&](ArmTraveller& other) {
      other.head_for(stop);
      return other.settle_beside(main_);
    });
  }

  void remember() {
    main_.remember();
    for (ArmTraveller& other : beside_) other.remember();
  }

  const Experiment& experiment_;
  const Run& run_;
  ArmTraveller main_;
  std::vector<ArmTraveller> beside_;
  std::vector<std::size_t> parts_;   ///< number of substeps to each reading
  std::optional<std::size_t> last_;  ///< reading
};

}  // namespace

Eigen::Index columns_of_arm(const Experiment& experiment) {
  const ArmBench& bench = experiment.arm_bench;
  return Channel::of_sensor(Channel::Name::distance, bench.sensors.size(), 0, experiment.arm->arm.size(),
                            bench.points.size())
      .column;
}

bool walk_arm(const Experiment& experiment, const Run& run, const Rig& rig,
              const std::vector<Rig>& variations, Trace& trace, const std::vector<Trace*>& beside) {
  return ArmWalk(experiment, run, rig, variations).walk(trace, beside);
}

}  // namespace plumbline::diagnose
