#pragma once
/// \file
/// Somebody's robot on its bench, and the files of that lab.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/rig/nominal.hpp"
#include "diagnose/rig/run_rig.hpp"
#include "tests/diagnose/exchange/proof.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange::test {

/// A robot of somebody's: in degrees, with classes, a joint that turns the other way, bodies and actuators of
/// its own, a part in another file, a keyframe. At rest it has the angles 0.3, -0.5, 0.4.
inline const char* const robot = R"(<mujoco model="leg">
  <!-- drawn by hand -->
  <option gravity="0 0 0"/>
  <default>
    <joint damping="0.1" armature="0.01" limited="true" range="-170 170" frictionloss="0"/>
    <general ctrllimited="true" ctrlrange="-1 1"/>
    <default class="bone"><geom type="capsule" size="0.01" mass="0.01" rgba="0.8 0.8 0.7 1" contype="0" conaffinity="0"/></default>
  </default>
  <include file="floor.xml"/>
  <worldbody>
    <body name="thigh" childclass="bone">
      <joint name="hip" axis="0 0 1" stiffness="2" springref="17.188733853924695"/>
      <geom name="femur" fromto="0 0 0 0.2 0 0"/>
      <body name="shin" pos="0.2 0 0">
        <geom name="tibia" fromto="0 0 0 0.25 0 0"/>
        <joint name="knee" axis="0 0 -1" stiffness="1.5" springref="28.64788975654116"/>
        <body name="foot" pos="0.25 0 0" quat="0.7071067811865476 0.7071067811865475 0 0">
          <joint name="ankle" axis="0 1 0" stiffness="1" springref="22.918311805232928"/>
          <geom name="sole" fromto="0 0 0 0.15 0 0"/>
          <site name="toe_tip" pos="0.15 0 0"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator><motor name="push" joint="knee"/></actuator>
  <keyframe><key name="bent" qpos="0.1 0.2 0.3" ctrl="0.5"/></keyframe>
</mujoco>
)";
inline const char* const room =
    R"(<mujocoinclude><worldbody><light name="lamp" pos="0 0 3"/><geom name="floor" type="plane" size="2 2 0.1" pos="0 0 -1" contype="0" conaffinity="0"/></worldbody></mujocoinclude>)";

/// Without the part that is in another file.
inline std::string robot_alone() {
  std::string text = robot;
  const std::string include = "<include file=\"floor.xml\"/>";
  return text.erase(text.find(include), include.size());
}

/// The robot in a folder, and a bench on which it rests as it is drawn.
struct Lab {
  explicit Lab(int steps = 20) {
    folder.write("robot.xml", robot);
    folder.write("floor.xml", room);
    static_cast<diagnose::NominalChain&>(experiment) = read_model(folder / "robot.xml").chain;
    const std::vector<double> rest{0.3, -0.5, 0.4};
    experiment.runs.clear();
    diagnose::test::press(experiment, rest, {-0.06, 0}, steps, true);
    diagnose::test::press(experiment, rest, {-0.05, 0.03}, 3 * steps / 4, false, 2.5);
    diagnose::test::load(experiment, rest, {0, 0}, {-2.0, 1.0}, 3 * steps / 4);
  }
  Folder folder;
  Experiment experiment = diagnose::test::full_bench();
};

/// The foot's axis, +y of its own frame, is +z of the world's; the knee's is -z.
inline Names names() {
  return {"toe_tip", "load", {{"hip", 1}, {"knee", -1}, {"ankle", 1}}};
}

inline Prediction in_mujoco(const std::string& text, const Experiment& experiment, Pace pace) {
  Prediction all;
  for (const diagnose::Run& run : experiment.runs)
    all.runs.push_back(MujocoBench(text, pace, names()).run(run));
  return all;
}

/// The lab's bench, as an effect needs it.
inline Experiment bench_in(const Lab& lab, const EffectAt& at) {
  Experiment experiment = lab.experiment;
  if (!takes_time(at)) return experiment;
  experiment.runs.pop_back();
  for (diagnose::Run& run : experiment.runs)
    for (diagnose::Reading& reading : run.readings) reading.t *= slowness;
  return experiment;
}

