#include "diagnose/rig/user_effects/stated_effect.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/user_effects/read_effects.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Starting = std::vector<std::vector<double>>;

/// A parameter in the user's words.
std::string told_parameter(const std::string& name, const std::string& bounds) {
  return "[effect.parameters." + name + "]\nunit = \"ratio\"\n" + bounds + "\n";
}

std::string effects_file(const std::string& acts, const std::string& parameters) {
  return "format = \"user-effects/1\"\n[[effect]]\nid = \"mine\"\nwords = \"something in joint {}\"\n" +
         acts + parameters;
}

const std::string at_one_joint = "where = \"one joint\"\ntorque = ",
                  any_joint = "where = \"every joint\"\ntorque = ";
const std::string one_scale = "scale = 0.5\nlow = -2\nhigh = 4",
                  shape_bounds = "scale = 1\nlow = 1\nhigh = 16";

StatedEffect effect_of(const std::string& acts, const std::string& parameters) {
  std::string text = effects_file(acts, parameters);
  if (acts.find("one joint") == std::string::npos) text.replace(text.find(" in joint {}"), 12, "");
  return parse_effects(text, "U").at(0);
}

/// The row that it becomes, and where fits of it start on this bench.
InitialGuesses guesses_on(const Study& study, const StatedEffect& stated) {
  return row_of(std::make_shared<StatedEffect>(stated))
      .initial_guesses({study.scales(), 0}, study.excitation());
}

