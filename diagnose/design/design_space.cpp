#include "diagnose/design/design_space.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/unmeasured.hpp"
#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/inference/start.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::diagnose {
namespace {

/// Largest number of rest shapes beside the planned runs; each adds sixteen runs.
constexpr std::size_t most_shapes = 4;

Experiment with_runs(const Experiment& bench, const std::vector<CandidateRun>& candidates) {
  Experiment all = bench;
  all.runs.clear();
  for (const CandidateRun& one : candidates) {
    all.runs.push_back(one.run);
    all.runs.back().number = 0;
  }
  all.run_count = 1;
  return unmeasured(std::move(all));
}

bool follows(const Experiment& bench, const CandidateRun& candidate, const Rig& rig) {
  const Prediction predicted = simulate(with_runs(bench, {candidate}), rig, {});
  return predicted.reached && !predicted.snapped;
}

std::vector<CandidateRun> planned_runs(const Experiment& bench) {
  std::vector<CandidateRun> all;
  for (const Run& run : bench.runs)
    if (!run.readings.empty()) all.push_back({run.id + " as planned", run});
  return all;
}

/// Presses and loads, there and back, that the nominal model can follow within the operating envelope, and
/// single poses.
std::vector<CandidateRun> further_runs(const Study& described) {
  std::vector<CandidateRun> all =
      candidate_runs(described.experiment(), most_shapes, operating_envelope(described));
  std::erase_if(all,
                [](const CandidateRun& one) { return one.run.readings.size() > 1 && !one.run.turns_back(); });
  return all;
}

/// An effect at its typical size. Values at each joint alternate in size or sign, for equal ones would be
/// another effect. Parameters without a natural zero take an initial guess.
std::vector<double> typical(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  const InitialGuesses known = initial_guesses(study, at);
  std::vector<double> values = known.points[known.points.size() / 2];
  for (std::size_t p = 0; p < values.size(); ++p) {
    const ParameterRange& range = ranges[p];
    const bool odd = p % 2 == 1, one_sided = range.low == 0;
    if (range.coordinate == Coordinate::reciprocal) values[p] = std::max(values[p], range.scale);
    if (!range.may_be_nothing()) continue;
    if (range.tolerance > 0) {
      values[p] = range.tolerance * (one_sided ? (odd ? 0.5 : 1.5) : (odd ? -1.0 : 1.0));
    } else {
      values[p] = range.scale;
    }
  }
  return values;
}

/// Halves the parameters that can grow from zero, or whose reciprocals can.
void halve(const Study& study, Instance& effect) {
  const std::vector<ParameterRange> ranges = study.ranges(effect.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].may_be_nothing() || ranges[p].coordinate == Coordinate::reciprocal)
      effect.parameters[p] /= 2;
}

/// By candidate run, whether the rig with the effect can follow it.
std::vector<bool> followed(const Study& study, const std::vector<CandidateRun>& candidates,
                           const Instance& effect) {
  const Rig rig = rig_with(study, effect.candidate, effect.parameters);
  std::vector<bool> result;
  for (const CandidateRun& one : candidates) result.push_back(follows(study.experiment(), one, rig));
  return result;
}

/// The effects at the largest sizes with which each can follow all planned and most other runs.
/// \param candidates  runs; those that some effect cannot follow are removed
std::vector<Instance> followable(const Study& study, std::vector<CandidateRun>& candidates,
                                 std::size_t& planned) {
  std::vector<bool> kept(candidates.size(), true);
  std::vector<Instance> all;
  for (const EffectAt& at : possible_effects(study)) {
    Instance effect{{{at}}, typical(study, at)};
    std::vector<bool> can = followed(study, candidates, effect);
    const auto enough = [&] {
      const auto middle = can.begin() + static_cast<std::ptrdiff_t>(planned);
      return std::find(can.begin(), middle, false) == middle &&
             2 * std::count(middle, can.end(), false) <= can.end() - middle;
    };
    for (int halved = 0; halved < 6 && !enough(); ++halved) {
      halve(study, effect);
      can = followed(study, candidates, effect);
    }
    for (std::size_t r = 0; r < kept.size(); ++r) kept[r] = kept[r] && can[r];
    all.push_back(std::move(effect));
  }
  std::vector<CandidateRun> left;
  std::size_t planned_left = 0;
  for (std::size_t r = 0; r < kept.size(); ++r) {
    if (!kept[r]) continue;
    planned_left += r < planned;
    left.push_back(std::move(candidates[r]));
  }
  candidates = std::move(left);
  planned = planned_left;
  return all;
}

/// Effects that cannot act on this bench, or that it cannot measure, with any number of runs.
std::vector<EffectAt> impossible_effects(const Study& study) {
  CharacteristicScales again = study.scales();  // a repetition of a run would distinguish them
  again.runs = 2;
  std::vector<EffectAt> all;
  for (const Effect* row : study.effects()) {
    const std::size_t first = row->at_joint ? 1 : 0, last = row->at_joint ? again.link_length.size() : 0;
    for (std::size_t joint = first; joint <= last; ++joint)
      if (!row->possible({again, joint > 0 ? joint - 1 : 0})) all.emplace_back(*row, joint);
  }
  return all;
}

}  // namespace

Experiment measured_as(Experiment experiment, const Prediction& predicted) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      if (!(channel.sigma(experiment.noise) > 0)) continue;
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        channel.in(run.readings[i]) = predicted.runs[r](static_cast<Eigen::Index>(i), channel.column);
    }
  }
  return experiment;
}

DesignSpace design_space(const Experiment& bench) {
  const Study described(bench);
  if (!described.nominal().reached)
    throw Error("experiment \"" + bench.name + "\"", "runs that the nominal chain cannot follow",
                "end points within reach and a stable posture at every reading");
  DesignSpace space;
  std::vector<CandidateRun> candidates = planned_runs(bench);
  space.planned = candidates.size();
  for (CandidateRun& one : further_runs(described)) candidates.push_back(std::move(one));
  const auto measured = [&] {
    const Experiment all = with_runs(bench, candidates);
    return measured_as(all, simulate(all, nominal_rig(all), {}));
  };
  const auto require_any = [&] {
    if (candidates.empty())
      throw Error("experiment \"" + bench.name + "\"",
                  "no press or load that its chain and every effect can follow",
                  "rest shapes that leave room to move, or runs with commands");
  };
  require_any();
  const Study study(measured());
  space.effects = followable(study, candidates, space.planned);
  require_any();
  space.impossible = impossible_effects(study);
  space.bench = measured();
  for (const CandidateRun& one : candidates) space.descriptions.push_back(one.description);
  return space;
}

}  // namespace plumbline::diagnose
