#include "diagnose/design/candidate_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("limits of a proposed run: twice the force, 1.5 times the deflection, by hand") {
  const OperatingEnvelope so_far{0.1, 2.5, 0.4, 2};
  const std::vector<double> rest{0.3, -0.5};
  Run run{"asked", Control::force, rest, {}};
  run.readings.resize(2);
  // Fx, Fy and the joints' turns at the second reading; the first is unloaded
  const auto trace = [&](double Fx, double Fy, double turn1, double turn2) {
    Trace result = Trace::Zero(2, column_q + 2);
    result.row(1)[column_Fx] = Fx;
    result.row(1)[column_Fy] = Fy;
    for (const Eigen::Index row : {0, 1}) {
      result.row(row)[column_q] = rest[0] + static_cast<double>(row) * turn1;
      result.row(row)[column_q + 1] = rest[1] + static_cast<double>(row) * turn2;
    }
    return result;
  };
  CHECK(so_far.allows(trace(-3, 3.9, 0.59, -0.59), run));  // 4.92 N of 5, 0.59 rad of 0.6
  CHECK_FALSE(so_far.allows(trace(-3, 4.1, 0.1, 0), run));
  CHECK_FALSE(so_far.allows(trace(5.1, 0, 0.1, 0), run));
  CHECK_FALSE(so_far.allows(trace(1, 0, 0.61, 0), run));
  CHECK_FALSE(so_far.allows(trace(1, 0, 0.1, -0.61), run));
  // where nothing was asked so far anything may be
  CHECK(OperatingEnvelope{}.allows(trace(100, 0, 3, 3), run));
}

namespace {

/// A press of 6 mm and a load, with readings every three seconds and every second.
Experiment press_and_load() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.006, 0.008}, 5, true, 3);
  load(experiment, {0.2, 0.3, -0.3}, {0, 0}, {-0.06, 0.08}, 5);
  return experiment;
}

}  // namespace

TEST_CASE("extents of the runs so far, by hand") {
  const Study study(press_and_load());
  const OperatingEnvelope so_far = operating_envelope(study);
  CHECK(so_far.travel == close_to(0.01).epsilon(1e-9));  // (6, 8) mm
  CHECK(so_far.sampling_interval == 3);
  double force = 0, deflection = 0;
  for (std::size_t r = 0; r < 2; ++r) {
    const Trace& trace = study.nominal().runs[r];
    for (Eigen::Index i = 0; i < trace.rows(); ++i) {
      force = std::max(force, std::hypot(trace(i, column_Fx), trace(i, column_Fy)));
      for (std::size_t j = 0; j < 3; ++j)
        deflection = std::max(deflection, std::abs(angle(trace, i, j) - study.experiment().runs[r].rest[j]));
    }
  }
  CHECK(so_far.force == close_to(force).epsilon(1e-12));
  CHECK(so_far.deflection == close_to(deflection).epsilon(1e-12));

  Experiment loaded = press_and_load();
  loaded.runs.erase(loaded.runs.begin());
  CHECK(operating_envelope(Study(loaded)).travel == close_to(0.05 * 0.6));  // none was commanded
  loaded.runs[0].readings.clear();
  CHECK(operating_envelope(Study(loaded)).sampling_interval == 2);
}

TEST_CASE("without limits a held end point is pressed as far as before and 1.5 times, in eight directions") {
  const Experiment experiment = press_and_load();
  const Shape shape{Control::end_point, {0.3, -0.5, 0.4}, "the rest"};
  const std::vector<CandidateRun> all = runs_from(experiment, shape, {0.01, 0, 0, 3});
  REQUIRE(all.size() == 32);
  const char* ways[] = {"along -x",          "along +x",          "along +y",          "along -y",
                        "between -x and +y", "between -x and -y", "between +x and +y", "between +x and -y"};
  const Vector2 along[] = {{-1, 0},     {1, 0},       {0, 1},     {0, -1},
                           {-0.8, 0.6}, {-0.8, -0.6}, {0.8, 0.6}, {0.8, -0.6}};
  const Vector2 start = unloaded_end(experiment, shape.rest);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t way = i / 4;
    const bool far = i % 4 >= 2, back = i % 2 == 1;
    CHECK(all[i].description == std::string("press ") + ways[way] + " by " + (far ? "0.015" : "0.01") +
                                    " m from the rest" + (back ? " and unload" : ""));
    const Run& run = all[i].run;
    CHECK(run.holds_end_point());
    CHECK(run.rest == shape.rest);
    REQUIRE(run.readings.size() == (back ? 41 : 21));
    for (const std::size_t r : {0U, 7U, 20U}) {
      const Vector2 to = start + static_cast<double>(r) / 20 * (far ? 0.015 : 0.01) * along[way];
      CHECK((run.command(run.readings[r]) - to).norm() < 1e-15);
      CHECK(run.readings[r].t == 3.0 * static_cast<double>(r));
      CHECK(std::isnan(run.readings[r][column_Fx]));
      CHECK(std::isnan(run.readings[r][column_Fy]));
    }
    if (back) CHECK((run.command(run.readings[33]) - run.command(run.readings[7])).norm() < 1e-15);
  }
}

