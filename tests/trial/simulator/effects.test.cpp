#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/folder.hpp"
#include "trial/simulator/write_experiment.hpp"

namespace {

using plumbline::diagnose::Candidate;

/// The true effects, and their parameters in the coordinates of the forward model.
struct Truth {
  Candidate effects;
  std::vector<double> parameters;
};

double value_of(const plumbline::trial::TrueEffect& effect, std::string_view name) {
  for (const auto& [own, value] : effect.parameters)
    if (own == name) return value;
  // of hysteresis the simulator draws as many elements as it likes: one that the label has not is nothing
  const auto element = static_cast<std::size_t>(name.back() - '0');
  if (effect.id == "hysteresis" && 2 * element > effect.parameters.size()) return 0;
  throw plumbline::Error(effect.id, "a label without the parameter " + std::string(name), "one with it");
}

/// Without wild readings, whose number is left to chance, and with no more elements than the diagnosis has.
plumbline::simulator::Experiment one_with(const plumbline::simulator::Kind& kind, std::uint64_t stream) {
  for (;; stream += 1000) {
    plumbline::simulator::Random random(3, stream);
    auto made = plumbline::simulator::make_experiment({{&kind}, {15}}, "one", random);
    const bool few = kind.id != "hysteresis" || made.label.effects.front().parameters.size() <= 4;
    if (few && made.scatter.outliers == 0) return made;
  }
}

/// The row of the diagnosis, of one joint or of none alike, with one value for all joints or one at each; or
/// null.
const plumbline::diagnose::Effect* row_of(std::string_view id, bool at_joint, bool each) {
  const plumbline::diagnose::Effect* found = nullptr;
  for (const plumbline::diagnose::Effect& effect : plumbline::diagnose::catalogue())
    if (effect.id == id && effect.at_joint == at_joint && (found == nullptr || each)) found = &effect;
  return found;
}

bool has_values_at_each(const plumbline::trial::TrueEffect& effect) {
  return std::any_of(effect.parameters.begin(), effect.parameters.end(),
                     [](const auto& one) { return std::string_view(one.first).ends_with("_1"); });
}

Truth truth_of(const plumbline::trial::Label& label, const plumbline::diagnose::Experiment& experiment) {
  Truth truth;
  for (const auto& effect : label.effects) {
    const plumbline::diagnose::EffectAt at(*row_of(effect.id, effect.joint > 0, has_values_at_each(effect)),
                                           effect.joint);
    truth.effects.effects.push_back(at);
    const auto ranges = plumbline::diagnose::Study(experiment).ranges(at);
    for (const auto& range : ranges)
      truth.parameters.push_back(
          plumbline::diagnose::fitted_value(range.coordinate, value_of(effect, range.name)));
  }
  return truth;
}

double rms(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

TEST_CASE("every effect of the catalogue does in the rig what the forward model of the diagnosis predicts" *
          doctest::test_suite("long")) {
  for (const plumbline::simulator::Kind& kind : plumbline::simulator::catalogue()) {
    CAPTURE(kind.id);
    if (!row_of(kind.id, kind.at_joint, !kind.each.empty())) {
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
    // Noise has rms 1, up to 1.03 with the coarsest resolution; a twentieth of the gap would show.
    CHECK(left(truth) < 1.25);
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
