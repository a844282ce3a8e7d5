#include "diagnose/model/rig.hpp"

#include "diagnose/model/nominal.hpp"

namespace plumbline::diagnose {

namespace {

/// Weight of each link.
std::vector<Point<double>> weights(const Experiment& experiment) {
  std::vector<Point<double>> weight;
  for (const double mass : experiment.link_mass)
    weight.push_back({mass * experiment.gravity[0], mass * experiment.gravity[1]});
  return weight;
}

}  // namespace

Vector2 unloaded_end(const Experiment& experiment, const std::vector<double>& rest) {
  const Point<double> end =
      end_point(Chain<double>(experiment.link_length, experiment.joint_stiffness), rest);
  return {end.x, end.y};
}

NominalModel<double> nominal_model(const Experiment& experiment, const std::vector<double>& rest) {
  return NominalModel<double>(Chain<double>(experiment.link_length, experiment.joint_stiffness, rest),
                              weights(experiment));
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

Rig nominal_rig(const Experiment& experiment) {
  const std::size_t n = experiment.link_length.size();
  Rig rig;
  rig.length = experiment.link_length;
  rig.stiffness = experiment.joint_stiffness;
  rig.rest_error.assign(n, 0);
  rig.backlash.assign(n, 0);
  rig.stop.assign(n, std::numeric_limits<double>::infinity());
  rig.stop_stiffness.assign(n, 0);
  rig.hardening.assign(n, 0);
  rig.friction.assign(n, 0);
  rig.sliders.resize(n);
  for (const Point<double>& weight : weights(experiment)) rig.weight.emplace_back(weight.x, weight.y);
  rig.weight.resize(n, Vector2::Zero());
  return rig;
}

}  // namespace plumbline::diagnose
