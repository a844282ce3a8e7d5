#pragma once
/// \file
/// A written MJCF at work in MuJoCo: its end point is led slowly along a run's commands, or loaded by its
/// forces; by the drive of the file, and read by its load cell, where it has them.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <plumbline/base/error.hpp>
#include <string>
#include <vector>

#include "diagnose/rig/history.hpp"

namespace plumbline::exchange::test {

/// When a reading is taken. Under an end point that is held MuJoCo's dry friction forgets what it carried, so
/// that what slides is read on its slow way.
enum class Pace { at_rest, interpolated, by_the_clock };

/// What a file calls the parts of the chain; angles of some joints count the other way.
struct Names {
  std::string end = "end", load = "load";
  std::vector<std::pair<std::string, double>> joints = {};  ///< "q1", "q2" ... unless it has its own
};

class MujocoBench {
 public:
  MujocoBench(const std::string& mjcf, Pace pace, Names names = {})
      : model_(load(mjcf), mj_deleteModel), names_(std::move(names)), pace_(pace) {
    if (site(*model_, names_.load) < 0) names_.load = names_.end;
    driven_ = mj_name2id(model_.get(), mjOBJ_ACTUATOR, "drive_x") >= 0;
    if (!driven_) add_hand(mjcf);
    data_.reset(mj_makeData(model_.get()));
    hold_ = mj_name2id(model_.get(), mjOBJ_EQUALITY, driven_ ? "grip" : "hold");
  }

  /// What would be read: x, y, Fx, Fy, q1 ... qn, a row a reading.
  diagnose::Trace run(const diagnose::Run& run) {
    const bool held = run.holds_end_point();
    model_->eq_active[hold_] = held || driven_;
    mj_resetData(model_.get(), data_.get());
    std::copy_n(model_->qpos_spring, model_->nq, data_->qpos);
    mj_forward(model_.get(), data_.get());
    if (driven_ && !held) let_go();
    if (driven_ && pace_ == Pace::interpolated && !slides()) pace_ = Pace::at_rest;
    target_ = !held ? Eigen::Vector2d(0, 0) : driven_ ? drive() : end();
    diagnose::Trace trace(static_cast<Eigen::Index>(run.readings.size()),
                          diagnose::column_q + static_cast<Eigen::Index>(run.rest.size()));
    for (std::size_t r = 0; r < run.readings.size(); ++r) {
      const double clock = r > 0 ? run.readings[r].t - run.readings[r - 1].t : 1;
      move(run.command(run.readings[r]),
           pace_ == Pace::by_the_clock   ? clock
           : pace_ == Pace::interpolated ? slow_way
                                         : 1,
           held);
      if (r == 0) begin(run.readings.front().t, held);
      write(trace.row(static_cast<Eigen::Index>(r)), run, held);
    }
    return trace;
  }

  /// A list of <custom>.
  [[nodiscard]] std::vector<double> numbers(const char* name) const {
    const int id = mj_name2id(model_.get(), mjOBJ_NUMERIC, name);
    if (id < 0) return {};
    const mjtNum* first = model_->numeric_data + model_->numeric_adr[id];
    return {first, first + model_->numeric_size[id]};
  }

 private:
  static constexpr double slow_way = 8;  // s from reading to reading

  void add_hand(const std::string& mjcf) {
    const int load_site = site(*model_, names_.load), tip = model_->site_bodyid[load_site];
    const std::string held = mj_id2name(model_.get(), mjOBJ_BODY, tip);
    std::string with_hand = mjcf;
    with_hand.insert(with_hand.find("</worldbody>"), "<body name=\"hand\" mocap=\"true\"/>");
    with_hand.insert(with_hand.rfind("</mujoco>"), "<equality><connect name=\"hold\" body1=\"" + held +
                                                       "\" body2=\"hand\" anchor=\"0 0 0\" solref=\"0.008 "
                                                       "1\" solimp=\"0.9999 0.9999 0.001\"/></equality>");
    model_.reset(load(with_hand));
    const int hold = mj_name2id(model_.get(), mjOBJ_EQUALITY, "hold");
    for (int a = 0; a < 3; ++a) {
      model_->eq_data[mjNEQDATA * hold + a] = model_->site_pos[3 * load_site + a];
      model_->eq_data[mjNEQDATA * hold + 3 + a] = 0;
    }
  }