TEST_CASE("a held end point is pressed to the limits of force and deflection, and to two thirds") {
  const Experiment experiment = press_and_load();
  const Shape shape{Control::end_point, {0.3, -0.5, 0.4}, "the rest"};
  const auto followed = [&](const Run& run, const OperatingEnvelope& so_far) {
    Experiment bench = experiment;
    bench.runs = {run};
    const Prediction nominal = Study(bench).nominal();
    return nominal.reached && !nominal.snapped && so_far.allows(nominal.runs[0], run);
  };
  const auto longer = [](Run run) {
    for (Reading& one : run.readings) {
      one[column_x] += 0.5 * (one[column_x] - run.readings[0][column_x]);
      one[column_y] += 0.5 * (one[column_y] - run.readings[0][column_y]);
    }
    return run;
  };
  std::size_t shortened = 0;
  for (const OperatingEnvelope& so_far :
       {OperatingEnvelope{0.01, 1, 0.1, 3}, OperatingEnvelope{0.02, 0.3, 0, 3},
        OperatingEnvelope{0.03, 0, 0.02, 3}}) {
    const std::vector<CandidateRun> all = runs_from(experiment, shape, so_far);
    REQUIRE_FALSE(all.empty());
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Run& run = all[i].run;
      CHECK(followed(run, so_far));
      const double way =
          (run.command(run.readings[20]) - run.command(run.readings[0])).norm() / so_far.travel;
      CHECK(way < 2.25 + 1e-12);
      shortened += way < 0.99;
      // the next longer way is in the list too, or too long
      const bool is_longest =
          i + 2 >= all.size() || all[i + 2].description.substr(0, 14) != all[i].description.substr(0, 14);
      if (is_longest && way < 2.2) CHECK_FALSE(followed(longer(run), so_far));
    }
  }
  CHECK(shortened > 0);
}

TEST_CASE("an imposed force is as large as before, or limited by the earlier deflection") {
  const Experiment experiment = press_and_load();
  const Shape shape{Control::force, {0.2, 0.3, -0.3}, "the rest"};
  const std::vector<CandidateRun> all = runs_from(experiment, shape, {0, 0.1, 0.33, 3});
  REQUIRE(all.size() == 16);
  CHECK(all[0].description == "load with 0.1 N along -x from the rest");
  CHECK(all[9].description == "load with 0.1 N between -x and +y from the rest and unload");
  const Run& run = all[9].run;
  CHECK_FALSE(run.holds_end_point());
  REQUIRE(run.readings.size() == 41);
  CHECK((run.command(run.readings[20]) - Vector2(-0.08, 0.06)).norm() < 1e-15);
  CHECK(run.command(run.readings[40]).norm() == 0);
  CHECK(std::isnan(run.readings[20][column_x]));
  CHECK(run.readings[20].t == 60);
  // What is asked for is halved until the nominal joints turn no farther.
  const auto turned = [&](Run one, double times) {
    for (Reading& r : one.readings) r[column_Fx] *= times, r[column_Fy] *= times;
    Experiment bench = experiment;
    bench.runs = {one};
    const Trace trace = predict(Study(bench), {}, {}).runs[0];
    double most = 0;
    for (Eigen::Index i = 0; i < trace.rows(); ++i)
      for (std::size_t j = 0; j < 3; ++j) most = std::max(most, std::abs(angle(trace, i, j) - shape.rest[j]));
    return most;
  };
  int halved = 0;
  for (const CandidateRun& one : runs_from(experiment, shape, {0, 0.1, 0.005, 3})) {
    CHECK(turned(one.run, 1) <= 0.005);
    const double force = one.run.command(one.run.readings[20]).norm(), times = std::log2(0.1 / force);
    CHECK(times == doctest::Approx(std::round(times)).scale(1));
    if (times < 0.5) continue;
    ++halved;
    CHECK(turned(one.run, 2) > 0.005);
  }
  CHECK(halved > 0);
  // Nothing so far: a third of a radian at most.
  const std::vector<CandidateRun> first = runs_from(experiment, shape, {});
  CHECK(first.size() == 16);
  for (const CandidateRun& one : first) CHECK(one.run.readings[1].t == 2);
}

TEST_CASE("rest shapes of a bench: those of its runs, then mirrored, without repetition") {
  Experiment experiment = press_and_load();
  experiment.runs.push_back(experiment.runs[0]);
  experiment.runs[2].id = "again";
  const std::vector<Shape> all = shapes(experiment, 10);
  REQUIRE(all.size() == 4);
  CHECK(all[0].words == "the rest shape of again");
  CHECK(all[1].words == "the rest shape of load-2");
  CHECK(all[2].words == "the mirrored rest shape of again");
  CHECK(all[2].rest == std::vector<double>{-0.3, 0.5, -0.4});
  CHECK(all[3].control == Control::force);
  CHECK(shapes(experiment, 3).size() == 3);
}
