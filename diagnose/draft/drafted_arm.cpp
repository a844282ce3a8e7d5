#include "diagnose/draft/drafted_arm.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/median.hpp"
#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/draft/arm_run.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/quoted.hpp"
#include "diagnose/draft/registration.hpp"

namespace plumbline::diagnose {
namespace {

std::string list(const Eigen::Vector3d& vector) {
  return fmt::format("[{:.10g}, {:.10g}, {:.10g}]", vector.x(), vector.y(), vector.z());
}

class ArmDrafter {
 public:
  ArmDrafter(const std::string& name, const std::vector<RunSource>& sources, const DraftModel& model,
             const Ask& ask)
      : name_(name), model_(model), ask_(ask), arm_(*model.arm) {
    for (const RunSource& source : sources) runs_.push_back(arm_run(source, model));
  }

  DraftedArm result() {
    for (const ArmRun& run : runs_) {
      result_.used.push_back(run.used);
      result_.guesses.insert(result_.guesses.end(), run.guesses.begin(), run.guesses.end());
    }
    take_frame();
    take_turns();
    require_readings();
    result_.settings = settings();
    for (const ArmRun& run : runs_) result_.tables.push_back({run.id + ".csv", table_of(run)});
    result_.tables.push_back(model_.file);
    return std::move(result_);
  }

 private:
  std::optional<std::string> say(const std::string& what, const std::string& value, const std::string& reason,
                                 bool doubtful = false, const std::string& line = "") {
    Guess guess{what, value, reason, doubtful, line};
    std::optional<std::string> answer;
    if (doubtful && ask_) answer = ask_(guess);
    if (answer) guess = {what, *answer, "as you said"};
    result_.guesses.push_back(guess);
    return answer;
  }

  /// The unit of places, and the frame of the tracker where it is clearly another than the model's.
  void take_frame() {
    registration_ = registered(runs_, arm_);
    const bool placed =
        std::any_of(runs_.begin(), runs_.end(), [](const ArmRun& run) { return !run.places.empty(); });
    if (!placed) return;
    if (!registration_.said)
      say("unit of the tip's places", registration_.unit,
          "the poses are then as far apart as the model has them");
    if (registration_.takes_frame)
      say("frame of the tracker",
          fmt::format("turned by {:.3g} rad, displaced by {:.4g} m",
                      Eigen::AngleAxisd(registration_.frame.linear()).angle(),
                      registration_.frame.translation().norm()),
          fmt::format("the nominal tip is then {:.3g} mm from its readings instead of {:.3g} mm",
                      1e3 * registration_.as_registered, 1e3 * registration_.as_read));
    const double unit = parse_unit(registration_.unit, quantity::length, "").in_si();
    for (ArmRun& run : runs_)
      for (Eigen::Index axis = 0; axis < 3 && !run.places.empty(); ++axis) {
        ArmColumn column{std::string("tip_") + "xyz" [axis], {}, Channel::Name::place};
        for (const Eigen::Vector3d& place : run.places) column.values.push_back(unit * place(axis));
        run.columns.push_back(std::move(column));
      }
  }

  /// Orientations count where the tracked frame stands on the tool as the model's tip does.
  void take_turns() {
    std::vector<double> off;
    SerialArm<double> placed = arm_.arm;
    placed.base = registration_.frame * placed.base;
    const OnLink<double> tip{placed.size() - 1, placed.tip};
    for (const ArmRun& run : runs_)
      for (std::size_t i = 0; i < run.turns.size(); ++i) {
        const Eigen::Quaterniond told(nominal_pose(placed, tip, run.commands[i]).linear());
        if (run.turns[i].coeffs().allFinite()) off.push_back(told.angularDistance(run.turns[i].normalized()));
      }
    if (off.empty()) return;
    constexpr double near = 0.2;
    if (const double middle = median(off); middle > near) {
      say("orientation of the tip", "not used",
          fmt::format("the tracked frame stands {:.2g} rad from the model's tip: say how it is mounted by "
                      "[[arm.point]] rpy, and add its columns",
                      middle));
      return;
    }
    for (ArmRun& run : runs_) {
      if (run.turns.empty()) continue;
      std::array<ArmColumn, 4> q;
      for (std::size_t i = 0; i < q.size(); ++i)
        q[i].name = std::string("tip_q") + "wxyz"[i], q[i].reads = Channel::Name::turn;
      for (const Eigen::Quaterniond& raw : run.turns) {
        const Eigen::Quaterniond turn = raw.normalized();
        q[0].values.push_back(turn.w()), q[1].values.push_back(turn.x());
        q[2].values.push_back(turn.y()), q[3].values.push_back(turn.z());
      }
      run.columns.insert(run.columns.end(), q.begin(), q.end());
    }
  }

  void require_readings() {
    for (const ArmRun& run : runs_)
      if (std::none_of(run.columns.begin(), run.columns.end(),
                       [](const ArmColumn& one) { return one.reads.has_value(); }) &&
          result_.question.empty())
        result_.question = fmt::format(
            "{}: found no reading beside the joints' angles, expected places of the tip, reached angles or "
            "torques of "
            "the drives: --columns x=COLUMN:mm,y=COLUMN:mm,z=COLUMN:mm",
            run.id);
  }

