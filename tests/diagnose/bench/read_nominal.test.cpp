#include "diagnose/bench/read_nominal.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

const std::string two_nominal_links = "[nominal]\nlink_length = [0.3, 0.2]\njoint_stiffness = [2.0, 0.0]\n";

NominalChain chain_of(const std::string& more) {
  return parse_nominal(two_nominal_links + more, "N");
}

std::string chain_fault(const std::string& toml) {
  try {
    parse_nominal(toml, "N");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The nominal chain of two links with this text, from line 4 on.
std::string fault_beside(const std::string& more) {
  return chain_fault(two_nominal_links + more);
}

const std::string law_at_two =
    "[[nominal.torque_law]]\njoint = 2\ndeflection = [-0.1, 0.0, 0.2]\ntorque = [1, 0, -2]\n";

}  // namespace

TEST_CASE("a nominal chain: lengths, springs, and defaults for the rest") {
  const NominalChain chain = chain_of("");
  CHECK(chain.link_length == std::vector{0.3, 0.2});
  CHECK(chain.joint_stiffness == std::vector{2.0, 0.0});
  CHECK(chain.link_mass == std::vector{0.0, 0.0});
  CHECK(chain.gravity == std::array{0.0, 0.0});
  CHECK(chain.rest.empty());
  CHECK(chain.plain());
  const NominalChain heavy = chain_of("link_mass = [0, 0.5]\ngravity = [0, -9.81]\nrest = [0.1, -0.2]\n");
  CHECK(heavy.link_mass == std::vector{0.0, 0.5});
  CHECK(heavy.gravity == std::array{0.0, -9.81});
  CHECK(heavy.rest == std::vector{0.1, -0.2});
  // as chain files spell it
  const NominalChain same = parse_nominal("[nominal]\nlengths = [0.3, 0.2]\nstiffness = [2, 0]\n", "N");
  CHECK(same.link_length == chain.link_length);
  CHECK(same.joint_stiffness == chain.joint_stiffness);
}

TEST_CASE("an invalid nominal chain is refused at its key") {
  CHECK(fault_beside("lengths = [0.3, 0.2]\n") ==
        "N:4: nominal.lengths: found both link_length and lengths, expected one of the two, which mean the "
        "same");
  CHECK(fault_beside("stiffness = [2, 1]\n").find("both joint_stiffness and stiffness") != std::string::npos);
  CHECK(chain_fault("[nominal]\nlink_length = [0.3, 0]\njoint_stiffness = [2, 1]\n") ==
        "N:2: nominal.link_length[2]: found 0, expected a positive length");
  CHECK(chain_fault("[nominal]\nlink_length = [0.3, 1]\njoint_stiffness = [2, -1]\n") ==
        "N:3: nominal.joint_stiffness[2]: found -1, expected zero (passive) or a positive stiffness");
  CHECK(fault_beside("link_mass = [0, -1]\n") ==
        "N:4: nominal.link_mass[2]: found -1, expected zero or a positive mass");
  CHECK(fault_beside("rest = [0]\n") == "N:4: nominal.rest: found 1 values, expected a list of 2 numbers");
  CHECK(fault_beside("mass = [0]\n").starts_with("N:4: nominal.mass: found an unknown key"));
  CHECK(fault_beside("[other]\n").starts_with("N:4: other: found an unknown key"));
  CHECK(chain_fault("") == "N: nominal: found no such key, expected a table [nominal]");
}

TEST_CASE("effects of a nominal chain: an id, a joint or none, parameters") {
  const NominalChain chain = chain_of(
      "[[nominal.effect]]\nid = \"backlash\"\njoint = 2\nparameters = { b = 0.01 }\n"
      "[[nominal.effect]]\nid = \"force_bias\"\nparameters = { bx = 1, by = -2 }\n");
  REQUIRE(chain.effects.size() == 2);
  CHECK_FALSE(chain.plain());
  CHECK(chain.effects[0].label() == "backlash(2)");
  CHECK(chain.effects[0].parameters == std::map<std::string, double>{{"b", 0.01}});
  CHECK(chain.effects[1].label() == "force_bias");
  CHECK(chain.effects[1].parameters == std::map<std::string, double>{{"bx", 1}, {"by", -2}});
  CHECK(fault_beside("[[nominal.effect]]\nid = \"backlash\"\nsize = 2\n")
            .starts_with("N:6: nominal.effect[1].size: found an unknown key"));
}

TEST_CASE("a torque law: knots that rise, sliders of three kinds, arms") {
  const NominalChain chain = chain_of(law_at_two + R"([[nominal.torque_law.sliders]]
slips_at = 0.01
torque = 0.5
[[nominal.torque_law.sliders]]
slips_at = 0.02
growth = 0.25
[[nominal.torque_law.sliders]]
slips_at = 0.03
deflection = [0, 1]
torque = [2, 3]
[[nominal.torque_law.arms]]
time_constant = 7
stiffness = 0.125
)");
  REQUIRE(chain.laws.size() == 1);
  const FreeLaw& read = chain.laws[0];
  CHECK(read.joint == 2);
  CHECK(read.knots == std::vector<FreeLaw::Knot>{{-0.1, 1}, {0, 0}, {0.2, -2}});
  CHECK(read.sliders == std::vector<FreeLaw::Slider>{
                            {0.01, 0.5, 0, {}}, {0.02, 0, 0.25, {}}, {0.03, 0, 0, {{0, 2}, {1, 3}}}});
  CHECK(read.arms == std::vector<FreeLaw::Arm>{{7, 0.125}});
}

TEST_CASE("an invalid torque law is refused at its key") {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = law_at_two;
    return fault_beside(text.replace(text.find(from), from.size(), to));
  };
  CHECK(with("joint = 2\n", "") ==
        "N:4: nominal.torque_law[1].joint: found no such key, expected a joint from 1 to 2");
  CHECK(with("joint = 2", "joint = 3") ==
        "N:5: nominal.torque_law[1].joint: found 3, expected a joint from 1 to 2");
  CHECK(with("0.0, 0.2", "-0.1, 0.2").ends_with("expected numbers that rise"));
  CHECK(with("0.0, 0.2", "0.3, 0.2").ends_with("expected numbers that rise"));
  CHECK(with("[1, 0, -2]", "[1, 0]").ends_with("found 2 values, expected a list of 3 numbers"));
  const auto slider = [](const std::string& keys) {
    return fault_beside(law_at_two + "[[nominal.torque_law.sliders]]\n" + keys);
  };
  const std::string of_slider = ": nominal.torque_law[1].sliders[1].";
  CHECK(slider("slips_at = 0\ntorque = 1\n") ==
        "N:9" + of_slider + "slips_at: found 0, expected a positive number");
  CHECK(slider("slips_at = 0.1\ntorque = 0\n") ==
        "N:10" + of_slider + "torque: found 0, expected a positive number");
  CHECK(slider("slips_at = 0.1\ngrowth = -1\n") ==
        "N:10" + of_slider + "growth: found -1, expected a positive number");
  CHECK(slider("slips_at = 0.1\n") == "N:8: found neither, expected either torque or growth");
  CHECK(slider("slips_at = 0.1\ntorque = 1\ngrowth = 1\n") ==
        "N:8: found both, expected either torque or growth");
  CHECK(slider("slips_at = 0.1\ntorque = 1\nstick = 1\n")
            .starts_with("N:11" + of_slider + "stick: found an unknown"));
  const auto arm = [](const std::string& keys) {
    return fault_beside(law_at_two + "[[nominal.torque_law.arms]]\n" + keys);
  };
  const std::string of_arm = ": nominal.torque_law[1].arms[1].";
  CHECK(arm("time_constant = 0\nstiffness = 1\n") ==
        "N:9" + of_arm + "time_constant: found 0, expected a positive number of seconds");
  CHECK(arm("time_constant = 1\nstiffness = 0\n") ==
        "N:10" + of_arm + "stiffness: found 0, expected a positive stiffness");
  CHECK(
      arm("time_constant = 1\nstiffness = 1\nx = 1\n").starts_with("N:11" + of_arm + "x: found an unknown"));
}
