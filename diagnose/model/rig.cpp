#include "diagnose/model/rig.hpp"

#include <limits>
#include <plumbline/chain/kinematics.hpp>

namespace plumbline::diagnose {

Vector2 unloaded_end(const Experiment& experiment, const std::vector<double>& rest) {
  const Point<double> end =
      end_point(Chain<double>(experiment.link_length, experiment.joint_stiffness), rest);
  return {end.x, end.y};
}

Rig nominal_rig(const Experiment& experiment) {
  const std::size_t n = experiment.link_length.size();
  Rig rig;
  rig.length = experiment.link_length;
  rig.stiffness = experiment.joint_stiffness;
  rig.rest_error.assign(n, 0);
  rig.backlash.assign(n, 0);
  rig.stop.assign(n, std::numeric_limits<double>::infinity());
  rig.stop_stiffness.assign(n, 0);
  rig.weight.assign(n, Vector2::Zero());
  const Vector2 gravity(experiment.gravity[0], experiment.gravity[1]);
  for (std::size_t j = 0; j < n && j < experiment.link_mass.size(); ++j)
    rig.weight[j] = experiment.link_mass[j] * gravity;
  return rig;
}

}  // namespace plumbline::diagnose
