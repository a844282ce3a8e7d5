#include "diagnose/rig/spatial_statics.hpp"

#include <algorithm>

#include "diagnose/bench/nominal_arm.hpp"
#include "diagnose/rig/substeps.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether a run reads orientations.
bool reads_turns(const Run& run) {
  const std::vector<Channel> measured = run.measured();
  return std::any_of(measured.begin(), measured.end(),
                     [](const Channel& channel) { return channel.name == Channel::Name::turn; });
}

/// By point: its orientation on the nominal arm.
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

}  // namespace

SpatialStatics::SpatialStatics(const Experiment& experiment, const Run& run, const Rig& rig,
                               const std::vector<Rig>& variations)
    : parts_(run.readings.size(), 1) {
  std::vector<const Rig*> rigs{&rig};
  for (const Rig& one : variations) rigs.push_back(&one);
  std::size_t contacts = 0;  // of each joint, the most that any of the rigs has
  for (const Rig* one : rigs) contacts = std::max(contacts, contact_count(*one));
  all_.reserve(rigs.size());
  for (const Rig* one : rigs) all_.emplace_back(experiment, *one, run, contacts);
  const auto remembers_any = [](const Rig* one) { return remembers(*one, contact_count(*one)); };
  if (std::any_of(rigs.begin(), rigs.end(), remembers_any) && turns_in_a_plane(experiment.arm->arm))
    parts_ = substeps(run, contacts, rig);
  if (reads_turns(run))
    for (const Reading& reading : run.readings) told_.push_back(told_orientations(experiment, reading));
}

bool SpatialStatics::arrive(const Stop& stop, const Passage& passage) {
  for (ArmTraveller& one : all_) one.head_for(stop, passage);
  if (!all_.front().settle()) return false;
  return std::all_of(all_.begin() + 1, all_.end(),
                     [&](ArmTraveller& other) { return other.settle_beside(all_.front()); });
}

void SpatialStatics::remember() {
  for (ArmTraveller& one : all_) one.remember();
}

void SpatialStatics::write(std::size_t beside, std::size_t reading, double /*direction*/,
                           Eigen::Ref<Eigen::ArrayXd> row) const {
  static const std::vector<Eigen::Matrix3d> none;
  all_[beside].write(row, told_.empty() ? none : told_[reading]);
}

}  // namespace plumbline::diagnose
