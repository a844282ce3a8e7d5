#include "diagnose/decision/heldout.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using HeldNames = std::vector<std::string>;

/// The readings that are held out of one run, as "3-5 8".
std::string held_of(const HeldOut& held, std::size_t run) {
  std::string text;
  const std::vector<bool>& reading = held.reading.at(run);
  for (std::size_t i = 0; i < reading.size(); ++i) {
    if (!reading[i] || (i > 0 && reading[i - 1])) continue;
    std::size_t end = i;
    while (end + 1 < reading.size() && reading[end + 1]) ++end;
    text += (text.empty() ? "" : " ") + std::to_string(i) + "-" + std::to_string(end);
  }
  return text;
}

/// Presses that go so far, there and back or not, named by their numbers from 1.
Experiment with_presses(const std::vector<std::pair<double, bool>>& presses) {
  Experiment experiment = three_links();
  for (const auto& [far, back] : presses) press(experiment, {0.3, -0.5, 0.4}, {far, 0}, 8, back);
  return experiment;
}

}  // namespace

TEST_CASE("held out is the farthest run but one of the kind that has most") {
  const Experiment experiment = with_presses(
      {{-0.06, true}, {-0.01, true}, {-0.05, true}, {-0.04, true}, {-0.055, false}, {-0.07, false}});
  const HeldOut held = choose_heldout(experiment);
  CHECK(held.names == HeldNames{"press-3"});
  for (std::size_t r = 0; r < 6; ++r) CHECK(held_of(held, r) == (r == 2 ? "0-16" : ""));
  // which way it goes does not matter
  CHECK(choose_heldout(with_presses({{-0.06, true}, {0.05, true}, {-0.04, true}})).names ==
        HeldNames{"press-2"});
  CHECK(choose_heldout(with_presses({{-0.06, true}, {-0.05, true}, {-0.07, false}})).names ==
        HeldNames{"press-2"});
  // of two runs equally far the first by its name counts as the nearer
  CHECK(choose_heldout(with_presses({{-0.06, true}, {-0.06, true}, {-0.01, true}})).names ==
        HeldNames{"press-1"});
}

TEST_CASE("of two runs, or of three of three kinds, blocks are held out") {
  CHECK(choose_heldout(with_presses({{-0.06, true}, {-0.05, true}})).names ==
        HeldNames{"press-1[4:5]", "press-1[12:13]", "press-2[4:5]", "press-2[12:13]"});
  Experiment three = with_presses({{-0.06, true}, {-0.05, false}});
  load(three, {0.2, 0.3, -0.3}, {0, 0}, {-2.0, 1.0}, 15);
  const HeldOut held = choose_heldout(three);
  CHECK(held_of(held, 0) == "4-5 12-13");  // eighths of 17 readings, the third and the seventh
  CHECK(held_of(held, 1) == "2-2 6-6");
  CHECK(held_of(held, 2) == "4-5 12-13");
  CHECK(choose_blocks(three).reading == held.reading);
}

TEST_CASE("blocks are pairs of eighths that are not the same stretch there and back") {
  const Experiment experiment = with_presses({{-0.06, true}});
  const std::vector<HeldOut> parts = block_parts(experiment);
  REQUIRE(parts.size() == 3);
  CHECK(held_of(parts[0], 0) == "2-3 8-9");
  CHECK(held_of(parts[1], 0) == "4-5 12-13");
  CHECK(held_of(parts[2], 0) == "6-7 10-11");
  CHECK(parts[2].names == HeldNames{"press-1[6:7]", "press-1[10:11]"});
  // of groups of readings names say the first and the last as they were taken
  Experiment grouped = experiment;
  grouped.runs[0].groups.size = 3;
  for (std::size_t i = 0; i <= 17; ++i) grouped.runs[0].groups.first.push_back(3 * i);
  CHECK(block_parts(grouped)[0].names == HeldNames{"press-1[6:11]", "press-1[24:29]"});
  Experiment tiny = three_links();
  press(tiny, {0.3, -0.5, 0.4}, {-0.06, 0}, 6, false);  // seven readings
  CHECK(block_parts(tiny).empty());
  CHECK(choose_heldout(tiny).empty());
  press(tiny, {0.3, -0.5, 0.4}, {-0.06, 0}, 7, false);  // eight
  CHECK(block_parts(tiny)[0].names == HeldNames{"press-2[1:1]", "press-2[4:4]"});
}