std::string effects_fault(const std::string& text) {
  try {
    parse_effects(text, "U");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string defined_fault(const Experiment& experiment, const StatedEffect& stated) {
  try {
    require_defined(stated, Study(experiment));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

Experiment one_press() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 8, true);
  return experiment;
}

}  // namespace

TEST_CASE("a user effect is read with all its keys") {
  const StatedEffect stated =
      effect_of(at_one_joint + "\"k * a * d + b * Fx\"\n",
                told_parameter("a", one_scale + "\ntolerance = 0.25") + told_parameter("b", shape_bounds));
  CHECK(stated.place == "U:2");
  CHECK(stated.id == "mine");
  CHECK(stated.words == "something in joint {}");
  CHECK(stated.at_joint);
  REQUIRE(stated.parameters.size() == 2);
  CHECK(stated.parameters[0].name == "a");
  CHECK(stated.parameters[0].scale == 0.5);
  CHECK(stated.parameters[0].low == -2);
  CHECK(stated.parameters[0].high == 4);
  CHECK(stated.parameters[0].tolerance == 0.25);
  CHECK(stated.parameters[0].grows());
  CHECK_FALSE(stated.parameters[1].grows());
  CHECK(stated.parameters[1].tolerance == 0);
  CHECK(stated.uses("d"));
  CHECK(stated.uses("Fx"));
  CHECK_FALSE(stated.uses("s"));
  const StatedEffect reading = effect_of("[effect.reading]\nq2 = \"a\"\nq = \"a * q\"\nFy = \"a * t\"\n",
                                         told_parameter("a", one_scale));
  CHECK_FALSE(reading.at_joint);
  REQUIRE(reading.readings.size() == 3);
  for (const StatedReading& one : reading.readings) {
    if (one.key == "q2") CHECK((one.channel == Channel::Name::q && one.joint == 1U));
    if (one.key == "q") CHECK((one.channel == Channel::Name::q && !one.joint));
    if (one.key == "Fy") CHECK((one.channel == Channel::Name::Fy && !one.joint));
  }
  CHECK(reading.uses("t"));
  CHECK_FALSE(reading.uses("x"));
}

TEST_CASE("an invalid user effect is refused at its key") {
  const auto with = [](const std::string& bounds) {
    return effects_fault(effects_file(at_one_joint + "\"a\"\n", told_parameter("a", bounds)));
  };
  const std::string of = ": effect[1].parameters.a.";
  CHECK(with("scale = 0\nlow = -1\nhigh = 1") == "U:9" + of + "scale: found 0, expected a positive size");
  CHECK(with("scale = 1\nlow = 1\nhigh = 1") ==
        "U:11" + of + "high: found 1 above low = 1, expected low < high");
  CHECK(with("scale = 1\nlow = -1\nhigh = 0") ==
        "U:11" + of + "high: found 0, expected bounds that include zero and more, or are both positive");
  const std::string deviation = ", expected a positive standard deviation of a parameter that may be zero";
  CHECK(with("scale = 1\nlow = -1\nhigh = 1\ntolerance = 0") ==
        "U:12" + of + "tolerance: found 0" + deviation);
  CHECK(with("scale = 1\nlow = 0.5\nhigh = 1\ntolerance = 1") ==
        "U:12" + of + "tolerance: found 1" + deviation);
  CHECK(with("scale = 1\nlow = 0\nhigh = 1\ntolerance = 1").empty());
  CHECK(with("scale = 1\nlow = 0.5\nhigh = 1")
            .ends_with("expected a parameter whose bounds include zero, where the chain is nominal"));
  const auto named_by = [](const std::string& name) {
    return effects_fault(effects_file(at_one_joint + "\"a\"\n", told_parameter(name, one_scale)));
  };
  for (const char* taken : {"q", "run", "sin", "k"})
    CHECK(named_by(taken).find("a parameter of that name") != std::string::npos);
  const auto many = [](int count) {
    std::string sum = "p1", parameters;
    for (int i = 1; i <= count; ++i) {
      if (i > 1) sum += " + p" + std::to_string(i);
      parameters += told_parameter("p" + std::to_string(i), one_scale);
    }
    return effects_fault(effects_file(at_one_joint + "\"" + sum + "\"\n", parameters));
  };
  CHECK(many(8).empty());
  CHECK(many(9).find("9 parameters, expected at most 8: more follow anything") != std::string::npos);
  CHECK(effects_fault(effects_file(at_one_joint + "\"1\"\n", "[effect.parameters]\n"))
            .ends_with("found an empty table, expected a parameter or more"));
  CHECK(effects_fault(effects_file("where = \"here\"\ntorque = \"a\"\n", told_parameter("a", one_scale)))
            .ends_with("where: found \"here\", expected \"every joint\" or \"one joint\""));
  CHECK(effects_fault(effects_file("where = \"one joint\"\n[effect.reading]\nx = \"a\"\n",
                                   told_parameter("a", one_scale)))
            .ends_with("found a place, expected none for a correction of readings"));
  CHECK(effects_fault(effects_file("[effect.reading]\n", told_parameter("a", one_scale)))
            .ends_with("reading: found an empty table, expected a reading or more"));
  CHECK(effects_fault(effects_file("size = 1\n" + at_one_joint + "\"a\"\n", told_parameter("a", one_scale)))
            .starts_with("U:5: effect[1].size: found an unknown key"));
}

TEST_CASE("words contain the braces of a joint once, for an effect at a joint") {
  const auto words = [](const std::string& text, const std::string& where) {
    return effects_fault("format = \"user-effects/1\"\n[[effect]]\nid = \"mine\"\nwords = \"" + text +
                         "\"\nwhere = \"" + where + "\"\ntorque = \"a\"\n" + told_parameter("a", one_scale));
  };
  CHECK(words("{} in a joint", "one joint").empty());
  CHECK(words("in joint {}", "one joint").empty());
  for (const char* wrong : {"a joint", "in {} and {}", "in { {}", "in {}}"})
    CHECK(words(wrong, "one joint").ends_with("expected one {} where the joint's number goes"));
  CHECK(words("a joint", "every joint").empty());
  for (const char* wrong : {"in joint {}", "in }"})
    CHECK(words(wrong, "every joint").ends_with("expected no braces"));
}

TEST_CASE("fits of a user effect start one scale to both sides, and from zero where that is informative") {
  const Study study(one_press());
  const StatedEffect plain = effect_of(any_joint + "\"a * d\"\n", told_parameter("a", one_scale));
  CHECK(guesses_on(study, plain).points == Starting{{0}, {0.5}, {-0.5}});
  CHECK(guesses_on(study, plain).refined == 2);
  // within bounds, and not twice
  const StatedEffect one_sided =
      effect_of(any_joint + "\"a * d\"\n", told_parameter("a", "scale = 5\nlow = 0\nhigh = 4"));
  CHECK(guesses_on(study, one_sided).points == Starting{{0}, {4}});
  // what depends on the direction of motion does not start from nothing
  const StatedEffect directed = effect_of(any_joint + "\"a * s\"\n", told_parameter("a", one_scale));
  CHECK(guesses_on(study, directed).points == Starting{{0.5}, {-0.5}});
  const StatedEffect two = effect_of(any_joint + "\"a * d + b * d^3\"\n",
                                     told_parameter("a", one_scale) + told_parameter("b", one_scale));
  CHECK(guesses_on(study, two).points == Starting{{0, 0}, {0.5, 0.5}, {-0.5, -0.5}});
}

TEST_CASE("a shape parameter starts at five places between its bounds, three beside another") {
  const Study study(one_press());
  const StatedEffect shaped = effect_of(any_joint + "\"a * d * c\"\n",
                                        told_parameter("a", one_scale) + told_parameter("c", shape_bounds));
  const Starting from = guesses_on(study, shaped).points;
  REQUIRE(from.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(from[i][0] == (i % 2 == 0 ? 0.5 : -0.5));
    // by ratios of its bounds, 16: 2^0.4, 2^1.2, 2^2, ...
    CHECK(from[i][1] == close_to(std::exp2(0.4 + 0.8 * static_cast<double>(i / 2))));
  }
  const StatedEffect two_shapes = effect_of(
      any_joint + "\"a * d * c * b\"\n",
      told_parameter("a", one_scale) + told_parameter("b", shape_bounds) + told_parameter("c", shape_bounds));
  CHECK(guesses_on(study, two_shapes).points.size() == 50);
  const StatedEffect three_shapes =
      effect_of(any_joint + "\"a * d * c * b * e\"\n",
                told_parameter("a", one_scale) + told_parameter("b", shape_bounds) +
                    told_parameter("c", shape_bounds) + told_parameter("e", shape_bounds));
  CHECK(guesses_on(study, three_shapes).points == Starting{{0.5, 4, 4, 4}, {-0.5, 4, 4, 4}});
}

TEST_CASE("the row of a user effect: ranges, dissipation, perturbation, conditions") {
  const auto row = [](const StatedEffect& stated) { return row_of(std::make_shared<StatedEffect>(stated)); };
  const Study study(one_press());
  const StatedEffect spring =
      effect_of(at_one_joint + "\"k * a * d * c\"\n",
                told_parameter("a", one_scale + "\ntolerance = 0.25") + told_parameter("c", shape_bounds));
  const Effect of_spring = row(spring);
  CHECK(of_spring.at_joint);
  CHECK_FALSE(of_spring.dissipates);
  CHECK(of_spring.perturbation.growing == std::vector<std::size_t>{0});
  CHECK_FALSE(of_spring.perturbation.large_step);
  const std::vector<ParameterRange> ranges = of_spring.parameters({study.scales(), 0});
  REQUIRE(ranges.size() == 2);
  CHECK(ranges[0].name == "a");
  CHECK(ranges[0].unit == "ratio");
  CHECK(ranges[0].scale == 0.5);
  CHECK(ranges[0].low == -2);
  CHECK(ranges[0].high == 4);
  CHECK(ranges[0].tolerance == 0.25);
  CHECK(ranges[1].low == 1);
  // an effect proportional to the joint's stiffness is zero at a passive joint; others act everywhere
  CharacteristicScales passive = study.scales();
  passive.joint_stiffness[1] = 0;
  CHECK(of_spring.possible({passive, 0}));
  CHECK_FALSE(of_spring.possible({passive, 1}));
  const Effect drag = row(effect_of(at_one_joint + "\"a * s\"\n", told_parameter("a", one_scale)));
  CHECK(drag.dissipates);
  CHECK(drag.perturbation.large_step);
  CHECK(drag.perturbation.growing.empty());
  CHECK(drag.possible({passive, 1}));
  const Effect everywhere = row(effect_of(any_joint + "\"k * a * d\"\n", told_parameter("a", one_scale)));
  CHECK_FALSE(everywhere.at_joint);
  CHECK(everywhere.possible({passive, 1}));
  // time is one where there is a clock
  const Effect ages = row(effect_of(any_joint + "\"a * t\"\n", told_parameter("a", one_scale)));
  CHECK(ages.dissipates);
  CharacteristicScales timed = study.scales();
  timed.clock = false;
  CHECK_FALSE(ages.possible({timed, 0}));
  timed.clock = true;
  CHECK(ages.possible({timed, 0}));
  const Effect gain =
      row(effect_of("[effect.reading]\nx = \"a\"\nFy = \"a * t\"\n", told_parameter("a", one_scale)));
  CHECK_FALSE(gain.dissipates);
  timed.measured = {};
  CHECK_FALSE(gain.possible({timed, 0}));
  timed.measured[static_cast<std::size_t>(Channel::Name::Fy)] = true;
  CHECK(gain.possible({timed, 0}));
  // what is read otherwise on the way back has a loop, but nothing sticks
  const StatedEffect reversal =
      effect_of("[effect.reading]\nFx = \"a * s\"\n", told_parameter("a", one_scale));
  CHECK(row(reversal).dissipates);
  CHECK_FALSE(row(reversal).perturbation.large_step);
  CHECK(guesses_on(study, reversal).points == Starting{{0}, {0.5}, {-0.5}});
}

TEST_CASE("a user effect acts at its joint, at every joint, or on its channels") {
  const Study study(one_press());
  const double values[] = {0.75};
  const auto added = [&](const StatedEffect& stated, std::size_t joint) {
    Rig rig = study.nominal_rig();
    row_of(std::make_shared<StatedEffect>(stated)).add({rig, joint, study.scales(), {0, -1}, values});
    return rig;
  };
  const Rig one = added(effect_of(at_one_joint + "\"a * d\"\n", told_parameter("a", one_scale)), 1);
  REQUIRE(one.stated_torques.size() == 1);
  CHECK(one.stated_torques[0].joint == 1);
  CHECK(one.stated_torques[0].parameters == std::vector<double>{0.75});
  CHECK(one.stated_torques[0].value({0, 0.5, 0, 0, {0, 0}}, 1) == 0.375);
  const Rig all = added(effect_of(any_joint + "\"a * d\"\n", told_parameter("a", one_scale)), 0);
  REQUIRE(all.stated_torques.size() == 3);
  CHECK(all.stated_torques[2].joint == 2);
  const Rig read = added(effect_of("[effect.reading]\nq3 = \"a\"\n", told_parameter("a", one_scale)), 0);
  CHECK(read.stated_torques.empty());
  REQUIRE(read.stated_corrections.size() == 1);
  CHECK(read.stated_corrections[0].applies_to(Channel(Channel::Name::q, 2)));
  CHECK_FALSE(read.stated_corrections[0].applies_to(Channel(Channel::Name::q, 1)));
}

TEST_CASE("an expression is evaluated along the nominal model, and zero for amounts of zero") {
  const Experiment experiment = one_press();
  const auto torque = [&](const std::string& expression) {
    return defined_fault(experiment,
                         effect_of(any_joint + "\"" + expression + "\"\n", told_parameter("a", one_scale)));
  };
  CHECK(torque("a * d").empty());
  CHECK(torque("a * d + 0.5") ==
        "U:2: mine.torque: found the value 0.5 in joint 1 at reading 0 of press-1, with a = 0, expected "
        "zero, where "
        "all parameters that may be zero are: the nominal model");
  CHECK(torque("a / d").find("expected a finite number at every reading of the nominal model") !=
        std::string::npos);
  CHECK(torque("a == 0 ? 0 : sqrt(0 - 1)").find("with a = 0.5, expected a finite number") !=
        std::string::npos);
  // of several parameters each is said, what shapes the effect as it is tried
  CHECK(
      defined_fault(experiment, effect_of(any_joint + "\"a * d + c\"\n",
                                          told_parameter("a", one_scale) + told_parameter("c", shape_bounds)))
          .find("the value 1.32 in joint 1 at reading 0 of press-1, with a = 0, c = 1.32,") !=
      std::string::npos);
  // of either direction, each joint, at its own time, stiffness and force
  CHECK(torque("a + (s < 0 ? 1 : 0)").find("the value 1 in joint 1 at reading 0") != std::string::npos);
  CHECK(torque("a + (k < 1.2 ? 1 : 0)").find("the value 1 in joint 3 at reading 0") != std::string::npos);
  CHECK(torque("a + (t > 5 ? 1 : 0)").find("the value 1 in joint 1 at reading 3") != std::string::npos);
  CHECK(torque("a + (abs(Fx) > 1e-6 ? 1 : 0)").find("at reading 1 of") != std::string::npos);
  CHECK(torque("a + (q > 0.35 && abs(d) < 1e-9 ? 1 : 0)").find("in joint 3 at reading 0") !=
        std::string::npos);
  const auto reading = [&](const std::string& key, const std::string& expression) {
    return defined_fault(experiment, effect_of("[effect.reading]\n" + key + " = \"" + expression + "\"\n",
                                               told_parameter("a", one_scale)));
  };
  CHECK(reading("Fx", "a * Fx").empty());
  CHECK(
      reading("Fx", "a + t") ==
      "U:2: mine.reading.Fx: found the value 2 at reading 1 of press-1, with a = 0, expected zero, where all "
      "parameters that may be zero are: the nominal model");
  CHECK(reading("x", "a + t").empty());  // which is not measured
  CHECK(reading("q3", "a").empty());
  CHECK(reading("q4", "a") == "U:2: mine.reading: found q4, expected q, or q1 to q3: the chain has 3 joints");
  CHECK(reading("q2", "a + (q < 0 ? 0 : 1)").empty());
  // of either direction, and of each joint's deflection
  for (const char* key : {"Fx", "q3"}) {
    CHECK(reading(key, "a * s").empty());
    for (const char* way : {"s > 0", "s < 0"})
      CHECK(reading(key, std::string("a + (") + way + " ? 1 : 0)").find("the value 1 at reading 0") !=
            std::string::npos);
  }
  CHECK(reading("q", "a / d").find("expected a finite number at every reading") != std::string::npos);
  CHECK(reading("q2", "a + (abs(d) > 1e-3 ? 1 : 0)").find("the value 1 at reading 1") != std::string::npos);
  CHECK(reading("q", "a + (q > 0.39 ? 1 : 0)").find("the value 1 at reading 0") != std::string::npos);
  // a reading whose command is not known has no value to ask for
  Experiment holed = experiment;
  holed.runs[0].readings[3][column_x] = std::nan("");
  CHECK(defined_fault(holed, effect_of(any_joint + "\"a * d\"\n", told_parameter("a", one_scale))).empty());
  CHECK(defined_fault(holed, effect_of("[effect.reading]\nFx = \"a * Fx\"\n", told_parameter("a", one_scale)))
            .empty());
  Experiment unreachable = experiment;
  for (Reading& one : unreachable.runs[0].readings) one[column_x] = 5;
  CHECK(defined_fault(unreachable, effect_of(any_joint + "\"a + 1\"\n", told_parameter("a", one_scale)))
            .empty());
}

TEST_CASE("user effects follow those of the catalogue, and are asked first") {
  const StatedEffect good = effect_of(any_joint + "\"a * d\"\n", told_parameter("a", one_scale)),
                     bad = effect_of(any_joint + "\"a * d + 1\"\n", told_parameter("a", one_scale));
  const Study study = study_with(one_press(), {good});
  REQUIRE(study.effects().size() == catalogue().size() + 1);
  CHECK(study.effects().back()->id == "user:mine");
  CHECK_THROWS_AS((void)study_with(one_press(), {bad}), Error);
}