  static mjModel* load(const std::string& xml) {
    mju_user_warning = [](const char*) {};
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    std::array<char, 500> reason{};
    mjModel* model = mj_loadXML("model.xml", files.get(), reason.data(), static_cast<int>(reason.size()));
    mj_deleteVFS(files.get());
    if (model == nullptr) throw Error(std::string("MuJoCo: ") + reason.data() + "\n" + xml);
    return model;
  }
  static int site(const mjModel& model, const std::string& name) {
    return mj_name2id(&model, mjOBJ_SITE, name.c_str());
  }
  [[nodiscard]] Eigen::Vector2d at(const std::string& name) const {
    const mjtNum* place = data_->site_xpos + 3 * site(*model_, name);
    return {place[0], place[1]};
  }
  [[nodiscard]] Eigen::Vector2d end() const { return at(names_.end); }
  [[nodiscard]] Eigen::Vector2d sensors(const char* x, const char* y) const {
    const auto read = [&](const char* name) {
      return data_->sensordata[model_->sensor_adr[mj_name2id(model_.get(), mjOBJ_SENSOR, name)]];
    };
    return {read(x), read(y)};
  }
  [[nodiscard]] int dof(const char* joint) const {
    return model_->jnt_dofadr[mj_name2id(model_.get(), mjOBJ_JOINT, joint)];
  }
  [[nodiscard]] Eigen::Vector2d drive() const { return sensors("x", "y"); }