  static std::string table_of(const ArmRun& run) {
    std::vector<std::string> names;
    for (const ArmColumn& column : run.columns) names.push_back(column.name);
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (std::size_t i = 0; i < run.commands.size(); ++i) {
      std::vector<std::string> fields;
      for (const ArmColumn& column : run.columns)
        fields.push_back(std::isfinite(column.values[i]) ? fmt::format("{:.12g}", column.values[i]) : "");
      text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
  }

  /// Scatter of what is read in time; of poses that were read one by one, that of their rounding at least.
  void add_noise(std::string& text, Channel::Name kind, double usual) const {
    std::vector<double> all;
    for (const ArmRun& run : runs_)
      for (const ArmColumn& column : run.columns) {
        if (column.reads != kind || finite(column.values).empty()) continue;
        constexpr double smooth = 0.05;
        const bool in_time = roughness(column.values) < smooth;
        if (const double one = in_time ? scatter_of(column.values) : usual; one > 0) all.push_back(one);
      }
    if (!all.empty()) text += fmt::format("{} = {:.2g}\n", kind_of(kind).noise_key, median(all));
  }

  [[nodiscard]] std::string settings() const {
    std::string text =
        "#:schema experiment.schema.json\n# Drafted by `plumbline new`: what it guessed, it said; correct "
        "here "
        "what is wrong.\nformat = \"chain-experiment/1\"\n";
    text += "name = " + quoted(name_) + "\n\n[arm]\nmodel = " + quoted(model_.file.name) + "\n";
    if (!model_.base_body.empty()) text += "base = " + quoted(model_.base_body) + "\n";
    if (!model_.tip.empty()) text += "tip = " + quoted(model_.tip) + "\n";
    if (registration_.takes_frame) {
      const Pose<double> base = registration_.frame * arm_.arm.base;
      text +=
          fmt::format("base_xyz = {}  # of the base in the tracker's frame, m\nbase_rpy = {}\ngravity = {}\n",
                      list(base.translation()), list(roll_pitch_yaw(base.linear())),
                      list(registration_.frame.linear() * arm_.arm.gravity));
      text +=
          "frames = \"unknown\"  # found from these poses alone; \"known\" if a registration of its own says "
          "so\n";
    }
    text += sensors(!registration_.takes_frame);
    text += "\n[noise]  # of a single reading: its scatter in time, or what is usual\n";
    add_noise(text, Channel::Name::place, usual_place());
    add_noise(text, Channel::Name::turn, usual_angle);
    add_noise(text, Channel::Name::q, usual_angle);
    add_noise(text, Channel::Name::drive, usual_torque());
    add_noise(text, Channel::Name::distance, usual_place());
    add_noise(text, Channel::Name::height, usual_place());
    add_noise(text, Channel::Name::inclination, usual_angle);
    add_noise(text, Channel::Name::pixel, usual_pixel);
    for (const ArmRun& run : runs_)
      text += fmt::format("\n[[run]]\nid = {0}\nsamples = {1}\n", quoted(run.id), quoted(run.id + ".csv"));
    return text;
  }

  /// The tables of all sensors; nobody has said where they stand.
  [[nodiscard]] std::string sensors(bool frames) const {
    std::vector<std::string> names;
    std::string text;
    for (const ArmRun& run : runs_)
      for (const SensorColumns& one : run.sensors) {
        if (std::ranges::count(names, one.name) > 0) continue;
        names.push_back(one.name);
        text += fmt::format("\n[[arm.sensor]]  # of the tip, or of an [[arm.point]]\nname = {}\nkind = {}\n",
                            quoted(one.name), quoted(std::string(one.kind->key)));
      }
    if (text.empty() || !frames) return text;
    return "frames = \"unknown\"  # nobody has said where the sensors stand\n" + text;
  }

  static constexpr double usual_angle = 3e-4, usual_pixel = 0.1;
  /// A ten-thousandth of the reach.
  [[nodiscard]] double usual_place() const {
    double reach = 0;
    for (std::size_t i = 0; i < arm_.arm.size(); ++i) reach += arm_.arm.far_end(i).translation().norm();
    return 1e-4 * reach;
  }
  /// A hundredth of the largest one.
  [[nodiscard]] double usual_torque() const {
    double most = 0;
    for (const ArmRun& run : runs_)
      for (const ArmColumn& column : run.columns)
        if (column.reads == Channel::Name::drive)
          for (const double value : finite(column.values)) most = std::max(most, std::abs(value));
    return 0.01 * most;
  }

  const std::string& name_;
  const DraftModel& model_;
  const Ask& ask_;
  const NominalArm& arm_;
  std::vector<ArmRun> runs_;
  Registration registration_{};
  DraftedArm result_;
};

}  // namespace

DraftedArm drafted_arm(const std::string& name, const std::vector<RunSource>& sources,
                       const DraftModel& model, const Ask& ask) {
  return ArmDrafter(name, sources, model, ask).result();
}

}  // namespace plumbline::diagnose
