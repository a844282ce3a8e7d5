#include "diagnose/screening/conventions.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <plumbline/base/error.hpp>
#include <random>
#include <utility>

#include "diagnose/bench/conversion.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/screening/physical.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/screening/slips.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Spoil forces_over(double unit) {
  return each_reading([unit](Reading& r) { r[column_Fx] /= unit, r[column_Fy] /= unit; });
}

std::vector<std::string> names(const SuspectedConvention& suspected) {
  std::vector<std::string> all{suspected.what + " like " + suspected.looks_like};
  all.insert(all.end(), suspected.alternatives.begin(), suspected.alternatives.end());
  return all;
}

/// A full bench whose joint 2 is a tenth stiffer than nominal, so that there is a gap beside the wrong
/// convention.
Experiment stiffer_bench() {
  return measured(full_bench(), only("joint_stiffness", 2), {0.1}, 5);
}

}  // namespace

TEST_CASE("a wrong unit, sign, axis or order is named where there is a gap") {
  constexpr double degree = 57.29577951308232;
  const std::vector<std::pair<std::string, Spoil>> slips{
      {"Fx, Fy like kgf", forces_over(9.80665)},
      {"Fx, Fy like lbf", forces_over(4.4482216)},
      {"Fx, Fy like kN", forces_over(1e3)},
      {"Fx, Fy like mN", forces_over(1e-3)},
      {"Fx, Fy like forces of the opposite sign", forces_over(-1)},
      {"Fx, Fy like forces with x mirrored", each_reading([](Reading& r) { r[column_Fx] = -r[column_Fx]; })},
      {"Fx, Fy like forces with y mirrored", each_reading([](Reading& r) { r[column_Fy] = -r[column_Fy]; })},
      {"Fx, Fy like forces with x and y swapped",
       each_reading([](Reading& r) { std::swap(r[column_Fx], r[column_Fy]); })},
      {"x, y, Fx, Fy like axes with y mirrored",
       each_reading([](Reading& r) { r[column_y] = -r[column_y], r[column_Fy] = -r[column_Fy]; })},
      {"joint_stiffness like N mm/rad",
       [](Experiment& e) {
         for (double& k : e.joint_stiffness) k *= 1e3;
       }},
      {"joint_stiffness like N m/deg",
       [](Experiment& e) {
         for (double& k : e.joint_stiffness) k /= degree;
       }},
      {"rest like degrees", each_rest([](std::vector<double>& rest) {
         for (double& a : rest) a *= degree;
       })},
      {"rest like angles of the opposite sign", each_rest([](std::vector<double>& rest) {
         for (double& a : rest) a = -a;
       })},
      {"rest like absolute angles", each_rest([](std::vector<double>& rest) {
         for (std::size_t i = 1; i < rest.size(); ++i) rest[i] += rest[i - 1];
       })},
      {"rest like angles in the reverse order",
       each_rest([](std::vector<double>& rest) { std::reverse(rest.begin(), rest.end()); })},
      {"q like angles of the opposite sign",
       each_reading([](Reading& r) { each_angles(r, [](std::vector<double>& q) { scale(q, -1); }); })},
  };
  REQUIRE_FALSE(suspected_convention(Study(stiffer_bench())));
  for (const auto& [expected, spoil] : slips) {
    CAPTURE(expected);
    Experiment experiment = stiffer_bench();
    spoil(experiment);
    const auto suspected = suspected_convention(Study(experiment));
    REQUIRE(suspected);
    const std::vector<std::string> all = names(*suspected);
    CAPTURE(all.front());
    CHECK(std::find(all.begin(), all.end(), expected) != all.end());
    CHECK(all.size() <= 5);
  }
}

