/// \file
/// An arm on a bench whose tracker has it elsewhere: what is written into its file is read out of it.
#include "diagnose/exchange/written_arm.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/exchange/arm_toml.hpp"
#include "diagnose/exchange/corrected.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/inference/calibration.hpp"
#include "tests/diagnose/exchange/arm_in_mujoco.hpp"
#include "tests/diagnose/exchange/drawn_arm.hpp"
#include "tests/diagnose/exchange/proof.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

using diagnose::EffectAt, diagnose::Experiment, diagnose::Prediction, diagnose::Study;

const std::vector<test::DrawnBody> bodies{
    {{false, {0, 0, 1}, {0, 0, 0.3}, {0, 0, 0}}, 2, {0.1, 0, 0.1}, false},
    {{false, {0, 1, 0}, {0.1, 0, 0.2}, {0.3, 0, 0}}, 1.5, {0.2, 0, 0}, false},
    {{false, {0, 1, 0.1}, {0.4, 0, 0}, {0, 0.2, 0}}, 1, {0.1, 0.02, 0}, false}};

struct ArmFile {
  const char* name;
  std::string text;
};
const std::vector<ArmFile> arms{{"arm.urdf", test::arm_in_urdf(bodies)},
                                {"arm.xml", test::arm_in_mjcf(bodies)},
                                {"arm.sdf", test::arm_in_sdf(bodies)}};

SerialArm<double> arm_in(const Folder& folder, const std::string& model) {
  return read_arm(folder / model, {"base", "tip"}).nominal.arm;
}

/// The arm of a file on a bench that stands 3.6 m off and is turned, its tip seen by a tracker, torques
/// read.
/// \param seen  the arm that was there, wherever its file has the base
Experiment on_bench(const Folder& folder, const std::string& model, SerialArm<double> seen) {
  const std::string settings = fmt::format(R"(format = "chain-experiment/1"
name = "arm"
[arm]
model = "{}"
base = "base"
tip = "tip"
base_xyz = [3.6, -1.2, 0.7]
base_rpy = [0.1, 0.2, 1.3]
[noise]
place = 1e-4
turn = 1e-3
torque = 0.01
[[run]]
id = "poses"
samples = "poses.csv"
)",
                                           model);
  folder.write("experiment.toml", settings);
  const auto table = [&](const SerialArm<double>& arm) {
    std::string text =
        "q_command1,q_command2,q_command3,tip_x,tip_y,tip_z,tip_rx,tip_ry,tip_rz,torque1,torque2,torque3\n";
    for (int r = 0; r < 24; ++r) {
      const std::vector<double> q{1.2 * std::sin(1.0 + r), 0.9 * std::sin(2.0 * r), std::cos(3.0 * r)};
      const auto at = test::tip_pose(arm, q);
      const Eigen::AngleAxisd by(at.linear());
      const Eigen::Vector3d place = at.translation(), turn = by.angle() * by.axis();
      text += fmt::format("{},{},{},{},{},{},{},{},{},0,0,0\n", q[0], q[1], q[2], place[0], place[1],
                          place[2], turn[0], turn[1], turn[2]);
    }
    folder.write("poses.csv", text);
  };
  ArmReader arm;
  seen.base.setIdentity();
  seen.base.translate(Eigen::Vector3d(3.6, -1.2, 0.7));
  seen.base.rotate(Eigen::AngleAxisd(1.3, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
  table(seen);
  return arm.with_effects(diagnose::read_experiment(
      folder.path(), nullptr, [&](const std::string& file, const std::string& base, const std::string& tip) {
        return arm.read()((folder / std::filesystem::path(file).filename()).string(), base, tip);
      }));
}

}  // namespace

TEST_CASE("an arm without a correction stays byte by byte, wherever its bench has the base") {
  for (const ArmFile& one : arms) {
    CAPTURE(one.name);
    const Folder folder;
    folder.write(one.name, one.text);
    Model model{"as it is", on_bench(folder, one.name, arm_in(folder, one.name)), {}, folder / one.name};
    const SerialArm<double> file = read_arm(folder / one.name, {"base", "tip"}).nominal.arm;
    const Written same = written(model, format_of(model.source));
    folder.write(std::string("again-") + one.name, same.text);
    const SerialArm<double> again =
        read_arm(folder / (std::string("again-") + one.name), {"base", "tip"}).nominal.arm;
    CHECK(again.base.matrix() == file.base.matrix());
    CHECK(again.tip.matrix() == file.tip.matrix());
    for (std::size_t i = 0; i < file.size(); ++i)
      CHECK(again.links[i].frame.matrix() == file.links[i].frame.matrix());
  }
}

