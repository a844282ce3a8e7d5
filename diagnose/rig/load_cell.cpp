#include "diagnose/rig/load_cell.hpp"

#include <Eigen/LU>
#include <cmath>

namespace plumbline::diagnose {
namespace {

Eigen::Matrix2d cross_talk(const Rig& rig) {
  Eigen::Matrix2d mixed;
  mixed << 1, rig.cross_talk.x(), rig.cross_talk.y(), 1;
  return mixed;
}

}  // namespace

Vector2 turned(const Vector2& v, double angle) {
  if (angle == 0) return v;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Vector2 zero_of_cell(const Rig& rig, double t) {
  return rig.force_bias.head<2>() + rig.force_drift.head<2>() * t;
}

Vector2 shown_by_cell(const Rig& rig, const Vector2& force) {
  const Vector2 mixed = cross_talk(rig) * force;
  return (1 + rig.force_gain) * (mixed + rig.cell_curvature.cwiseProduct(mixed.cwiseAbs2()));
}

Vector2 force_on_cell(const Rig& rig, const Vector2& shown) {
  const Vector2 bent = shown / (1 + rig.force_gain);
  const Vector2 root = (1 + 4 * rig.cell_curvature.array() * bent.array()).max(0).sqrt();
  const Vector2 mixed = 2 * bent.array() / (1 + root.array());
  return cross_talk(rig).inverse() * mixed;
}

Response response_of_cell(const Rig& rig) {
  return rig.sensors.response(Channel::Name::Fx);
}

}  // namespace plumbline::diagnose
