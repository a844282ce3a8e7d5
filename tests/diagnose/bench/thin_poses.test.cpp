#include "diagnose/bench/thin_poses.hpp"

#include "tests/diagnose/arms.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("few poses stay as they are, and of many whole blocks stay, each without its first place") {
  const Experiment few = arm_bench(industrial_arm(), 100), many = arm_bench(industrial_arm(), 4000);
  CHECK(thinned(few).runs[0].readings.size() == 50);
  const Run run = thinned(many).runs[0];
  CHECK(run.readings.size() == 400);  // every fifth of a hundred blocks of twenty
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    CHECK(run.readings[i].rest == many.runs[0].readings[run.first_taken(i)].rest);
    CHECK(std::isnan(Channel(Channel::Name::place, 0, run.rest.size()).of(run.readings[i])) ==
          (i > 0 && i % 20 == 0));
  }
}