TEST_CASE("an arm's corrected file, read on the bench that gave it, predicts what was found: every row") {
  for (const ArmFile& one : arms) {
    const Folder folder;
    folder.write(one.name, one.text);
    const Study study(on_bench(folder, one.name, arm_in(folder, one.name)));
    std::set<std::string> carried;
    for (const EffectAt& at : possible_effects(study)) {
      CAPTURE(one.name);
      CAPTURE(at.name());
      const std::vector<double> amount = test::sizeable(study, at);
      const Model model =
          corrected_models(study, test::found(study, at, amount), folder / one.name).front().model;
      const Written file = written(model, format_of(model.source));
      if (std::any_of(file.effects.begin(), file.effects.end(), [](const Carried& c) { return !c.carried; }))
        continue;
      carried.insert(at.effect->id);
      const Folder again;
      again.write(one.name, file.text);
      const Prediction wanted = predict(study, {{at}}, amount);
      if (!wanted.reached) continue;
      // Turns are told from the nominal arm's: by another nominal arm they differ by the square of its turn,
      // half a hundredth of a radian here, beside noise of a thousandth.
      const Eigen::VectorXd found = study.residual(wanted),
                            left =
                                Study(on_bench(again, one.name, arm_in(folder, one.name))).nominal_residual();
      CHECK(test::rms(found - left) < 0.05);
    }
    for (const char* id : {"rest_angle", "tool_offset", "axis_shift", "link_mass"}) {
      CAPTURE(id);
      CHECK(carried.contains(id));
    }
  }
}

TEST_CASE("a column that bends is no part of a file of rigid links, which says with what rigidity it would") {
  for (const ArmFile& one : arms) {
    CAPTURE(one.name);
    const Folder folder;
    folder.write(one.name, one.text);
    Experiment bench = on_bench(folder, one.name, arm_in(folder, one.name));
    bench.effects.push_back({"slide_bending", 0, {{"EI", 1.5e5}}});
    const Written file = written({"bent", bench, {}, folder / one.name}, format_of(folder / one.name));
    REQUIRE(file.effects.size() == 1);
    CHECK_FALSE(file.effects[0].carried);
    CHECK(file.text.find("EI = 1.5e+05 N m^2") != std::string::npos);
  }
}

TEST_CASE(
    "a calibrated arm has its tip where it was solved for; its base is the tracker's matter, and the "
    "bench's") {
  Eigen::Isometry3d tracker = Eigen::Isometry3d::Identity();
  tracker.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()));
  tracker.pretranslate(Eigen::Vector3d(1, -2, 0.5));
  for (const ArmFile& one : arms) {
    CAPTURE(one.name);
    const Folder folder;
    folder.write(one.name, one.text);
    Experiment bench = on_bench(folder, one.name, arm_in(folder, one.name));
    Eigen::Isometry3d& tip = bench.arm_bench.points[0].at.frame;
    diagnose::Calibration found;
    found.frames.push_back(
        {diagnose::SolvedFrame::Of::tracker, "tracker", tracker, Eigen::Isometry3d::Identity(), {}, {}});
    found.frames.push_back({diagnose::SolvedFrame::Of::point, "tip", tip, tip, {}, {}});
    tip.translate(Eigen::Vector3d(0.02, -0.01, 0.03));
    found.frames.back().at = tip;
    bench.arm_bench.calibration = std::make_shared<const diagnose::Calibration>(found);
    const Model model{"calibrated", bench, {}, folder / one.name};
    folder.write(std::string("again-") + one.name, written(model, format_of(model.source)).text);
    const SerialArm<double> file = arm_in(folder, one.name),
                            again = arm_in(folder, std::string("again-") + one.name);
    // Files have twelve digits.
    CHECK((again.tip.matrix() - tip.matrix()).cwiseAbs().maxCoeff() < 1e-11);
    CHECK(again.base.matrix() == file.base.matrix());
    diagnose::NominalArm seen = *bench.arm;
    seen.arm.tip = tip;
    seen.arm.base = tracker * seen.arm.base;
    seen.arm.gravity = tracker.linear() * seen.arm.gravity;
    CHECK(written(model, Format::toml).text.find(arm_toml(seen)) != std::string::npos);
  }
}

}  // namespace plumbline::exchange