TEST_CASE("axes and angles that explain the first readings are named beside any gap") {
  // Two joints a third as stiff as believed, one that bends the chain at rest and a load cell that reads
  // half.
  const std::vector<std::pair<std::string, Spoil>> slips{
      {"x, y, Fx, Fy like axes with y mirrored",
       each_reading([](Reading& r) { r[column_y] = -r[column_y], r[column_Fy] = -r[column_Fy]; })},
      {"x, y, Fx, Fy like axes with x mirrored",
       each_reading([](Reading& r) { r[column_x] = -r[column_x], r[column_Fx] = -r[column_Fx]; })},
      {"x, y, Fx, Fy like axes with x and y swapped", each_reading([](Reading& r) {
         std::swap(r[column_x], r[column_y]), std::swap(r[column_Fx], r[column_Fy]);
       })},
      {"rest like angles in the reverse order",
       each_rest([](std::vector<double>& rest) { std::reverse(rest.begin(), rest.end()); })},
  };
  const Candidate soft{{{"joint_stiffness", 1}, {"joint_stiffness", 3}, "force_gain"}};
  const Experiment gap = measured(full_bench(), soft, {-0.5, -0.5, -0.2}, 5);
  REQUIRE_FALSE(suspected_convention(Study(gap)));
  for (const auto& [expected, spoil] : slips) {
    CAPTURE(expected);
    Experiment experiment = gap;
    spoil(experiment);
    const auto suspected = suspected_convention(Study(experiment));
    REQUIRE(suspected);
    const std::vector<std::string> all = names(*suspected);
    CHECK(std::find(all.begin(), all.end(), expected) != all.end());
    CHECK(suspected->start_error_as_read > 0.1);
    CHECK(suspected->start < 0.01 * suspected->start_error_as_read);
  }
}

TEST_CASE("axes are named where only one force component is measured") {
  Experiment experiment = stiffer_bench();
  for (Run& run : experiment.runs)
    if (run.holds_end_point())
      for (Reading& r : run.readings)
        r[column_Fx] = std::exchange(r[column_Fy], std::numeric_limits<double>::quiet_NaN());
  const auto suspected = suspected_convention(Study(experiment));
  REQUIRE(suspected);
  const std::vector<std::string> all = names(*suspected);
  CHECK(std::find(all.begin(), all.end(), "Fx, Fy like forces with x and y swapped") != all.end());
}

TEST_CASE("a straight column on the other branch, softer than believed, is not mirrored") {
  Experiment column = three_links();
  column.joint_stiffness = {2.0, 1.5, 1.0};
  load(column, {0, 0, 0}, {0, 0}, {-3.2, 0}, 30);
  press(column, {0.005, -0.004, 0.003}, {-0.08, 0}, 25, true);
  for (const double softer : {0.0, -0.2, -0.4})
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(softer);
      CAPTURE(sign);
      const Candidate truth{{"rest_spread", {"joint_stiffness", 2}}};
      const Experiment read = measured(column, truth, {sign * 0.012, -sign * 0.009, sign * 0.006, softer}, 3);
      CHECK_FALSE(suspected_convention(Study(read)));
    }
}

TEST_CASE("a factor of a thousand is named beside a gap of a quarter of the forces") {
  for (const double stiffer : {0.2, 0.4}) {
    CAPTURE(stiffer);
    Experiment experiment = measured(full_bench(), only("stiffness_scale"), {stiffer}, 5);
    forces_over(1e3)(experiment);
    const auto suspected = suspected_convention(Study(experiment));
    REQUIRE(suspected);
    CHECK(suspected->looks_like == "kN");
  }
}

TEST_CASE("one run in another unit is named alone") {
  Experiment experiment = stiffer_bench();
  for (Reading& r : experiment.runs[1].readings) r[column_Fx] /= 9.80665, r[column_Fy] /= 9.80665;
  const auto suspected = suspected_convention(Study(experiment));
  REQUIRE(suspected);
  CHECK(suspected->runs == std::vector<std::string>{"press-2"});
  CHECK(suspected->looks_like == "kgf");
}

