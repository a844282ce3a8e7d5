#include "diagnose/rig/rig.hpp"

#include <plumbline/chain/kinematics.hpp>

namespace plumbline::diagnose {

Vector2 unloaded_end(const Experiment& experiment, const std::vector<double>& rest) {
  if (experiment.alone != Alone::no) return {rest.front(), 0};
  const Point<double> end =
      end_point(Chain<double>(experiment.link_length, experiment.joint_stiffness), rest);
  return {end.x, end.y};
}

Rig in_run(const Rig& rig, std::size_t run) {
  Rig own = rig;
  if (run < rig.run_tare.size()) own.force_bias += rig.run_tare[run];
  if (run < rig.run_rest.size())
    for (std::size_t i = 0; i < own.rest_error.size(); ++i) own.rest_error[i] += rig.run_rest[run][i];
  own.run_rest.clear();
  own.run_tare.clear();
  return own;
}

}  // namespace plumbline::diagnose
