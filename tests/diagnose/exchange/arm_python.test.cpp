#include <doctest/doctest.h>

#include <iterator>
#include <limits>
#include <plumbline/arm/arm_equilibrium.hpp>
#include <sstream>

#include "diagnose/exchange/arm_toml.hpp"
#include "diagnose/exchange/corrected_arm.hpp"
#include "support/files/child_process.hpp"
#include "tests/folder.hpp"

namespace plumbline::exchange {
namespace {

/// A turning, a sliding and a turning joint that yield, and a link that bends.
SerialArm<double> soft_arm() {
  SerialArm<double> arm;
  arm.base.translate(Eigen::Vector3d(0.1, 0.2, 0.3));
  arm.links.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    ArmLink<double>& link = arm.links[i];
    link.frame.translate(Eigen::Vector3d(0.3, 0.1, 0.05));
    link.frame.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 2) / 3));
    link.axis = i == 1 ? Eigen::Vector3d(1, 0, 0) : Eigen::Vector3d(0, 0.6, 0.8);
    link.kind = i == 1 ? JointKind::prismatic : JointKind::revolute;
    link.joint_compliance = 1e-4;
    link.mass = 2;
    link.centre = {0.1, 0.02, 0};
  }
  arm.links[1].compliance.diagonal() << 1e-6, 2e-6, 3e-6, 1e-4, 2e-4, 3e-4;
  arm.tip.translate(Eigen::Vector3d(0.2, 0, 0.1));
  return arm;
}

std::vector<double> numbers_of(const std::string& code, const Folder& folder) {
  const files::Ended ended =
      files::run_program({PLUMBLINE_SYSTEM_PYTHON, "-c", code}, "", std::nullopt, folder / "");
  REQUIRE_MESSAGE(ended.failure.empty(), ended.err);
  std::istringstream out(ended.out);
  return {std::istream_iterator<double>(out), {}};
}

}  // namespace

TEST_CASE("the function in Python gives the pose of the core's equilibrium, under a wrench and a payload") {
  CorrectedArm corrected{"soft", "arm.urdf", {}, soft_arm()};
  corrected.payload = {1.5, {0.05, 0.1, 0}};
  const Folder folder;
  folder.write("soft.py", as_python(corrected).text);
  const std::vector<double> rows = numbers_of(
      "import soft\nfor row in soft.tip_pose([0.3, 0.1, -0.4], [5, 6, 7], [1, 2, 3]): "
      "print(*(repr(float(x)) for x in row))",
      folder);
  REQUIRE(rows.size() == 16);
  const SerialArm<double>& arm = corrected.arm;
  const OnLink<double> tip{2, arm.tip};
  OnLink<double> payload = tip;
  payload.frame.translate(corrected.payload.centre);
  const std::vector<ArmWrench<double>> wrenches{{tip, {5, 6, 7}, {1, 2, 3}},
                                                {payload, corrected.payload.mass * arm.gravity, {0, 0, 0}}};
  const Vector<double> command = Eigen::Vector3d(0.3, 0.1, -0.4);
  const Pose<double> pose = ArmPosture<double>(arm, equilibrium(arm, command, wrenches)).of(tip);
  constexpr double rounding = 1e-12;  // of iterations that stop at 1e-14
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c < 4; ++c)
      CHECK(std::abs(rows[static_cast<std::size_t>(4 * r + c)] - pose(r, c)) < rounding);
}

TEST_CASE("an arm as an experiment has it: rounded numbers, quoted names, no limits where there are none") {
  diagnose::NominalArm nominal{soft_arm(), "base", "tip", {"a \"b\"", "c", "d"}, {"l", "m", "n"}, {}};
  constexpr double endless = std::numeric_limits<double>::infinity();
  nominal.limits = {{-1, 2}, {-endless, endless}, {0, 1}};
  nominal.arm.links[0].frame.translation() = Eigen::Vector3d(0.1 + 0.2, 1e-17, 0);
  const std::string text = arm_toml(nominal);
  CHECK(text.find("name = \"a \\\"b\\\"\"\n") != std::string::npos);
  CHECK(text.find("xyz = [0.3, 0, 0]\n") != std::string::npos);
  CHECK(text.find("stiffness = 10000  # N/m\n") != std::string::npos);
  CHECK(text.find("limits = [-1, 2]\n") != std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
}

}  // namespace plumbline::exchange
