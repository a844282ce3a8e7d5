#include "trial/simulator/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <mutex>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "trial/simulator/mjcf.hpp"
#include "trial/simulator/passive_force.hpp"

namespace plumbline::simulator {
namespace {

using Model = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

thread_local const PassiveForce* acting = nullptr;  // MuJoCo's callbacks are global

void passive_callback(const mjModel* model, mjData* data) {
  if (acting) acting->add_to(*model, *data);
}

class Acting {
 public:
  explicit Acting(const PassiveForce& force) { acting = &force; }
  Acting(const Acting&) = delete;
  Acting& operator=(const Acting&) = delete;
  ~Acting() { acting = nullptr; }
};

void prepare_mujoco() {
  static std::once_flag once;
  std::call_once(once, [] {
    mjcb_passive = passive_callback;
    mju_user_warning = [](const char*) {};  // else it writes a log file; we look at the state instead
    mju_user_error = [](const char* text) { throw Error(std::string("MuJoCo: ") + text); };
  });
}

Model load(const std::string& xml) {
  static std::mutex one_parser;
  const std::scoped_lock lock(one_parser);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "rig.xml", static_cast<int>(xml.size()));
  std::memcpy(files->filedata[0], xml.data(), xml.size());
  std::array<char, 500> reason{};
  Model model(mj_loadXML("rig.xml", files.get(), reason.data(), static_cast<int>(reason.size())),
              mj_deleteModel);
  mj_deleteVFS(files.get());
  if (!model) throw Error(std::string("MuJoCo: ") + reason.data());
  return model;
}

Pair turned(const Pair& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1]};
}

/// How the time between two readings is spent.
struct Timing {
  double responses;  ///< how many response times it is long
  double moving;     ///< share of it in which the carriage moves; then it waits
  double steps;      ///< time steps in a response time
  bool steady;       ///< whether it moves at a steady rate; else it starts and stops softly
};

/// Real time matters for time-dependent laws: the carriage then moves nearly throughout, and the dynamics is
/// that much faster. The torques of dry friction depend on the path, which damping must not distort, and
/// bristles need short steps.
Timing timing(const Physics& physics) {
  bool dry = physics.pivot_friction > 0, slides = false, timed = physics.lag > 0;
  for (const Joint& joint : physics.joint) {
    dry = dry || joint.friction.torque > 0;
    slides = slides || !joint.slider.empty();
    timed = timed || !joint.arm.empty() || joint.friction.fall > 0;
  }
  const double steps = dry ? 25 : slides ? 8 : 4;
  if (timed) return {150, 0.92, steps, true};
  return dry || slides ? Timing{60, 0.8, steps, false} : Timing{24, 0.5, steps, false};
}

/// How fast joints go on turning at most while arms relax and springs age, in radians a second.
double restlessness(const Physics& physics) {
  double most = 0;
  for (const Joint& joint : physics.joint) {
    double sum = joint.ageing.creep / joint.ageing.start + joint.ageing.loss / joint.ageing.warming;
    for (const Arm& arm : joint.arm) sum += arm.ratio / arm.time;
    most = std::max(most, sum);
  }
  return most;
}

class BenchAtWork {
 public:
  BenchAtWork(const Plan& plan, const Physics& physics, const PlannedRun& run)
      : physics_(physics),
        run_(run),
        timing_(timing(physics)),
        pace_(pace()),
        model_(load(mjcf(plan, physics, run, pace_))),
        data_(mj_makeData(model_.get()), mj_deleteData),
        passive_(plan, physics, run, *model_, pace_.response),
        end_(mj_name2id(model_.get(), mjOBJ_SITE, "end")) {
    for (std::size_t j = 0; j < run.rest.size(); ++j)
      hub_.push_back(
          model_->jnt_qposadr[mj_name2id(model_.get(), mjOBJ_JOINT, ("q" + std::to_string(j + 1)).c_str())]);
  }

  std::vector<State> work() {
    const Acting callback(passive_);
    std::vector<State> states;
    bring_to_start();
    states.push_back(read(run_.commands.front().t));
    double late = 0;
    for (std::size_t i = 1; i < run_.commands.size(); ++i) {
      const double planned = run_.commands[i].t - run_.commands[i - 1].t;
      move(true_command(run_.commands[i - 1], late), true_command(run_.commands[i], late), planned);
      late += settle();
      states.push_back(read(run_.commands[i].t + late));
    }
    return states;
  }

 private:
  Pace pace() const {
    const double interval = run_.commands.at(1).t - run_.commands.at(0).t;
    const double response = interval / timing_.responses;
    return {response, response / timing_.steps};
  }

  /// The motion of the carriage for a command, with the delay of the drive.
  Pair true_command(const Command& command, double late) const {
    return run_.force_controlled ? true_force(command.value, command.t + late) : true_end_point(command);
  }
  /// The servo controls by the load cell, so the reading equals the command.
  Pair true_force(const Pair& told, double t) const {
    Pair cell;
    const Pair tare = physics_.tare(run_);
    for (std::size_t a = 0; a < 2; ++a)
      cell[a] = told[a] - physics_.bias[a] - physics_.drift[a] * t - tare[a];
    const auto [xy, yx] = physics_.cross_talk;
    const double gain = 1 + physics_.gain, mixed = 1 - xy * yx;
    const Pair force{(cell[0] - xy * cell[1]) / (mixed * gain), (cell[1] - yx * cell[0]) / (mixed * gain)};
    return turned(force, physics_.misalignment);
  }
  Pair true_end_point(const Command& command) const {
    const Pair& first = run_.commands.front().value;
    const Pair way =
        turned({command.value[0] - first[0], command.value[1] - first[1]}, physics_.misalignment);
    const Pair aside = beside_straight(way);
    const double pitch = 2 * std::numbers::pi * (command.value[0] - first[0]) / physics_.screw.period;
    const bool slipped = command.t > physics_.grip_slip_share * run_.commands.back().t;
    return {first[0] + way[0] + aside[0] + physics_.position_offset[0] +
                physics_.screw.amplitude[0] * std::sin(pitch) + (slipped ? physics_.grip_slip : 0),
            first[1] + way[1] + aside[1] + physics_.position_offset[1]};
  }
  /// How far a bent rail leads to the left of a straight way.
  Pair beside_straight(const Pair& way) const {
    const double share = std::hypot(way[0], way[1]) / physics_.rail.span;
    const double slope = 4 * physics_.rail.height / physics_.rail.span * (1 - share);
    return {-slope * way[1], slope * way[0]};
  }