/// A number as a spreadsheet of half the world writes it.
inline std::string with_comma(double value) {
  std::string text = fmt::format("{:.9g}", value);
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

/// The readings as a lab writes them down: millimetres, decimal commas between semicolons.
inline void write_down(const Experiment& experiment, const Folder& folder) {
  const diagnose::Noise& noise = experiment.noise;
  std::string toml = fmt::format(
      "format = \"chain-experiment/1\"\nname = \"robot\"\n"
      "csv = {{ delimiter = \";\", decimal = \",\" }}\n"
      "columns = {{ x.unit = \"mm\", y.unit = \"mm\" }}\n"
      "bench = {{ gravity_plane = \"vertical\" }}\n"
      "noise = {{ x = {}, y = {}, Fx = {}, Fy = {}, q = {} }}\n",
      1e3 * noise[diagnose::Channel::Name::x], 1e3 * noise[diagnose::Channel::Name::y],
      noise[diagnose::Channel::Name::Fx], noise[diagnose::Channel::Name::Fy],
      noise[diagnose::Channel::Name::q]);
  for (const diagnose::Run& run : experiment.runs) {
    toml += fmt::format("[[run]]\nid = \"{0}\"\ncontrol = \"{1}\"\nrest = [{2}]\nsamples = \"{0}.csv\"\n",
                        run.id, run.holds_end_point() ? "displacement" : "force", fmt::join(run.rest, ", "));
    std::string csv = "t;x;y;Fx;Fy;q1;q2;q3\n";
    for (const diagnose::Reading& r : run.readings) {
      csv += with_comma(r.t);
      for (const double value : {1e3 * r[diagnose::column_x], 1e3 * r[diagnose::column_y],
                                 r[diagnose::column_Fx], r[diagnose::column_Fy], r[diagnose::column_q + 0],
                                 r[diagnose::column_q + 1], r[diagnose::column_q + 2]})
        csv += ";" + with_comma(value);
      csv += "\n";
    }
    folder.write(run.id + ".csv", csv);
  }
  folder.write("experiment.toml", toml);
}

/// As what is in the corrected file asks for.
inline Pace pace_of(const Model& model, Pace otherwise) {
  diagnose::Experiment experiment = model.experiment;
  experiment.run_count = experiment.runs.size();
  const diagnose::Rig rig = nominal_rig(experiment);
  if (!arm_times(rig).empty()) return Pace::by_the_clock;
  bool slides = rig.guide_friction > 0;
  for (std::size_t j = 0; j < rig.length.size(); ++j)
    slides = slides || rig.friction[j] > 0 || slider_count(rig, j) > 0;
  return slides ? Pace::interpolated : otherwise;
}

/// From the robot's MJCF, changed in MuJoCo, by the lab's files to the corrected MJCF and back to MuJoCo.
struct RoundTrip {
  diagnose::Diagnosis diagnosis;
  /// What is left of the residual on the readings held out, all of them, as the report says, and in MuJoCo:
  /// of several candidates' files with the best. 1 without any.
  double reported = 1, mujoco = 1;
  /// Of all readings, before and with the file, in standard deviations of their noise.
  double before = 0, after = 0;
};

/// \param truth  what the robot does that has the effect
inline RoundTrip round_trip(const Lab& lab, const Experiment& bench, const Prediction& truth, Pace pace,
                            unsigned seed) {
  write_down(read_with_noise(bench, truth, seed), lab.folder);
  const std::filesystem::path model = lab.folder / "robot.xml";
  const diagnose::NominalChain nominal = read_model(model).chain;
  const Study study(diagnose::read_experiment(lab.folder.path(), &nominal));
  RoundTrip trip{diagnose::diagnose(study)};
  trip.before = trip.after = rms(study.nominal_residual());
  const auto left_there = [&](const Eigen::VectorXd& left) {
    const diagnose::HeldOut heldout = named(study.experiment(), trip.diagnosis.shrink->heldout);
    return measure_shrink(study.measurements(), heldout, study.nominal_residual(), left, trip.diagnosis.noise)
        .ratio_with_outliers;
  };
  if (const auto& shrink = trip.diagnosis.shrink) trip.reported = shrink->ratio_with_outliers;
  // The law of the report is fitted to all readings, unlike those that its shrink is measured with.
  if (trip.diagnosis.offers_law())
    trip.reported = left_there(study.residual(predict_with_law(study, trip.diagnosis.law->law)));
  for (const Corrected& one : corrected_models(study, trip.diagnosis, model)) {
    const Prediction corrected =
        in_mujoco(written(one.model, Format::mjcf).text, study.experiment(), pace_of(one.model, pace));
    const Eigen::VectorXd left = study.residual(corrected);
    trip.after = std::min(trip.after, rms(left));
    if (!trip.diagnosis.shrink) continue;
    trip.mujoco = std::min(trip.mujoco, left_there(left));
  }
  return trip;
}

/// \param changed  the robot's file with the effect in it
inline RoundTrip round_trip(const Lab& lab, const Experiment& bench, const std::string& changed, Pace pace,
                            unsigned seed) {
  return round_trip(lab, bench, in_mujoco(changed, bench, pace), pace, seed);
}

}  // namespace plumbline::exchange::test
