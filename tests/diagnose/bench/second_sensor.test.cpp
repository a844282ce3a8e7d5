/// A second sensor of the load: read, predicted, and told from the first.
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Name = Channel::Name;

const std::string two_cells = R"(format = "chain-experiment/1"
name = "two cells"
[nominal]
link_length = [0.3, 0.2]
joint_stiffness = [2.0, 1.5]
[bench]
gravity_plane = "horizontal"
[columns]
Fx_2 = { column = "cell 2", unit = "mN", sign = -1 }
[noise]
Fx = 0.02
Fy = 0.02
Fx_2 = 30
[[run]]
id = "press"
control = "displacement"
rest = [0.4, -0.9]
samples = "press.csv"
)";
// End point of the rest shape: 0.3 (cos 0.4, sin 0.4) + 0.2 (cos 0.5, -sin 0.5) = (0.4518, 0.0209).
const std::string two_cells_press =
    "t,x,y,Fx,Fy,cell 2\n0,0.4518,0.0209,0,0,0\n1,0.45,0.0209,-0.1,0,110\n2,0.448,0.0209,-0.2,0,\n";

Experiment read_two_cells(const std::string& settings = two_cells) {
  return read_experiment("two", [&](const std::string& name, const std::string&) {
    return name == "experiment.toml" ? settings : two_cells_press;
  });
}

/// The bench of three links with a second cell of the first one's noise that reads the true force, with noise
/// of its own.
Experiment with_second_cell(const Candidate& truth, const std::vector<double>& values) {
  Experiment experiment = full_bench();
  experiment.noise[Channel::Name::Fx_2] = experiment.noise[Channel::Name::Fx],
  experiment.noise[Channel::Name::Fy_2] = experiment.noise[Channel::Name::Fy];
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading[column_Fx_2] = reading[column_Fy_2] = 0;
  const Prediction predicted = predict(Study(experiment), truth, values);
  REQUIRE(predicted.reached);
  Experiment result = measured(experiment, truth, values, 5);
  std::mt19937 engine(6);
  std::normal_distribution<double> normal;
  for (std::size_t r = 0; r < result.runs.size(); ++r)
    for (std::size_t i = 0; i < result.runs[r].readings.size(); ++i)
      for (const Channel& channel : {Channel(Name::Fx_2), Channel(Name::Fy_2)})
        channel.in(result.runs[r].readings[i]) =
            predicted.runs[r](static_cast<Eigen::Index>(i), channel.column) +
            channel.sigma(result.noise) * normal(engine);
  return result;
}

}  // namespace

TEST_CASE("a second load cell is read in its unit and sign, with a noise of its own") {
  const Experiment experiment = read_two_cells();
  const Run& run = experiment.runs.at(0);
  CHECK(run.measured() == std::vector<Channel>{Channel(Name::Fx), Channel(Name::Fy), Channel(Name::Fx_2)});
  CHECK(Channel(Name::Fx_2).of(run.readings[1]) == close_to(-0.11));
  CHECK(std::isnan(Channel(Name::Fx_2).of(run.readings[2])));
  CHECK(Channel(Name::Fx_2).sigma(experiment.noise) == close_to(0.03));
  CHECK(Channel(Name::Fx_2).label() == "Fx_2");
  CHECK(Channel(Name::Fx_2).unit() == "N");
}

TEST_CASE("a second load cell without a noise is refused, and a joint alone has a second torque") {
  std::string settings = two_cells;
  settings.replace(settings.find("Fx_2 = 30"), 9, "");
  CHECK_THROWS_AS(read_two_cells(settings), Error);
  settings = two_cells;
  settings.replace(settings.find("Fx_2 = 30"), 9, "torque_2 = 3");
  CHECK_THROWS_AS(read_two_cells(settings), Error);
}

TEST_CASE("without errors both cells show the force on the end point, in runs of either control") {
  const Study study(with_second_cell({}, {}));
  for (const Trace& trace : study.nominal().runs) {
    CHECK((trace.col(column_Fx_2) - trace.col(column_Fx)).abs().maxCoeff() == 0);
    CHECK((trace.col(column_Fy_2) - trace.col(column_Fy)).abs().maxCoeff() == 0);
  }
}

TEST_CASE("of two cells that disagree the chain tells which is wrong") {
  for (const char* wrong : {"second_gain", "force_gain"}) {
    CAPTURE(wrong);
    const Diagnosis found = plumbline::diagnose::diagnose(Study(with_second_cell(only(wrong), {0.1})), {});
    REQUIRE(found.cause.is_explained());
    CHECK(found.cause.ranking.front().cause.label() == wrong);
    for (std::size_t i = 0; i < found.cause.named; ++i)  // something small may be named beside it
      CHECK(found.cause.ranking[i].cause.has({wrong}));
  }
}
