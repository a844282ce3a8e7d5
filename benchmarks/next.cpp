/// \file
/// `bench-next [DRAWS] [SEED] [NOISE]`: how many runs it takes to a certain and right answer when each next
/// one is the first that the diagnosis proposes, beside runs drawn at random from the same candidates. Chains
/// of two and three links in a horizontal plane, forces measured, one effect at random; experiments of the
/// diagnosis' own forward model. Prints the tables of RESULTS-next.md.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <string>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/design/separation.hpp"
#include "diagnose/inference/white_noise_fit.hpp"

namespace plumbline::bench {
using namespace diagnose;
namespace {

constexpr std::size_t most_runs = 16;

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

Experiment chain(std::mt19937& random, double noise) {
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
  bench.noise = {1e-4, 1e-4, noise, noise, 0};
  return bench;
}

/// Adds a run to the bench as the truth measures it.
/// \returns false where the rig could not follow
bool make(Experiment& experiment, const Instance& truth, Run run, std::mt19937& random) {
  run.id = fmt::format("run-{}", experiment.runs.size() + 1);
  Experiment one = experiment;
  one.runs.push_back(run);
  one.run_count = 0;
  for (Reading& reading : one.runs.back().readings) reading[column_Fx] = reading[column_Fy] = 0;
  const Study study(one);
  // An effect keeps its size in catalogue units when the experiment grows: its parameters are those.
  const Prediction predicted = predict(study, truth.candidate, truth.parameters);
  if (!predicted.reached || predicted.snapped || !study.nominal().reached) return false;
  std::normal_distribution<double> normal;
  const Trace& trace = predicted.runs.back();
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    run.readings[i][column_Fx] = trace(row, column_Fx) + experiment.noise[Channel::Name::Fx] * normal(random);
    run.readings[i][column_Fy] = trace(row, column_Fy) + experiment.noise[Channel::Name::Fy] * normal(random);
  }
  experiment.runs.push_back(std::move(run));
  return true;
}

/// Every press that `--next` could propose to a bench that turns nowhere and reads no angles.
std::vector<Run> candidates(const Study& study) {
  std::vector<Run> all;
  const OperatingEnvelope so_far = operating_envelope(study);
  for (const Shape& shape : shapes(study.experiment(), 2)) {
    for (const CandidateRun& one : runs_from(study.experiment(), shape, so_far)) {
      Experiment bench = study.experiment();
      bench.runs = {one.run};
      const Prediction nominal = Study(bench).nominal();
      if (nominal.reached && !nominal.snapped && so_far.allows(nominal.runs[0], one.run))
        all.push_back(one.run);
    }
  }
  return all;
}

double travel(const Run& run) {
  double farthest = 0;
  for (const Reading& one : run.readings)
    farthest = std::max(farthest, std::hypot(one[column_x] - run.readings[0][column_x],
                                             one[column_y] - run.readings[0][column_y]));
  return farthest;
}

/// How the next run is chosen: as proposed, at random, or at random among the longest, there and back.
enum class Way { proposed, random, far };

bool add_random(Experiment& experiment, const Instance& truth, Way way, std::mt19937& random) {
  std::vector<Run> pool = candidates(Study(experiment));
  double farthest = 0;
  for (const Run& run : pool) farthest = std::max(farthest, travel(run));
  if (way == Way::far)
    std::erase_if(pool, [&](const Run& run) { return travel(run) < 0.99 * farthest || !run.turns_back(); });
  std::shuffle(pool.begin(), pool.end(), random);
  return std::any_of(pool.begin(), pool.end(),
                     [&](const Run& run) { return make(experiment, truth, run, random); });
}

bool add_run(Experiment& experiment, const Instance& truth, Way way, const Diagnosis& diagnosis,
             std::mt19937& random) {
  if (way == Way::proposed)
    for (const Proposal& one : diagnosis.proposals)
      if (!one.angles && make(experiment, truth, one.run, random)) return true;
  return add_random(experiment, truth, way, random);
}

/// Everything that the bench could measure of a truth next, without noise.
Experiment everything(const Experiment& experiment, const Instance& truth) {
  Experiment all = experiment;
  all.runs.clear();
  Experiment quiet = experiment;
  std::mt19937 unused;
  for (const Run& run : candidates(Study(experiment))) {
    if (!run.turns_back()) continue;
    quiet.runs.clear();
    quiet.noise[Channel::Name::Fx] = quiet.noise[Channel::Name::Fy] = 1e-12;
    if (make(quiet, truth, run, unused)) all.runs.push_back(quiet.runs.front());
  }
  return all;
}

/// Whether the answer is right and cannot be made more certain: the truth, alone or among explanations that
/// not even all runs that could be made next would together tell apart from it.
bool certain(const Cause& cause, const Experiment& experiment, const Instance& truth) {
  if (!cause.is_explained() || cause.or_unknown) return false;
  const std::vector<RankedCause> named(cause.ranking.begin(),
                                       cause.ranking.begin() + static_cast<std::ptrdiff_t>(cause.named));
  const auto is_truth = [&](const RankedCause& one) { return one.cause.is_form_of(truth.candidate); };
  if (std::none_of(named.begin(), named.end(), is_truth)) return false;
  if (named.size() == 1) return true;
  const Study study(everything(experiment, truth));
  return std::all_of(named.begin(), named.end(), [&](const RankedCause& one) {
    if (is_truth(one)) return true;
    const Hypothesis imitation = fit_in_white_noise(study, one.cause);
    return imitation.converged && imitation.residual.squaredNorm() / 2 < told_apart;
  });
}

/// Runs to a certain and right answer; nothing where it never came.
std::optional<std::size_t> runs_needed(Experiment experiment, const Instance& truth, Way way,
                                       std::mt19937 random) {
  for (;;) {
    const Study study(experiment);
    const Diagnosis diagnosis = diagnose::diagnose(study, {}, way == Way::proposed);
    if (certain(diagnosis.cause, experiment, truth)) return experiment.runs.size();
    if (experiment.runs.size() == most_runs || !add_run(experiment, truth, way, diagnosis, random))
      return std::nullopt;
  }
}

/// A first run on a bench with one effect; nothing where the draw cannot be made.
std::optional<Draw> draw(std::mt19937& random, double noise) {
  Draw one{chain(random, noise), {}, {}};
  double bend = uniform(random, 0, 1) < 0.5 ? 1 : -1;
  for (std::size_t i = 0; i < one.bench.link_length.size(); ++i, bend = -bend)
    one.rest.push_back(bend * uniform(random, 0.3, 0.9));
  Experiment first = one.bench;
  first.runs.push_back({"start", Control::end_point, one.rest, {}});
  const std::vector<Run> pool = candidates(Study(first));
  if (pool.empty()) return std::nullopt;
  const Run run = pool[below(random, pool.size())];
  first.runs = {run};
  for (Reading& reading : first.runs[0].readings) reading[column_Fx] = reading[column_Fy] = 0;
  const Study commanded(first);
  if (!commanded.nominal().reached || commanded.nominal().snapped) return std::nullopt;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    first.runs[0].readings[i][column_Fx] =
        commanded.nominal().runs[0](static_cast<Eigen::Index>(i), column_Fx);
    first.runs[0].readings[i][column_Fy] =
        commanded.nominal().runs[0](static_cast<Eigen::Index>(i), column_Fy);
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
  // Where no gap shows nobody asks what to measure next.
  if (!diagnose::diagnose(Study(one.bench)).gap.present) return std::nullopt;
  return one;
}

constexpr std::array ways{Way::proposed, Way::random, Way::far};

/// Runs by way, as `ways` lists them.
struct Count {
  std::string effect;
  std::array<std::optional<std::size_t>, ways.size()> runs;

