#include "diagnose/bench/oddities.hpp"

#include <algorithm>

#include "tests/diagnose/bench.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

bool remarks(const Experiment& experiment, const std::string& part) {
  const std::vector<std::string> all = oddities(experiment);
  return std::any_of(all.begin(), all.end(),
                     [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

/// With readings every two seconds.
Experiment ordinary_bench() {
  Experiment experiment = measured(full_bench(), {}, {}, 3);
  for (Reading& reading : experiment.runs[2].readings) reading.t *= 2;
  return experiment;
}

}  // namespace

TEST_CASE("ordinary readings are not odd") {
  for (const std::string& one : oddities(ordinary_bench())) FAIL_CHECK(one);
}

TEST_CASE("each oddity is remarked on, with its run") {
  const Experiment ordinary = ordinary_bench();
  Experiment experiment = ordinary;
  std::vector<Reading>* press = &experiment.runs[0].readings;
  const auto again = [&] { experiment = ordinary, press = &experiment.runs[0].readings; };

  (*press)[0].Fx = 2;  // the noise is 0.01 N
  CHECK(remarks(experiment, "run press-1: Fx is 2 N at the unloaded end point"));
  again();
  (*press)[7].Fy += 5;
  CHECK(remarks(experiment, "run press-1: Fy jumps to"));
  CHECK(remarks(experiment, "in reading 8 alone"));
  again();
  for (Reading& reading : *press) reading.q[1] = 0.25;
  CHECK(remarks(experiment, "run press-1: q2 stands still at 0.25 rad"));
  again();
  for (std::size_t i = 10; i < press->size(); ++i) (*press)[i].t += 100;
  CHECK(remarks(experiment, "run press-1: a pause of 102 s after reading 10, where 2 s is usual"));
  again();
  for (Reading& reading : *press) reading.x += 0.1;
  CHECK(remarks(experiment, "run press-1: starts 0.1 m from the unloaded end point"));
  again();
  for (std::size_t i = 0; i < 30; ++i) (*press)[i].Fx = nan_value();
  CHECK(remarks(experiment, "run press-1: Fx is missing in 30 of 41 readings"));
  again();
  for (std::size_t i = 0; i < press->size(); ++i) (*press)[i].t = static_cast<double>(i);
  CHECK(remarks(experiment, "run press-1: t only counts the readings"));
  again();
  experiment.runs.push_back(experiment.runs[0]);
  experiment.runs.back().id = "copy";
  CHECK(remarks(experiment, "run copy: the readings of run press-1 again"));
  again();
  for (std::size_t i = 0; i < press->size(); ++i) (*press)[i].Fy = 0.1 * static_cast<double>(i);
  CHECK(remarks(experiment, "run press-1: Fy scatters by"));
}
