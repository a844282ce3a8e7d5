#include "diagnose/exchange/read_mujoco.hpp"

#include <algorithm>

#include "diagnose/exchange/mujoco_model.hpp"

namespace plumbline::exchange {
namespace {

using Eigen::Vector3d;
class Reader {
 public:
  explicit Reader(const std::string& file) : own_(file) {}

  ReadModel read() {
    for (int j = 0; j < model_->njnt; ++j) add_joint(j);
    for (int b = 1; b < model_->nbody; ++b) add_mass(b);
    find_end();
    result_.gravity = vector_of(model_->opt.gravity);
    if (model_->ntendon > 0) result_.left_out.push_back(std::to_string(model_->ntendon) + " tendons");
    if (model_->neq > 0) result_.left_out.push_back(std::to_string(model_->neq) + " equality constraints");
    if (model_->nu > 0) result_.left_out.push_back(std::to_string(model_->nu) + " actuators");
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string name(int type, int id, const char* otherwise) const {
    return own_.name(type, id, otherwise);
  }
  [[nodiscard]] int last_joint(int body) const { return own_.last_joint(body); }

  void add_joint(int j) {
    const int body = model_->jnt_bodyid[j];
    const int carrier = j > model_->body_jntadr[body] ? j - 1 : last_joint(model_->body_parentid[body]);
    ReadJoint joint;
    joint.name = name(mjOBJ_JOINT, j, "joint ");
    joint.carrier = carrier >= 0 ? name(mjOBJ_JOINT, carrier, "joint ") : "";
    joint.hinge = model_->jnt_type[j] == mjJNT_HINGE;
    joint.axis = vector_of(data_->xaxis, j);
    joint.anchor = vector_of(data_->xanchor, j);
    joint.stiffness = model_->jnt_stiffness[j];
    const int q = model_->jnt_qposadr[j];
    joint.rest = model_->qpos_spring[q] - model_->qpos0[q];
    if (joint.hinge && model_->dof_frictionloss[model_->jnt_dofadr[j]] > 0)
      result_.left_out.push_back("frictionloss of " + joint.name);
    if (model_->jnt_limited[j]) result_.left_out.push_back("range of " + joint.name);
    result_.joints.push_back(std::move(joint));
  }

  void add_mass(int body) {
    const int joint = last_joint(body);
    if (joint < 0 || !(model_->body_mass[body] > 0)) return;
    ReadJoint& to = result_.joints[static_cast<std::size_t>(joint)];
    const double mass = model_->body_mass[body];
    to.middle = (to.mass * to.middle + mass * vector_of(data_->xipos, body)) / (to.mass + mass);
    to.mass += mass;
  }

  /// A site of the last link: one that is named as an end, or else the farthest.
  void find_end() {
    if (result_.joints.empty()) return;
    const int last = model_->njnt - 1;
    const Vector3d anchor = result_.joints.back().anchor;
    bool named = false;
    for (int s = 0; s < model_->nsite; ++s) {
      if (last_joint(model_->site_bodyid[s]) != last) continue;
      const Vector3d at = vector_of(data_->site_xpos, s);
      const std::string own = name(mjOBJ_SITE, s, "site ");
      const bool is_end = names_an_end(own);
      if (named && !is_end) continue;
      if (result_.end && named == is_end && (*result_.end - anchor).norm() >= (at - anchor).norm()) continue;
      named = is_end;
      result_.end = at;
      result_.end_name = "site " + own;
      result_.end_site = s;
    }
  }

  MujocoModel own_;
  const mjModel* model_ = own_.model.get();
  const mjData* data_ = own_.data.get();
  ReadModel result_;
};

}  // namespace

ReadModel read_mujoco(const std::string& file) {
  return Reader(file).read();
}

}  // namespace plumbline::exchange