  [[nodiscard]] bool settled() const {
    return std::any_of(runs.begin(), runs.end(), [](const auto& one) { return one.has_value(); });
  }
  /// What never settled counts as one run more than there may be.
  [[nodiscard]] std::size_t of(std::size_t way) const { return runs.at(way).value_or(most_runs + 1); }
};

void print(const std::vector<Count>& counts) {
  const auto shown = [](const std::optional<std::size_t>& runs) {
    return runs ? std::to_string(*runs) : fmt::format("> {}", most_runs);
  };
  fmt::print(
      "| draw | effect | `--next` | at random | far, at random |\n| ---: | --- | ---: | ---: | ---: |\n");
  std::array<std::size_t, ways.size()> sum{}, never{};
  std::size_t settled = 0, more = 0, fewer = 0, at_once = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const Count& one = counts[i];
    fmt::print("| {} | {} | {} | {} | {} |\n", i + 1, one.effect, shown(one.runs[0]), shown(one.runs[1]),
               shown(one.runs[2]));
    if (!one.settled()) continue;
    ++settled, fewer += one.of(0)<one.of(1), more += one.of(0)> one.of(1), at_once += one.of(0) == 1;
    for (std::size_t way = 0; way < ways.size(); ++way)
      sum.at(way) += one.of(way), never.at(way) += !one.runs.at(way);
  }
  fmt::print(
      "\n{} draws, {} settled by some way within {} runs, {} of them by the first run. `--next` needs fewer "
      "runs "
      "than chance in {}, more in {}; left open: {}, {} at random, {} far at random.\n",
      counts.size(), settled, most_runs, at_once, fewer, more, never[0], never[1], never[2]);
  const auto ratio = [&](std::size_t way, std::size_t shared) {
    return static_cast<double>(sum[0] - shared) / static_cast<double>(sum.at(way) - shared);
  };
  fmt::print(
      "Runs in these: {} against {} at random (ratio {:.2f}) and {} far at random ({:.2f}); after the first, "
      "which all share: {} against {} ({:.2f}) and {} ({:.2f}). What was left open counts as {}.\n",
      sum[0], sum[1], ratio(1, 0), sum[2], ratio(2, 0), sum[0] - settled, sum[1] - settled, ratio(1, settled),
      sum[2] - settled, ratio(2, settled), most_runs + 1);
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) {
  using namespace plumbline::bench;
  const int draws = argc > 1 ? std::atoi(argv[1]) : 60;
  const auto seed = static_cast<unsigned>(argc > 2 ? std::atoi(argv[2]) : 1);
  const double noise = argc > 3 ? std::atof(argv[3]) : 0.02;
  std::vector<Count> counts;
  for (unsigned stream = 0; static_cast<int>(counts.size()) < draws; ++stream) {
    std::seed_seq mixed{seed, stream};
    std::mt19937 random(mixed);
    const std::optional<Draw> one = draw(random, noise);
    if (!one) continue;
    counts.push_back({one->truth.candidate.label(), {}});
    for (std::size_t way = 0; way < ways.size(); ++way)
      counts.back().runs.at(way) = runs_needed(one->bench, one->truth, ways.at(way), random);
    fmt::print(stderr, "\r{} of {}", counts.size(), draws);
  }
  fmt::print(stderr, "\n");
  print(counts);
}
