#include "diagnose/rig/traveller.hpp"

#include <cmath>
#include <numeric>

#include "diagnose/rig/load_cell.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {

Traveller::Traveller(const Experiment& experiment, const Rig& rig, const Run& run)
    : joints(rig, run),
      unloaded(unloaded_end(experiment, run.rest)),
      experiment_(&experiment),
      load_history_(experiment.loads, rig.length.size(), rig.moment_arm_error, rig.capstan_friction) {
  if (rig.compensated != 0) nominal_centre_ = nominal_rig(experiment).centre;
}

const Imposed& Traveller::impose(const Run& run, const Reading& reading, double growing) {
  imposed = {run.control, at_end(run, reading, growing), load_history_.next(reading.covariates)};
  if (joints.rig().compensated != 0) hold_weight(run.rest_at(reading), imposed.loads.moment);
  return imposed;
}

void Traveller::hold_weight(const std::vector<double>& commanded, std::vector<double>& moment) const {
  moment.resize(commanded.size(), 0);
  double theta = std::accumulate(commanded.begin(), commanded.end(), 0.0), torque = 0;
  const Vector2 gravity(experiment_->gravity[0], experiment_->gravity[1]);
  Vector2 beyond = Vector2::Zero();  // weight of the links beyond
  for (std::size_t i = commanded.size(); i-- > 0;) {
    const Vector2 along(std::cos(theta), std::sin(theta)), across(-along.y(), along.x()),
        own = experiment_->link_mass[i] * gravity, off = nominal_centre_[i];
    torque += experiment_->link_length[i] * across.dot(beyond + own / 2) +
              own.dot(off.x() * across - off.y() * along);
    moment[i] -= joints.rig().compensated * torque;
    beyond += own;
    theta -= commanded[i];
  }
}

Vector2 Traveller::felt_force(double t, double direction) const {
  const Rig& rig = joints.rig();
  const Vector2 force(posture.force.x, posture.force.y);
  Vector2 felt = shown_by_cell(rig, turned(force, -rig.misalignment)) + zero_of_cell(rig, t);
  felt.x() += rig.guide_friction * direction;
  return felt;
}

Vector2 Traveller::load_on_second(const Run& run) const {
  const Vector2 force = run.holds_end_point() ? Vector2(posture.force.x, posture.force.y) : imposed.value;
  return turned(force, -joints.rig().misalignment);
}

void Traveller::remember(const Layout& layout) {
  joints.remember([&](std::size_t i) { return layout.joint_angle(posture.angle, i); },
                  [&](std::size_t i) { return posture.contact.data() + layout.contact(i, 0); });
}

/// The true end point or force.
Vector2 Traveller::at_end(const Run& run, const Reading& reading, double growing) const {
  const Rig& rig = joints.rig();
  if (run.holds_end_point())
    return unloaded + (1 + rig.drive.gain) * turned(run.imposed_at(reading) - unloaded, rig.misalignment) +
           rig.frame_at(reading.t).head<2>();
  const double passed = rig.pulley_friction == 0 ? 1 : std::exp(-rig.pulley_friction * growing);
  if (run.by_weights) return turned(passed * run.imposed_at(reading), rig.misalignment);
  const Vector2 read = run.imposed_at(reading) - zero_of_cell(rig, reading.t);
  return turned(passed * force_on_cell(rig, read), rig.misalignment);
}

}  // namespace plumbline::diagnose
