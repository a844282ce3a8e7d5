#include "trial/simulator/passive_force.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace plumbline::simulator {
namespace {

void push(const mjModel& model, mjData& data, int body, const std::array<mjtNum, 3>& at, double x, double y) {
  const std::array<mjtNum, 3> force{x, y, 0}, torque{0, 0, 0};
  mj_applyFT(&model, &data, force.data(), torque.data(), at.data(), body, data.qfrc_passive);
}

}  // namespace

PassiveForce::PassiveForce(const Plan& plan, const Physics& physics, const PlannedRun& run,
                           const mjModel& model, double response)
    : physics_(physics), pivot_(plan.typical_stiffness() / static_cast<double>(plan.size()), response) {
  const double interval = run.commands.at(1).t - run.commands.at(0).t;
  for (std::size_t j = 0; j < run.rest.size(); ++j) {
    const int joint = mj_name2id(&model, mjOBJ_JOINT, ("q" + std::to_string(j + 1)).c_str());
    position_.push_back(model.jnt_qposadr[joint]);
    velocity_.push_back(model.jnt_dofadr[joint]);
    rest_.push_back(rest_angle(physics, run, j));
    law_.emplace_back(physics.joint[j], response, interval);
  }
}

void PassiveForce::begin_history() {
  relaxed_ = false;
  for (JointLaw& law : law_) law.begin_history();
}

std::vector<double> PassiveForce::deflections(const mjData& data) const {
  std::vector<double> d(rest_.size());
  for (std::size_t j = 0; j < d.size(); ++j) d[j] = data.qpos[position_[j]] - rest_[j];
  return d;
}

void PassiveForce::remember(const mjData& data, double dt) {
  const std::vector<double> d = deflections(data);
  for (std::size_t j = 0; j < d.size(); ++j) law_[j].remember(d[j], dt);
  const double turned = std::accumulate(d.begin(), d.end(), 0.0);
  if (!relaxed_ && physics_.pivot_friction > 0) pivot_.follow(turned - turned_, physics_.pivot_friction);
  turned_ = turned;
}

void PassiveForce::add_to(const mjModel& model, mjData& data) const {
  const std::vector<double> d = deflections(data);
  double pivot = 0;
  if (!relaxed_ && physics_.pivot_friction > 0) {
    double rate = 0;
    for (const int address : velocity_) rate += data.qvel[address];
    pivot = pivot_.torque(rate);
  }
  for (std::size_t j = 0; j < d.size(); ++j) {
    const double neighbours = (j > 0 ? d[j - 1] : 0) + (j + 1 < d.size() ? d[j + 1] : 0);
    data.qfrc_passive[velocity_[j]] +=
        law_[j].torque(d[j], data.qvel[velocity_[j]]) + physics_.coupling * neighbours + pivot;
  }
  if (physics_.magnet.strength != 0) add_magnet(model, data);
  if (physics_.wall.stiffness > 0) add_wall(model, data);
}

void PassiveForce::add_magnet(const mjModel& model, mjData& data) const {
  const Magnet& magnet = physics_.magnet;
  const int end = mj_name2id(&model, mjOBJ_SITE, "end");
  const mjtNum* at = data.site_xpos + 3 * static_cast<std::ptrdiff_t>(end);
  const double x = magnet.place[0] - at[0], y = magnet.place[1] - at[1];
  const double pull = magnet.strength * std::exp(-(x * x + y * y) / (2 * magnet.width * magnet.width));
  push(model, data, model.site_bodyid[end], {at[0], at[1], 0}, pull * x, pull * y);
}

void PassiveForce::add_wall(const mjModel& model, mjData& data) const {
  const Wall& wall = physics_.wall;
  const int body = mj_name2id(&model, mjOBJ_BODY, ("link" + std::to_string(wall.link + 1)).c_str());
  const mjtNum *at = data.xpos + 3 * static_cast<std::ptrdiff_t>(body),
               *frame = data.xmat + 9 * static_cast<std::ptrdiff_t>(body);
  const double half = physics_.length[wall.link] / 2;
  const std::array<mjtNum, 3> middle{at[0] + half * frame[0], at[1] + half * frame[3], 0};
  const double inside = wall.side * middle[1] - wall.height;
  if (inside > 0) push(model, data, body, middle, 0, -wall.side * wall.stiffness * inside);
}

}  // namespace plumbline::simulator
