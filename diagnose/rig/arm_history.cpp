#include "diagnose/rig/arm_history.hpp"

#include <algorithm>
#include <limits>

#include "diagnose/bench/nominal_arm.hpp"
#include "diagnose/rig/arm_traveller.hpp"

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

}  // namespace

Eigen::Index columns_of_arm(const Experiment& experiment) {
  return Channel(Channel::Name::place, 3 * experiment.arm_bench.points.size(), experiment.arm->arm.size())
      .column;
}

bool walk_arm(const Experiment& experiment, const Run& run, const Rig& rig,
              const std::vector<Rig>& variations, Trace& trace, const std::vector<Trace*>& beside) {
  std::size_t sliders = contact_count(rig);
  for (const Rig& one : variations) sliders = std::max(sliders, contact_count(one));
  ArmTraveller main(experiment, rig, run, sliders);
  std::vector<ArmTraveller> others;
  others.reserve(variations.size());
  for (const Rig& one : variations) others.emplace_back(experiment, one, run, sliders);
  Eigen::ArrayXd row = Eigen::ArrayXd::Constant(trace.cols(), std::numeric_limits<double>::quiet_NaN()),
                 other = row;
  const bool turns = reads_turns(run);
  std::vector<Eigen::Matrix3d> told;
  for (std::size_t r = 0; r < run.readings.size(); ++r) {
    const auto at = static_cast<Eigen::Index>(r);
    if (turns) told = told_orientations(experiment, run.readings[r]);
    main.head_for(r);
    if (!main.settle()) return false;
    main.write(row, told);
    trace.row(at) = row.transpose();
    for (std::size_t p = 0; p < others.size(); ++p) {
      others[p].head_for(r);
      if (!others[p].settle_beside(main)) return false;
      others[p].write(other, told);
      beside[p]->row(at) = (other - row).transpose();
      others[p].remember();
    }
    main.remember();
  }
  return true;
}

}  // namespace plumbline::diagnose