TEST_CASE("a decimal point that went astray in one run is named with its factor, and not as a unit nearby") {
  const auto doubt_of = [](double share, std::size_t from) {
    Experiment lever = three_links();
    lever.link_length = {0.2};
    lever.joint_stiffness = {2};
    lever.link_mass = {0};
    lever.bench.plane = Bench::Plane::horizontal;
    lever.noise = {1e-5, 1e-5, 0, 0, 2e-4};
    for (int run = 0; run < 2; ++run) load(lever, {0}, {0, 0}, {0, 7.5}, 30);
    Experiment read = measured(lever, {}, {}, 5);
    for (std::size_t r = from; r < 2; ++r)
      for (Reading& reading : read.runs[r].readings) reading[column_Fx] *= share, reading[column_Fy] *= share;
    return suspected_convention(Study(read));
  };
  for (const auto& [share, words] : {std::pair{10.0, "numbers ten times as large"},
                                     {0.1, "numbers a tenth as large"},
                                     {100.0, "numbers a hundred times as large"},
                                     {1 / 9.80665, "kgf"}}) {
    CAPTURE(share);
    const auto doubt = doubt_of(share, 1);
    REQUIRE(doubt);
    CHECK(doubt->runs == std::vector<std::string>{"load-2"});
    CHECK(doubt->looks_like == words);
    CHECK(doubt->alternatives.empty());
  }
  CHECK(doubt_of(10, 1)->remedy == "columns.Fx.unit and columns.Fy.unit = \"0.1 N\"");
  CHECK_FALSE(doubt_of(5, 1));
}

TEST_CASE("nothing is asked where the answer would mend half of the gap") {
  // Degrees would make a misfit of 0.9 of the readings into one of 0.45: the model is wrong either way.
  Experiment bench = three_links();
  bench.noise[Channel::Name::q] = 1e-3;
  load(bench, {0.3, 0.2, 0.1}, {0, 0}, {0, 1.5}, 20);
  Experiment read = measured(bench, only("stiffness_scale"), {0.8}, 5);
  for (Reading& reading : read.runs[0].readings)
    for (std::size_t j = 0; j < bench.runs[0].rest.size(); ++j)
      reading[column_q + j] = bench.runs[0].rest[j] * 20;
  CHECK_FALSE(suspected_convention(Study(read)));
}

TEST_CASE(
    "a convention refuted by other runs is suspected in one run if it removes nearly all, in all if much") {
  const auto asked = [](double share, std::size_t from) {
    Experiment experiment = stiffer_bench();
    for (std::size_t r = from; r < experiment.runs.size(); ++r)
      for (Reading& reading : experiment.runs[r].readings)
        reading[column_Fx] *= -share, reading[column_Fy] *= -share;
    return suspected_convention(Study(experiment)).has_value();
  };
  CHECK(asked(1, 0));
  CHECK(asked(1, 1));
  CHECK(asked(0.7, 0));
  CHECK_FALSE(asked(0.7, 1));
}

TEST_CASE("a single run that looks mirrored is on its other branch") {
  Experiment experiment = measured(full_bench(), {}, {}, 5);
  const auto mirror = [](Run& run) {
    for (Reading& reading : run.readings) reading[column_Fy] *= -1;
  };
  mirror(experiment.runs[0]);
  CHECK_FALSE(suspected_convention(Study(experiment)));
  for (std::size_t r = 1; r < experiment.runs.size(); ++r) mirror(experiment.runs[r]);
  CHECK(suspected_convention(Study(experiment)));
}

TEST_CASE("the question states the misfit as read and as converted") {
  Experiment experiment = stiffer_bench();
  forces_over(-1)(experiment);
  const auto suspected = suspected_convention(Study(experiment));
  REQUIRE(suspected);
  // Forces of the opposite sign are off by nearly twice themselves, the positions that they press to by less.
  CHECK(suspected->misfit_as_read > 1.5);
  CHECK(suspected->left < 0.15);
  try {
    require_conventions(Study(experiment));
    FAIL("no question");
  } catch (const Error& error) {
    REQUIRE(suspected->left < 0.1);
    const std::string said = fmt::format("(the misfit then falls from {:.0f} % to {:.2g} %)",
                                         100 * suspected->misfit_as_read, 100 * suspected->left);
    CHECK(std::string(error.what()).find(said) != std::string::npos);
  }
}

