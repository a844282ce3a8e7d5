/// \file
/// `bench-next [DRAWS] [SEED]`: how many runs it takes to a certain and right answer when each next one is
/// the first that the diagnosis proposes, beside runs drawn at random from the same candidates. Chains of two
/// and three links in a horizontal plane, forces measured, one effect at random; experiments of the
/// diagnosis' own forward model. Prints the tables of RESULTS-next.md.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "diagnose/answers/candidate_runs.hpp"
#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::bench {
using namespace diagnose;
namespace {

constexpr std::size_t most_runs =
    6;  ///< after which an answer that is not yet certain counts as one at these

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::size_t below(std::mt19937& random, std::size_t count) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
}

/// A bench and what is wrong with it.
struct Draw {
  Experiment bench;  ///< without runs
  std::vector<double> rest;
  Instance truth;
};

Experiment chain(std::mt19937& random) {
  Experiment bench;
  bench.name = "drawn";
  const std::size_t links = 2 + below(random, 2);
  for (std::size_t i = 0; i < links; ++i) {
    bench.link_length.push_back(uniform(random, 0.15, 0.3));
    bench.joint_stiffness.push_back(uniform(random, 1, 3));
  }
  bench.link_mass.assign(links, 0);
  bench.gravity = {0, 0};
  bench.bench = {Bench::Plane::horizontal, {0, 0}, false};
  bench.noise = {1e-4, 1e-4, 0.02, 0.02, 0};
  return bench;
}

/// Adds a run to the bench as the truth measures it. \returns false where the rig could not follow
bool make(Experiment& experiment, const Instance& truth, Run run, std::mt19937& random) {
  run.id = fmt::format("run-{}", experiment.runs.size() + 1);
  Experiment one = experiment;
  one.runs.push_back(run);
  one.run_count = 0;
  for (Reading& reading : one.runs.back().readings) reading.Fx = reading.Fy = 0;
  const Study study(one);
  // An effect keeps its size in catalogue units when the experiment grows: its parameters are those.
  const Prediction predicted = predict(study, truth.candidate, truth.parameters);
  if (!predicted.reached || predicted.snapped || !study.nominal().reached) return false;
  std::normal_distribution<double> normal;
  const Trace& trace = predicted.runs.back();
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    run.readings[i].Fx = trace(row, column_Fx) + experiment.noise.Fx * normal(random);
    run.readings[i].Fy = trace(row, column_Fy) + experiment.noise.Fy * normal(random);
  }
  experiment.runs.push_back(std::move(run));
  return true;
}

/// Every press that `--next` could propose to a bench that turns nowhere and reads no angles.
std::vector<CandidateRun> candidates(const Study& study) {
  std::vector<CandidateRun> all;
  const Extent so_far = extent(study);
  const std::vector<double>& rest = study.experiment().runs.front().rest;
  for (const std::vector<double>& shape : {rest, mirrored(rest)})
    for (CandidateRun& one : presses(study.experiment(), shape, "here", so_far))
      all.push_back(std::move(one));
  return all;
}

bool add_random(Experiment& experiment, const Instance& truth, std::mt19937& random) {
  std::vector<CandidateRun> pool = candidates(Study(experiment));
  std::shuffle(pool.begin(), pool.end(), random);
  return std::any_of(pool.begin(), pool.end(),
                     [&](const CandidateRun& one) { return make(experiment, truth, one.run, random); });
}

bool add_proposed(Experiment& experiment, const Instance& truth, const Diagnosis& diagnosis,
                  std::mt19937& random) {
  for (const Proposal& one : diagnosis.proposals)
    if (!one.angles && make(experiment, truth, one.run, random)) return true;
  return add_random(experiment, truth, random);
}

/// Runs to a certain and right answer; nothing where it never came.
std::optional<std::size_t> runs_needed(Experiment experiment, const Instance& truth, bool follow,
                                       std::mt19937 random) {
  for (;;) {
    const Study study(experiment);
    const Diagnosis diagnosis = diagnose::diagnose(study, {}, follow);
    const Cause& cause = diagnosis.cause;
    if (cause.verdict == CauseVerdict::identified &&
        cause.ranking[cause.best].hypothesis.fit.candidate == truth.candidate)
      return experiment.runs.size();
    if (experiment.runs.size() == most_runs) return std::nullopt;
    if (!(follow ? add_proposed(experiment, truth, diagnosis, random)
                 : add_random(experiment, truth, random)))
      return std::nullopt;
  }
}

