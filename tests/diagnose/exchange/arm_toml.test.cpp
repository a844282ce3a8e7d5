#include <doctest/doctest.h>

#include <limits>

#include "diagnose/exchange/arm_toml.hpp"

namespace plumbline::exchange {

TEST_CASE("an arm as an experiment has it: rounded numbers, quoted names, no limits where there are none") {
  constexpr double endless = std::numeric_limits<double>::infinity();
  SerialArm<double> arm;
  arm.links.resize(3);
  for (ArmLink<double>& link : arm.links) link.joint_compliance = 1e-4;
  arm.links[0].frame.translate(Eigen::Vector3d(0.1 + 0.2, 1e-17, 0));
  arm.links[1].kind = JointKind::prismatic;
  const diagnose::NominalArm nominal{.arm = arm,
                                     .base = "base",
                                     .tip = "tip",
                                     .joint = {"a \"b\"", "c", "d"},
                                     .link = {"l", "m", "n"},
                                     .limits = {{-1, 2}, {-endless, endless}, {0, 1}}};
  const std::string text = arm_toml(nominal);
  CHECK(text.find("name = \"a \\\"b\\\"\"\n") != std::string::npos);
  CHECK(text.find("xyz = [0.3, 0, 0]\n") != std::string::npos);
  CHECK(text.find("stiffness = 10000  # N/m\n") != std::string::npos);
  CHECK(text.find("limits = [-1, 2]\n") != std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
}

}  // namespace plumbline::exchange