TEST_CASE("stiffnesses six or four times too large are not a unit") {
  for (const double factor : {6.0, 4.0, 2.0, 1 / 6.0, 1 / 4.0}) {
    CAPTURE(factor);
    Experiment experiment = stiffer_bench();
    for (double& k : experiment.joint_stiffness) k *= factor;
    CHECK_FALSE(suspected_convention(Study(experiment)));
  }
}

/// No question is asked where the first joint is softer by any of these.
void check_softer_is_not_asked(const Experiment& bench, const std::vector<double>& by) {
  for (const double softer : by) {
    CAPTURE(softer);
    const Experiment soft = measured(bench, only("joint_stiffness", 1), {softer}, 5);
    CHECK_FALSE(suspected_convention(Study(soft)));
  }
}

TEST_CASE("a much softer first joint is not a reversed list") {
  Experiment experiment = three_links();
  experiment.joint_stiffness = {3.6, 2.9, 2.2};
  for (const double first : {0.7, -0.15, 0.0}) load(experiment, {first, 0.1, 0.15}, {0, 0}, {0, -1.5}, 15);
  check_softer_is_not_asked(experiment, {-0.35, -0.45, -0.55});
}

TEST_CASE("a softer first joint is not a reversed list where a run also starts elsewhere") {
  Experiment experiment = three_links();
  experiment.joint_stiffness = {3.6, 2.9, 2.2};
  press(experiment, {0.5, 0.4, 0.4}, {0.055, -0.05}, 15, false);
  for (Reading& r : experiment.runs.front().readings) r[column_x] += 0.005, r[column_y] -= 0.005;
  check_softer_is_not_asked(experiment, {-0.4, -0.45, -0.5});
}

TEST_CASE("reversed lists of links are named where there is a gap") {
  Experiment experiment = stiffer_bench();
  std::reverse(experiment.link_length.begin(), experiment.link_length.end());
  const auto suspected = suspected_convention(Study(experiment));
  REQUIRE(suspected);
  CHECK(names(*suspected).front() == "link_length like a list from the end point on");
  CHECK(suspected->remedy == "link_length in reverse");
}

TEST_CASE("a wholly reversed chain is named where there is a gap, and restored by the remedy") {
  using List = std::vector<double>;
  const Experiment bench = stiffer_bench();
  for (const double sense : {1.0, -1.0}) {
    CAPTURE(sense);
    const auto from_end = [sense](List& list) {
      std::reverse(list.begin(), list.end());
      scale(list, sense);
    };
    Experiment listed = bench;
    for (List* list : {&listed.link_length, &listed.joint_stiffness})
      std::reverse(list->begin(), list->end());
    each_rest(from_end)(listed);
    const std::string like = std::string(sense < 0 ? " like angles of the opposite sign in" : " like") +
                             " lists from the end point on";
    const auto by_rest = suspected_convention(Study(listed));
    REQUIRE(by_rest);
    CHECK(names(*by_rest).front() == "link_length, joint_stiffness, rest" + like);

    each_reading([&](Reading& r) { each_angles(r, from_end); })(listed);
    const auto by_both = suspected_convention(Study(listed));
    REQUIRE(by_both);
    CHECK(names(*by_both).front() == "link_length, joint_stiffness, rest, q" + like);
    for (const Conversion& one : conversions(listed)) {
      if (one.what + " like " + one.looks_like != names(*by_both).front()) continue;
      const Experiment mended = converted(listed, one);
      CHECK(mended.link_length == bench.link_length);
      CHECK(mended.joint_stiffness == bench.joint_stiffness);
      CHECK(mended.runs[0].rest == bench.runs[0].rest);
      CHECK(mended.runs[0].readings[7].angles(3) == bench.runs[0].readings[7].angles(3));
    }
  }
}

TEST_CASE("the remedy for a reversed chain names every reversed list") {
  Experiment experiment = full_bench();
  experiment.link_mass = {0.1, 0.2, 0.3};
  std::vector<std::string> remedies;
  for (const Conversion& one : conversions(experiment))
    if (one.looks_like.find("from the end point on") != std::string::npos) remedies.push_back(one.remedy);
  const std::string rest = "link_length, joint_stiffness, link_mass, rest in reverse",
                    q = ", the columns of columns.q in reverse", turned = ", the signs of rest turned";
  CHECK(remedies == std::vector<std::string>{"joint_stiffness in reverse", "link_length in reverse",
                                             "link_length, joint_stiffness, link_mass in reverse", rest,
                                             rest + q, rest + turned,
                                             rest + turned + q + ", columns.q.sign = -1"});
}

