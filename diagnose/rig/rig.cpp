#include "diagnose/rig/rig.hpp"

#include <algorithm>
#include <plumbline/chain/kinematics.hpp>

namespace plumbline::diagnose {

Vector2 unloaded_end(const Experiment& experiment, const std::vector<double>& rest) {
  if (!experiment.has_links()) return {rest.front(), 0};
  const Point<double> end =
      end_point(Chain<double>(experiment.link_length, experiment.joint_stiffness), rest);
  return {end.x, end.y};
}

bool Drive::is_exact() const {
  return response.is_prompt() && covariates.empty() &&
         std::all_of(drift.begin(), drift.end(), [](double one) { return one == 0; });
}

Vector3<double> Rig::seen(const Vector3<double>& place) const {
  const Vector3<double> skewed(place_skew.x() * place.y() + place_skew.y() * place.z(),
                               place_skew.z() * place.z(), 0);
  return (1 + place_scale) * place + skewed;
}

Rig in_run(const Rig& rig, std::size_t run) {
  Rig own = rig;
  if (run < rig.run_tare.size()) own.force_bias.head<2>() += rig.run_tare[run];
  if (run < rig.run_rest.size())
    for (std::size_t i = 0; i < own.rest_error.size(); ++i) own.rest_error[i] += rig.run_rest[run][i];
  own.run_rest.clear();
  own.run_tare.clear();
  return own;
}

void Rig::add_mass(std::size_t link, double kilograms, const Vector2& gravity) {
  if (arm)
    arm->arm.links[link].mass += kilograms;
  else
    weight[link] += kilograms * gravity;
}

void Rig::add_bar(std::size_t link, double kilograms, const Vector2& gravity) {
  if (arm)
    diagnose::add_mass(arm->arm.links[link], kilograms, arm->arm.far_end(link).translation() / 2);
  else if (const double before = weight[link].norm(); kilograms != 0) {
    weight[link] += kilograms * gravity;
    centre[link] *= before / weight[link].norm();
  }
}

void Rig::add_payload(double at_end, const Vector2& down) {
  if (!arm)
    payload += at_end * down;
  else if (!arm->arm.gravity.isZero(0))
    diagnose::add_mass(arm->arm.links.back(), at_end / arm->arm.gravity.norm(), arm->arm.tip.translation());
}

void Rig::scale_masses(double factor) {
  for (Vector2& one : weight) one *= factor;
  if (arm)
    for (ArmLink<double>& link : arm->arm.links) link.mass *= factor;
}

void Rig::scale_length(std::size_t link, double factor) {
  if (!arm) {
    length[link] *= factor;
    centre[link].x() *= factor;
    return;
  }
  SerialArm<double>& own = arm->arm;
  if (const Vector3<double> along = own.far_end(link).translation(); !along.isZero(0))
    own.links[link].centre += (factor - 1) * along.dot(own.links[link].centre) / along.squaredNorm() * along;
  if (link + 1 < own.size()) {
    own.links[link + 1].frame.translation() *= factor;
    return;
  }
  const OnLink<double> tip{link, own.tip};
  own.tip.translation() *= factor;
  for (OnLink<double>& point : arm->points)
    if (point == tip) point.frame = own.tip;
  if (arm->load == tip) arm->load.frame = own.tip;
}

void Rig::bend(double more) {
  if (!arm) flexibility += more;
  for (std::size_t j = 0; arm && j < length.size(); ++j) arm->bend(j, more);
}

void Rig::stretch(double more) {
  if (!arm) axial += more;
  for (std::size_t j = 0; arm && j < length.size(); ++j) arm->stretch(j, more);
}

}  // namespace plumbline::diagnose
