#include "diagnose/rig/arm_history.hpp"

#include <algorithm>
#include <limits>

#include "diagnose/rig/arm_traveller.hpp"

namespace plumbline::diagnose {
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
  for (std::size_t r = 0; r < run.readings.size(); ++r) {
    const auto at = static_cast<Eigen::Index>(r);
    main.head_for(r);
    if (!main.settle()) return false;
    if (!others.empty()) main.prepare();
    main.write(row);
    trace.row(at) = row.transpose();
    for (std::size_t p = 0; p < others.size(); ++p) {
      others[p].head_for(r);
      if (!others[p].settle_beside(main)) return false;
      others[p].write(other);
      beside[p]->row(at) = (other - row).transpose();
      others[p].remember();
    }
    main.remember();
  }
  return true;
}

}  // namespace plumbline::diagnose
