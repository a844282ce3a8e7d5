#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/model/measurement.hpp"
#include "diagnose/model/study.hpp"
#include "simulator/write_experiment.hpp"
#include "tests/folder.hpp"

namespace {

using plumbline::diagnose::Candidate;

/// The true effects, and their parameters in the coordinates of the forward model.
struct Truth {
  Candidate effects;
  std::vector<double> parameters;
};

/// An element beyond those of the label is nothing.
double value_of(const plumbline::trial::TrueEffect& effect, std::string_view name) {
  for (const auto& [own, value] : effect.parameters)
    if (own == name) return value;
  if (effect.id == "hysteresis") return 0;
  throw plumbline::Error(effect.id, "a label without the parameter " + std::string(name), "one with it");
}

/// Of hysteresis the simulator draws up to five elements, the diagnosis looks for fewer.
plumbline::simulator::Experiment one_with(const plumbline::simulator::Kind& kind, std::uint64_t stream) {
  for (;; stream += 1000) {
    plumbline::simulator::Random random(3, stream);
    auto made = plumbline::simulator::make_experiment({{&kind}, {15}}, "one", random);
    if (kind.id != "hysteresis" || made.label.effects.front().parameters.size() <= 4) return made;
  }
}

/// Whether the diagnosis has a row for it, at one joint or at none alike.
bool known(const plumbline::simulator::Kind& kind) {
  const auto& all = plumbline::diagnose::catalogue();
  return std::any_of(all.begin(), all.end(), [&](const plumbline::diagnose::Effect& effect) {
    return effect.id == kind.id && effect.at_joint == kind.at_joint;
  });
}

Truth truth_of(const plumbline::trial::Label& label, const plumbline::diagnose::Experiment& experiment) {
  Truth truth;
  for (const auto& effect : label.effects) {
    const plumbline::diagnose::EffectAt at(plumbline::diagnose::effect(effect.id), effect.joint);
    truth.effects.effects.push_back(at);
    const auto ranges = plumbline::diagnose::Study(experiment).ranges(at);
    for (const auto& range : ranges)
      truth.parameters.push_back(
          plumbline::diagnose::fitted_value(range.coordinate, value_of(effect, range.name)));
  }
  return truth;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

TEST_CASE("every effect of the catalogue does in the rig what the forward model of the diagnosis predicts") {
  for (const plumbline::simulator::Kind& kind : plumbline::simulator::catalogue()) {
    CAPTURE(kind.id);
    if (!known(kind)) {
      MESSAGE("not in the diagnosis: " << kind.id);
      continue;
    }
    const auto made =
        one_with(kind, static_cast<std::uint64_t>(&kind - plumbline::simulator::catalogue().data()));
    const Folder folder;
    plumbline::simulator::write_experiment(made, folder.path());
    const plumbline::diagnose::Experiment experiment = plumbline::diagnose::read_experiment(folder.path());
    const Truth truth = truth_of(made.label, experiment);
    const plumbline::diagnose::Study study(experiment);
    const auto left = [&](const Truth& with) {
      return rms(study.residual(predict(study, with.effects, with.parameters))) / made.scatter.sigma.force *
             made.scatter.declared.force;
    };
    CHECK(left({}) > 10);
    // Noise has rms 1, up to 1.03 with the coarsest resolution; outliers of 25 sigma in 2 of 100 readings add
    // at most 2.5. A dozenth of the gap would show.
    CHECK(left(truth) < (made.scatter.outliers > 0 ? 3 : 1.25));
    CHECK(left(truth) > 0.75);
  }
}

TEST_CASE("an experiment is the same at every making, and another with another seed") {
  const auto text = [](std::uint64_t seed) {
    const auto made =
        plumbline::simulator::make_experiment(plumbline::simulator::Trial::first, seed, 2, "one");
    return made.runs.front().back().force[0];
  };
  CHECK(text(11) == text(11));
  CHECK(text(11) != text(12));
}