/// A first run on a bench with one effect; nothing where the draw cannot be made.
std::optional<Draw> draw(std::mt19937& random) {
  Draw one{chain(random), {}, {}};
  double bend = uniform(random, 0, 1) < 0.5 ? 1 : -1;
  for (std::size_t i = 0; i < one.bench.link_length.size(); ++i, bend = -bend)
    one.rest.push_back(bend * uniform(random, 0.3, 0.9));
  Experiment first = one.bench;
  first.runs.push_back({"start", Control::end_point, one.rest, {}});
  const std::vector<CandidateRun> pool = candidates(Study(first));
  const Run run = pool[below(random, pool.size())].run;
  first.runs = {run};
  for (Reading& reading : first.runs[0].readings) reading.Fx = reading.Fy = 0;
  const Study commanded(first);
  if (!commanded.nominal().reached || commanded.nominal().snapped) return std::nullopt;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    first.runs[0].readings[i].Fx = commanded.nominal().runs[0](static_cast<Eigen::Index>(i), column_Fx);
    first.runs[0].readings[i].Fy = commanded.nominal().runs[0](static_cast<Eigen::Index>(i), column_Fy);
  }
  const Study study(first);
  std::vector<EffectAt> single;  // whose parameters have a natural zero, and mean the same in any experiment
  for (const EffectAt& at : possible_effects(study)) {
    const std::vector<ParameterRange> ranges = study.ranges(at);
    if (std::all_of(ranges.begin(), ranges.end(), [](const ParameterRange& range) {
          return range.coordinate == Coordinate::plain && range.low <= 0 && range.tolerance == 0;
        }))
      single.push_back(at);
  }
  const EffectAt at = single[below(random, single.size())];
  one.truth.candidate = {{at}};
  for (const ParameterRange& range : study.ranges(at))
    one.truth.parameters.push_back(range.scale * uniform(random, 0.5, 1.5) *
                                   (range.low < 0 && uniform(random, 0, 1) < 0.5 ? -1 : 1));
  if (!make(one.bench, one.truth, run, random)) return std::nullopt;
  return one;
}

struct Count {
  std::string effect;
  std::optional<std::size_t> followed, random;
};

void print(const std::vector<Count>& counts) {
  const auto shown = [](const std::optional<std::size_t>& runs) {
    return runs ? std::to_string(*runs) : fmt::format("> {}", most_runs);
  };
  fmt::print("| draw | effect | `--next` | at random |\n| ---: | --- | ---: | ---: |\n");
  std::size_t settled = 0, more = 0, fewer = 0, at_once = 0;
  double followed = 0, random = 0, followed_after = 0, random_after = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Count& one = counts[i];
    fmt::print("| {} | {} | {} | {} |\n", i + 1, one.effect, shown(one.followed), shown(one.random));
    if (!one.followed && !one.random) continue;
    const auto a = static_cast<double>(one.followed.value_or(most_runs + 1));
    const auto b = static_cast<double>(one.random.value_or(most_runs + 1));
    ++settled, fewer += a<b, more += a> b, at_once += a == 1;
    followed += a, random += b, followed_after += a - 1, random_after += b - 1;
  }
  fmt::print(
      "\n{} draws: {} settled by either way within {} runs, {} of them by the first run; `--next` needs "
      "fewer "
      "runs in {}, more in {}.\n",
      counts.size(), settled, most_runs, at_once, fewer, more);
  fmt::print(
      "Runs in all of these: {} against {}, ratio {:.2f}; after the first, which both share: {} against {}, "
      "ratio {:.2f}. What was not settled counts as {}.\n",
      followed, random, followed / random, followed_after, random_after, followed_after / random_after,
      most_runs + 1);
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  const int draws = argc > 1 ? std::atoi(argv[1]) : 60;
  const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
  std::vector<Count> counts;
  for (unsigned stream = 0; static_cast<int>(counts.size()) < draws; ++stream) {
    std::seed_seq mixed{seed, stream};
    std::mt19937 random(mixed);
    const std::optional<Draw> one = draw(random);
    if (!one) continue;
    counts.push_back({one->truth.candidate.label(), runs_needed(one->bench, one->truth, true, random),
                      runs_needed(one->bench, one->truth, false, random)});
    fmt::print(stderr, "\r{} of {}", counts.size(), draws);
  }
  fmt::print(stderr, "\n");
  print(counts);
}