  /// The first reading is taken at rest, when the clock is set and nothing that slips or relaxes is
  /// stretched.
  void begin(double time, bool held) {
    for (int tries = 0; tries < 3 && ease(); ++tries) move(target_, 1, held);
    const auto place = [&](const char* name) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name);
      return joint < 0 ? -1 : model_->jnt_qposadr[joint];
    };
    if (const int clock = place("clock"); clock >= 0) data_->qpos[clock] = time;
    for (const auto& [lag, cell] : {std::pair("lag_x", "cell_x"), std::pair("lag_y", "cell_y")})
      if (const int own = place(lag); own >= 0) {
        data_->qpos[own] = model_->qpos_spring[own] + data_->qpos[place(cell)];
        data_->qvel[dof(lag)] = 0;
      }
    mj_forward(model_.get(), data_.get());
  }

  /// Lets the arms that relax, or slip but for those of a law, each on a spring of its own name, carry
  /// nothing.
  /// \returns whether there is any
  bool ease() {
    bool any = false;
    for (int t = 0; t < model_->ntendon; ++t) {
      const char* own = mj_id2name(model_.get(), mjOBJ_TENDON, t);
      const std::string name = own != nullptr ? own : "";
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
      if (joint < 0) continue;
      const bool slips = model_->dof_frictionloss[model_->jnt_dofadr[joint]] > 0,
                 of_law = name.find("_law") != name.npos;
      if (!(slips && !of_law) && name.find("_relax") == name.npos) continue;
      data_->qpos[model_->jnt_qposadr[joint]] += data_->ten_length[t] - model_->tendon_lengthspring[t];
      data_->qvel[model_->jnt_dofadr[joint]] = 0;
      any = true;
    }
    mj_forward(model_.get(), data_.get());
    return any;
  }

  /// An end point by its commands; a force, by a drive that is let go, as the load cell reads it.
  void lead(bool held) {
    constexpr double patience = 0.1;  // s
    if (!held) pushed_ += model_->opt.timestep / patience * (target_ - sensors("Fx", "Fy"));
    for (int a = 0; a < 2; ++a) {
      const char* name = a == 0 ? "drive_x" : "drive_y";
      data_->ctrl[mj_name2id(model_.get(), mjOBJ_ACTUATOR, name)] = target_[a];
      data_->qfrc_applied[dof(name)] = pushed_[a];
    }
  }

  /// A drive that pushes with a force alone, which the catalogue has beside the guide.
  void let_go() {
    constexpr double light = 1e-6;
    if (const int guide = mj_name2id(model_.get(), mjOBJ_TENDON, "guide"); guide >= 0)
      model_->tendon_frictionloss[guide] = 0;
    for (const char* name : {"drive_x", "drive_y"}) {
      const int actuator = mj_name2id(model_.get(), mjOBJ_ACTUATOR, name);
      model_->actuator_gainprm[mjNGAIN * actuator] = 0;
      model_->actuator_biasprm[mjNBIAS * actuator + 1] = 0;
      model_->dof_damping[dof(name)] *= light;
      model_->dof_armature[dof(name)] *= light;
    }
  }

  [[nodiscard]] bool slides() const {
    const auto dry = [](mjtNum friction) { return friction > 0; };
    return std::any_of(model_->dof_frictionloss, model_->dof_frictionloss + model_->nv, dry) ||
           std::any_of(model_->tendon_frictionloss, model_->tendon_frictionloss + model_->ntendon, dry);
  }

  /// Moves at a steady rate; waits for rest only where readings are taken at rest.
  void move(const Eigen::Vector2d& to, double seconds, bool held) {
    const Eigen::Vector2d from = target_;
    const double step = model_->opt.timestep;
    const bool waits = pace_ == Pace::at_rest;
    const int all = static_cast<int>(std::lround(seconds / step)), patience = waits ? 20 * all : all;
    const double moving = (waits ? 0.5 : pace_ == Pace::by_the_clock ? 0.98 : 1) * all;
    for (int s = 1; s <= patience; ++s) {
      target_ = from + std::min(1.0, s / moving) * (to - from);
      hold_or_push(held);
      mj_step(model_.get(), data_.get());
      double fastest = 0;
      for (int v = 0; v < model_->nv; ++v) fastest = std::max(fastest, std::abs(data_->qvel[v]));
      if (!std::isfinite(fastest)) throw Error("MuJoCo: the motion got out of hand");
      if (s > all && fastest < 2e-5) break;
    }
    mj_forward(model_.get(), data_.get());
  }

  void hold_or_push(bool held) {
    if (driven_) return lead(held);
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    const Eigen::Vector2d load = at(names_.load), beside = load - end();
    if (held) {
      data_->mocap_pos[0] = target_.x() + beside.x();
      data_->mocap_pos[1] = target_.y() + beside.y();
      return;
    }
    const std::array<mjtNum, 3> point{load.x(), load.y(), 0}, force{target_.x(), target_.y(), 0},
        none{0, 0, 0};
    std::fill_n(data_->qfrc_applied, model_->nv, 0.0);
    mj_applyFT(model_.get(), data_.get(), force.data(), none.data(), point.data(),
               model_->site_bodyid[site(*model_, names_.load)], data_->qfrc_applied);
  }

  template <class Row>
  void write(Row row, const diagnose::Run& run, bool held) {
    const Eigen::Vector2d point = held ? target_ : end();
    Eigen::Vector2d force = target_;
    if (held && driven_) {
      force = sensors("Fx", "Fy");
    } else if (held) {
      // the rows of the connection, the first of its kind but for those of followers before it
      for (int c = 0; c < data_->nefc; ++c)
        if (data_->efc_type[c] == mjCNSTR_EQUALITY && data_->efc_id[c] == hold_) {
          force = {data_->efc_force[c], data_->efc_force[c + 1]};
          break;
        }
    }
    row(diagnose::column_x) = point.x();
    row(diagnose::column_y) = point.y();
    row(diagnose::column_Fx) = force.x();
    row(diagnose::column_Fy) = force.y();
    for (std::size_t i = 0; i < run.rest.size(); ++i) {
      const auto [name, sense] =
          names_.joints.empty() ? std::pair("q" + std::to_string(i + 1), 1.0) : names_.joints[i];
      const double angle = sense * angle_of(name) + angle_of(name + "_play");
      row(diagnose::column_q + static_cast<Eigen::Index>(i)) = angle;
    }
  }

  [[nodiscard]] double angle_of(const std::string& name) const {
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name.c_str());
    return joint < 0 ? 0 : data_->qpos[model_->jnt_qposadr[joint]];
  }

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  Names names_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_{nullptr, mj_deleteData};
  Pace pace_;
  bool driven_ = false;
  int hold_ = 0;
  Eigen::Vector2d pushed_ = Eigen::Vector2d::Zero();  ///< by the drive, N
  Eigen::Vector2d target_ = Eigen::Vector2d::Zero();
};

}  // namespace plumbline::exchange::test