TEST_CASE("a symmetric chain has no order to ask about") {
  Experiment experiment = full_bench();
  experiment.link_length = {0.2, 0.2, 0.2};
  experiment.joint_stiffness = {1.5, 1.0, 1.5};
  for (const Conversion& one : conversions(experiment))
    CHECK(one.looks_like.find("from the end point on") == std::string::npos);
}

TEST_CASE("tapered chains with a different end, or with tolerances, are not reversed lists") {
  std::mt19937 engine(11);
  std::normal_distribution<double> normal;
  const auto tolerance = [&](std::vector<double>& list, double spread) {
    for (double& value : list) value *= std::exp(spread * normal(engine));
  };
  for (int chain = 0; chain < 60; ++chain) {
    CAPTURE(chain);
    Experiment believed = full_bench();
    const double taper = chain % 2 == 0 ? 0.9 : 1.1;
    for (std::size_t i = 1; i < 3; ++i) {
      believed.link_length[i] = taper * believed.link_length[i - 1];
      believed.joint_stiffness[i] = taper * believed.joint_stiffness[i - 1];
    }
    Experiment real = believed;
    const std::size_t end = chain % 4 < 2 ? 0 : 2;
    real.joint_stiffness[end] *= std::exp(0.5 * normal(engine));
    real.link_length[end] *= 1 + 0.03 * normal(engine);
    tolerance(real.link_length, 0.01);
    tolerance(real.joint_stiffness, 0.1);
    real.runs.clear();
    press(real, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
    press(real, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 15, false);
    load(real, {0.2, 0.3, -0.3}, {0, 0}, {-1.0, 0.5}, 15);
    believed.runs = measured(real, {}, {}, 5).runs;
    const auto suspected = suspected_convention(Study(believed));
    CHECK((!suspected || suspected->looks_like.find("from the end point on") == std::string::npos));
  }
}

TEST_CASE("impossible readings are refused with the unit that they resemble") {
  const auto said = [](const Spoil& spoil) -> std::string {
    Experiment experiment = stiffer_bench();
    spoil(experiment);
    try {
      require_physical(experiment);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto says = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  for (const auto& [name, unit] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}}) {
    const double in_si = unit;
    CAPTURE(name);
    CHECK(
        says(said(each_reading([in_si](Reading& r) { r[column_x] /= in_si, r[column_y] /= in_si; })),
             fmt::format("; x, y look like {0}: if so, columns.x.unit and columns.y.unit = \"{0}\"", name)));
  }
  CHECK(says(said(each_reading([](Reading& r) {
               each_angles(r, [](std::vector<double>& q) { scale(q, 57.29577951308232); });
             })),
             "; q looks like degrees: if so, columns.q.unit = \"deg\""));
}

TEST_CASE("a declared unit is tested against the others") {
  Experiment experiment = stiffer_bench();
  for (Run& run : experiment.runs) run.origins = {{"Fx", "Kraft", "kgf", 9.80665}};
  forces_over(1 / 9.80665)(experiment);  // newtons, said to be kgf
  const auto suspected = suspected_convention(Study(experiment));
  REQUIRE(suspected);
  CHECK(suspected->what == "Fx, Fy");
  CHECK(suspected->looks_like == "N");
  CHECK(suspected->expected == "kgf");
  CHECK(suspected->remedy == "columns.Fx.unit and columns.Fy.unit = \"N\"");
}

TEST_CASE("no committed experiment raises a question") {
  const std::filesystem::path folder = std::filesystem::path(PLUMBLINE_SOURCE_DIR) / "tests/experiments";
  int asked = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.is_directory()) continue;
    CAPTURE(entry.path().filename().string());
    CHECK_FALSE(suspected_convention(Study(read_experiment(entry.path()))));
    ++asked;
  }
  CHECK(asked >= 24);
}
