#include "diagnose/screening/anomalies.hpp"

#include <algorithm>

#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

bool remarks(const Experiment& experiment, const std::string& part) {
  const std::vector<std::string> all = anomalies(experiment);
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

TEST_CASE("ordinary readings have no anomalies") {
  for (const std::string& one : anomalies(ordinary_bench())) FAIL_CHECK(one);
}

TEST_CASE("every anomaly is reported with its run") {
  const Experiment ordinary = ordinary_bench();
  Experiment experiment = ordinary;
  std::vector<Reading>* press = &experiment.runs[0].readings;
  const auto again = [&] { experiment = ordinary, press = &experiment.runs[0].readings; };

  (*press)[0][column_Fx] = 2;  // the noise is 0.01 N
  CHECK(remarks(experiment, "run press-1: Fx is 2 N at the unloaded end point"));
  again();
  (*press)[7][column_Fy] += 5;
  CHECK(remarks(experiment, "run press-1: Fy has a lone spike of"));
  CHECK(remarks(experiment, "N in reading 8"));
  again();
  for (Reading& reading : *press) reading[column_q + 1] = 0.25;
  CHECK(remarks(experiment, "run press-1: q2 is constant at 0.25 rad"));
  again();
  for (std::size_t i = 10; i < press->size(); ++i) (*press)[i].t += 100;
  CHECK(remarks(experiment, "run press-1: a pause of 102 s after reading 10; 2 s is usual"));
  again();
  for (Reading& reading : *press) reading[column_x] += 0.1;
  CHECK(remarks(experiment, "run press-1: starts 0.1 m from the unloaded end point"));
  again();
  for (std::size_t i = 0; i < 30; ++i) (*press)[i][column_Fx] = nan_value();
  CHECK(remarks(experiment, "run press-1: Fx is missing in 30 of 41 readings"));
  again();
  for (std::size_t i = 0; i < press->size(); ++i) (*press)[i].t = static_cast<double>(i);
  CHECK(remarks(experiment, "run press-1: t is 0, 1, 2, ..."));
  again();
  experiment.runs.push_back(experiment.runs[0]);
  experiment.runs.back().id = "copy";
  CHECK(remarks(experiment, "run copy: repeats the readings of run press-1"));
  again();
  for (std::size_t i = 0; i < press->size(); ++i) (*press)[i][column_Fy] = 0.1 * static_cast<double>(i);
  CHECK(remarks(experiment, "run press-1: Fy has a noise of"));
}

namespace {

/// A run of twelve readings at the unloaded end point, two seconds apart, whose channels alternate by their
/// noise: no anomalies.
Experiment quiet_run() {
  Experiment experiment = three_links();
  experiment.noise = {1e-3, 1e-3, 0.01, 0.01, 1e-3};
  Run run{"a", plumbline::Control::end_point, {0, 0, 0}, {}};
  for (int i = 0; i < 12; ++i) {
    const double up = i % 2 == 0 ? 1 : -1;
    run.readings.push_back(
        {2.0 * i, chain_values(0.6, 0, 0.01 * up, 0.01 * up, {1e-3 * up, 1e-3 * up, 1e-3 * up})});
  }
  experiment.runs.push_back(run);
  return experiment;
}

/// All that is remarked on a quiet run that was changed.
template <class Change>
std::vector<std::string> remarked(Change change) {
  Experiment experiment = quiet_run();
  change(experiment.runs[0].readings);
  return anomalies(experiment);
}

using Readings = std::vector<Reading>;
using Remarks = std::vector<std::string>;

}  // namespace

TEST_CASE("thresholds of anomalies: pauses, missing values, starts and forces, from both sides") {
  const auto nothing = Remarks{};
  CHECK(remarked([](Readings&) {}) == nothing);
  const auto pause = [](double seconds) {
    return remarked([&](Readings& all) {
      for (std::size_t i = 5; i < all.size(); ++i) all[i].t += seconds - 2;
    });
  };
  CHECK(pause(40) == nothing);
  CHECK(pause(41) == Remarks{"run a: a pause of 41 s after reading 5; 2 s is usual"});

  const auto missing = [](std::size_t count) {
    return remarked([&](Readings& all) {
      for (std::size_t i = 0; i < count; ++i) all[i][column_Fy] = nan_value();
    });
  };
  CHECK(missing(6) == nothing);
  CHECK(missing(7) == Remarks{"run a: Fy is missing in 7 of 12 readings"});
  CHECK(missing(12) == nothing);  // never measured

  const auto start = [](double away, double along) {
    return remarked(
        [&](Readings& all) { all[0][column_x] -= away * along, all[0][column_y] += away * (1 - along); });
  };
  CHECK(start(0.0299, 1) == nothing);  // a twentieth of 0.6 m is 0.03
  CHECK(start(0.0301, 1) == Remarks{"run a: starts 0.0301 m from the unloaded end point (0.6, 0) m"});
  CHECK(start(0.0301, 0) == Remarks{"run a: starts 0.0301 m from the unloaded end point (0.6, 0) m"});

  const auto force = [](double Fx, double Fy, double away) {
    return remarked(
        [&](Readings& all) { all[0][column_Fx] = Fx, all[0][column_Fy] = Fy, all[0][column_x] -= away; });
  };
  CHECK(force(0.199, -0.199, 0) == nothing);
  CHECK(force(-0.201, 0, 0) == Remarks{"run a: Fx is -0.201 N at the unloaded end point: a tare, a weight?"});
  CHECK(force(0, 0.201, 5.9e-4) ==
        Remarks{"run a: Fy is 0.201 N at the unloaded end point: a tare, a weight?"});
  CHECK(force(0, 0.201, 6.1e-4) == nothing);  // a thousandth of the chain away
}

TEST_CASE("a channel that is constant, has too little noise or a lone spike, from eight values on") {
  const auto nothing = Remarks{};
  const auto still = [](std::size_t values) {
    return remarked([&](Readings& all) {
      for (std::size_t i = 0; i < all.size(); ++i) all[i][column_Fx] = i < values ? 0.125 : nan_value();
    });
  };
  CHECK(still(12) == Remarks{"run a: Fx is constant at 0.125 N"});
  CHECK(still(8) == Remarks{"run a: Fx is constant at 0.125 N"});
  CHECK(still(7) == nothing);
  // Second differences of +-a are 4 a, which seem a deviation of 4 a / 0.6745 / sqrt(6) = 2.421 a; below a
  // fifth of the declared 0.01 N it is too little.
  const auto scatter = [](double a) {
    return remarked([&](Readings& all) {
      for (std::size_t i = 0; i < all.size(); ++i) all[i][column_Fx] = i % 2 == 0 ? a : -a;
    });
  };
  CHECK(scatter(8.27e-4) == nothing);
  CHECK(scatter(8.25e-4) == Remarks{"run a: Fx has a noise of 0.002 N at most; 0.01 is declared"});

  // The neighbours of reading 6 are 0.01 N; both sides of it by 0.02.
  const auto jump = [](std::size_t reading, double by) {
    return remarked([&](Readings& all) { all[reading - 1][column_Fy] += by; });
  };
  CHECK(jump(6, -0.17) == nothing);  // to -0.18, 0.19 away from its neighbours
  CHECK(jump(6, -0.191) == Remarks{"run a: Fy has a lone spike of -0.201 N in reading 6"});
  CHECK(jump(2, -0.191) == Remarks{"run a: Fy has a lone spike of -0.201 N in reading 2"});
  CHECK(jump(11, 0.5) == Remarks{"run a: Fy has a lone spike of 0.51 N in reading 11"});
  CHECK(remarked([](Readings& all) { all[5][column_Fy] = all[6][column_Fy] = 1; }) ==
        nothing);  // two are no jump
  CHECK(remarked([](Readings& all) {
          all[3][column_Fy] = nan_value();  // readings keep their numbers
          all[6][column_Fy] += 0.5;
        }) == Remarks{"run a: Fy has a lone spike of 0.51 N in reading 7"});
}
