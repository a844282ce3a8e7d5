/// \file
/// `bench-fit`: time of fitting a single effect to an experiment of four links and 200 readings, beside a
/// SciPy script that fits the same to the same readings by least squares. Processor time, one thread.

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "benchmarks/race.hpp"
#include "diagnose/inference/white_noise_fit.hpp"
#include "support/files/temporary_folder.hpp"

namespace plumbline::bench {
using namespace diagnose;
namespace {

using Json = nlohmann::json;

struct Task {
  EffectAt at;
  Experiment experiment;
};

Run press(const std::vector<double>& length, const std::vector<double>& rest, double by_x, double by_y) {
  Run run{"press", Control::end_point, rest, {}};
  double theta = 0, x = 0, y = 0;
  for (std::size_t j = 0; j < rest.size(); ++j) {
    theta += rest[j];
    x += length[j] * std::cos(theta);
    y += length[j] * std::sin(theta);
  }
  for (int i = 0; i < 100; ++i) {
    const double share = 1 - std::abs(1 - i / 50.0);
    run.readings.push_back({1.0 * i, {x + share * by_x, y + share * by_y, 0, 0}});
  }
  return run;
}

Experiment four_links() {
  Experiment experiment;
  experiment.link_length = {0.25, 0.2, 0.22, 0.18};
  experiment.joint_stiffness = {2.0, 2.5, 1.5, 2.0};
  experiment.link_mass.assign(4, 0);
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::vertical, {0, -1}, true};
  experiment.noise = {0, 0, 0.02, 0.02, 0};
  experiment.runs = {press(experiment.link_length, {0.3, -0.2, -0.4, 0.5}, -0.08, 0),
                     press(experiment.link_length, {-0.4, 0.5, 0.3, -0.4}, -0.06, 0.03)};
  return experiment;
}

/// The experiment with half a sizeable effect in it, and noise.
Task task(const EffectAt& at, unsigned seed) {
  Task one{at, four_links()};
  std::vector<double> truth;
  for (const ParameterRange& range : Study(one.experiment).ranges(at)) truth.push_back(range.scale / 2);
  const Prediction predicted = predict(Study(one.experiment), {{at}}, truth);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, one.experiment.noise[Channel::Name::Fx]);
  for (std::size_t r = 0; r < one.experiment.runs.size(); ++r) {
    for (std::size_t i = 0; i < one.experiment.runs[r].readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      one.experiment.runs[r].readings[i][column_Fx] = predicted.runs[r](row, column_Fx) + noise(engine);
      one.experiment.runs[r].readings[i][column_Fy] = predicted.runs[r](row, column_Fy) + noise(engine);
    }
  }
  return one;
}

Json for_script(const Task& one) {
  Json runs = Json::array();
  for (const Run& run : one.experiment.runs) {
    Json columns{{"rest", run.rest}};
    for (const Reading& reading : run.readings) {
      columns["x"].push_back(reading[column_x]);
      columns["y"].push_back(reading[column_y]);
      columns["Fx"].push_back(reading[column_Fx]);
      columns["Fy"].push_back(reading[column_Fy]);
    }
    runs.push_back(columns);
  }
  Json scale = Json::array();
  for (const ParameterRange& range : Study(one.experiment).ranges(one.at)) scale.push_back(range.scale);
  return {
      {"effect", one.at.effect->id},
      {"joint", one.at.joint},
      {"nominal", {{"length", one.experiment.link_length}, {"stiffness", one.experiment.joint_stiffness}}},
      {"sigma", one.experiment.noise[Channel::Name::Fx]},
      {"scale", scale},
      {"runs", runs}};
}

Json run_script(const std::vector<Task>& tasks) {
  const files::TemporaryFolder folder;
  const std::string in = folder / "in.json", out = folder / "out.json";
  Json all = Json::array();
  for (const Task& one : tasks) all.push_back(for_script(one));
  std::ofstream(in) << all;
  const std::string command =
      fmt::format("OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 {} < '{}' > '{}'", FIT_SCIPY, in, out);
  if (std::system(command.c_str()) != 0) {
    fmt::print(stderr, "bench-fit: the SciPy script failed; it needs python3-scipy\n");
    std::exit(1);
  }
  return Json::parse(std::ifstream(out));
}

void compare(const std::vector<Task>& tasks) {
  const Json peer = run_script(tasks);
  fmt::print("{:<20} {:>12} {:>12} {:>8} {:>14}\n", "effect", "SciPy, ms", "here, ms", "ratio",
             "values differ");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Task& one = tasks[i];
    constexpr int repeats = 20;
    Hypothesis found;
    const double start = processor_seconds();
    for (int r = 0; r < repeats; ++r) found = fit_in_white_noise(Study(one.experiment), {{one.at}});
    const double seconds = (processor_seconds() - start) / repeats;
    const MatrixXd covariance = diagnose::covariance(Study(one.experiment), found);
    double apart = 0;  // in standard deviations
    for (std::size_t p = 0; p < found.parameters.size(); ++p) {
      const auto k = static_cast<Eigen::Index>(p);
      apart = std::max(apart, std::abs(found.parameters[p] - peer[i]["parameters"][p].get<double>()) /
                                  std::sqrt(covariance(k, k)));
    }
    const double other = peer[i]["seconds"].get<double>();
    fmt::print("{:<20} {:>12.1f} {:>12.3f} {:>8.0f} {:>8.3f} sigma\n", one.at.effect->id, 1e3 * other,
               1e3 * seconds, other / seconds, apart);
  }
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  using namespace plumbline;
  using diagnose::EffectAt;
  std::vector<bench::Task> tasks;
  for (const EffectAt& at : std::vector<EffectAt>{{"joint_stiffness", 2},
                                                  {"link_length", 3},
                                                  {"rest_angle", 1},
                                                  {"nonlinear_spring"},
                                                  {"gravity"},
                                                  {"base_compliance"},
                                                  {"tip_stiffness"},
                                                  {"force_bias"},
                                                  {"force_gain"}})
    tasks.push_back(bench::task(at, 7));
  bench::compare(tasks);
}