  [[nodiscard]] Pair end_point() const {
    return {data_->site_xpos[3 * end_], data_->site_xpos[3 * end_ + 1]};
  }
  /// The left normal of the last link, as long as the eccentricity.
  [[nodiscard]] Pair beside() const {
    const mjtNum* frame = data_->site_xmat + 9 * end_;
    return {physics_.eccentricity * frame[1], physics_.eccentricity * frame[4]};
  }

  void bring_to_start() {
    for (std::size_t j = 0; j < hub_.size(); ++j) data_->qpos[hub_[j]] = rest_angle(physics_, run_, j);
    mj_kinematics(model_.get(), data_.get());
    const Pair from = run_.force_controlled ? Pair{0, 0} : end_point();
    constexpr double readings_long = 4;
    move(from, true_command(run_.commands.front(), 0), readings_long * timing_.responses * pace_.response);
    settle();
    passive_.begin_history();
  }

  void move(const Pair& from, const Pair& to, double seconds) {
    const auto steps = static_cast<int>(std::lround(seconds / pace_.timestep));
    const auto moving = static_cast<int>(timing_.moving * steps);
    for (int s = 1; s <= steps; ++s) {
      const double share = std::min(1.0, static_cast<double>(s) / moving);
      const double way = timing_.steady ? share : share * share * (3 - 2 * share);
      target_ = {from[0] + way * (to[0] - from[0]), from[1] + way * (to[1] - from[1])};
      step();
    }
  }

  /// Waits for rest; how long, in seconds.
  double settle() {
    constexpr int patience = 20000;
    const double rest = 2e-9 + restlessness(physics_) * pace_.response;  // radians within a response time
    for (int s = 0; s < patience; ++s) {
      double fastest = 0;
      for (const int address : hub_)  // hinges have one coordinate: the same order in qvel
        fastest = std::max(fastest, std::abs(data_->qvel[address]));
      if (!std::isfinite(fastest) || data_->warning[mjWARN_BADQACC].number > 0)
        throw Error("simulator: the motion of run \"" + run_.id + "\" got out of hand");
      if (fastest * pace_.response < rest) return s * pace_.timestep;
      step();
    }
    throw Error("simulator: run \"" + run_.id + "\" did not come to rest");
  }

  void step() {
    if (run_.force_controlled) {
      push();
    } else {
      hold();
    }
    mj_step(model_.get(), data_.get());
    passive_.remember(*data_, pace_.timestep);
  }

  void push() {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    const Pair at = end_point(), side = beside();
    const std::array<mjtNum, 3> point{at[0] + side[0], at[1] + side[1], 0}, force{target_[0], target_[1], 0},
        torque{0, 0, 0};
    std::fill_n(data_->qfrc_applied, model_->nv, 0.0);
    mj_applyFT(model_.get(), data_.get(), force.data(), torque.data(), point.data(),
               model_->site_bodyid[end_], data_->qfrc_applied);
  }

  /// Sets the anchor of the connection. MuJoCo's constraint yields to its force, by R f = -K I r at rest; the
  /// anchor is displaced by as much.
  void hold() {
    mj_kinematics(model_.get(), data_.get());
    const Pair side = beside();
    for (std::size_t a = 0; a < 2; ++a) {
      const mjtNum* kbip = data_->efc_KBIP + 4 * a;
      const double yields = data_->nefc > 0 ? data_->efc_R[a] * data_->efc_force[a] / (kbip[0] * kbip[2]) : 0;
      model_->eq_data[3 + a] = target_[a] + side[a] + yields;
    }
    model_->eq_data[1] = physics_.eccentricity;
  }

  [[nodiscard]] State read(double t) const {
    State state{t, end_point(), target_, {}};
    if (!run_.force_controlled) state.force = {data_->efc_force[0], data_->efc_force[1]};
    for (const int address : hub_) state.q.push_back(data_->qpos[address]);
    return state;
  }

  const Physics& physics_;
  const PlannedRun& run_;
  Timing timing_;
  Pace pace_;
  Model model_;
  Data data_;
  PassiveForce passive_;
  std::ptrdiff_t end_;
  std::vector<int> hub_;
  Pair target_{0, 0};
};

}  // namespace

std::vector<State> simulate(const Plan& plan, const Physics& physics, const PlannedRun& run) {
  prepare_mujoco();
  return BenchAtWork(plan, physics, run).work();
}

std::vector<std::vector<State>> simulate(const Plan& plan, const Physics& physics) {
  std::vector<std::vector<State>> all;
  for (const PlannedRun& run : plan.runs) all.push_back(simulate(plan, physics, run));
  return all;
}

}  // namespace plumbline::simulator