TEST_CASE("parts of the runs: four at most, of those that another can stand for, farthest apart") {
  CHECK(run_parts(with_presses({{-0.06, true}, {-0.05, true}})).empty());
  const std::vector<HeldOut> three = run_parts(with_presses({{-0.04, true}, {-0.06, true}, {-0.05, false}}));
  REQUIRE(three.size() == 2);
  CHECK(three[0].names == HeldNames{"press-2"});
  CHECK(three[1].names == HeldNames{"press-1"});
  CHECK(held_of(three[0], 1) == "0-16");
  CHECK(held_of(three[0], 0).empty());
  // six of two kinds: those that do not come back first, then each kind by how far it goes
  const std::vector<HeldOut> six = run_parts(with_presses(
      {{-0.01, true}, {-0.02, false}, {-0.05, true}, {-0.03, false}, {-0.03, true}, {-0.04, true}}));
  REQUIRE(six.size() == 4);
  CHECK(six[0].names == HeldNames{"press-4", "press-5"});
  CHECK(six[1].names == HeldNames{"press-2", "press-1"});
  CHECK(six[2].names == HeldNames{"press-3"});
  CHECK(six[3].names == HeldNames{"press-6"});
}

TEST_CASE("without what is held out the measured values are gone, the commands stay, a whole run goes") {
  Experiment experiment = with_presses({{-0.06, true}, {-0.05, true}});
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-2.0, 1.0}, 15);
  HeldOut held = nothing_held(experiment);
  CHECK(held.empty());
  for (std::size_t r = 0; r < 3; ++r) CHECK(held_of(held, r).empty());
  held.reading[0].assign(17, true);
  held.reading[1][4] = held.reading[2][5] = true;
  const Experiment rest = without(experiment, held);
  REQUIRE(rest.runs.size() == 2);
  CHECK(rest.runs[0].id == "press-2");
  CHECK(rest.runs[1].id == "load-3");
  const Reading &pressed_on = rest.runs[0].readings[4], &loaded = rest.runs[1].readings[5];
  CHECK(pressed_on[column_x] == experiment.runs[1].readings[4][column_x]);
  CHECK(std::isnan(pressed_on[column_Fx]));
  CHECK(std::isnan(pressed_on[column_Fy]));
  CHECK(std::isnan(pressed_on[column_q + 2]));
  CHECK(loaded[column_Fx] == experiment.runs[2].readings[5][column_Fx]);
  CHECK(std::isnan(loaded[column_x]));
  CHECK_FALSE(std::isnan(rest.runs[0].readings[3][column_Fx]));
  CHECK_FALSE(std::isnan(rest.runs[0].readings[5][column_Fx]));
}

TEST_CASE("named parts are those whose names are all among the names") {
  const Experiment experiment = with_presses({{-0.06, true}, {-0.05, true}, {-0.04, true}});
  const HeldOut runs = named(experiment, {"press-1", "press-3"});
  CHECK(runs.names == HeldNames{"press-1", "press-3"});
  CHECK(held_of(runs, 0) == "0-16");
  CHECK(held_of(runs, 1).empty());
  CHECK(held_of(runs, 2) == "0-16");
  const std::vector<HeldOut> blocks = block_parts(experiment);
  HeldNames names = blocks[1].names;
  CHECK(named(experiment, names).reading == blocks[1].reading);
  names.pop_back();
  CHECK(named(experiment, names).reading == nothing_held(experiment).reading);
  const Experiment two = with_presses({{-0.06, true}, {-0.05, true}});
  CHECK(named(two, choose_heldout(two).names).reading == choose_heldout(two).reading);
}
