/// \file
/// Writes, as JSON, what the rig predicts beside each hypothesis that a search finds, and the verdict: the
/// data from which decide.test.py computes the verdict again by docs/how-it-decides.md, and
/// trial/benches/sensitivity.py what other priors would say.
///
///     hypotheses FOLDER...

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "diagnose/bench/decimate.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/decision/verdict.hpp"
#include "diagnose/inference/imposed_noise.hpp"
#include "diagnose/inference/prior.hpp"
#include "diagnose/rig/rig.hpp"

using namespace plumbline::diagnose;
using Json = nlohmann::json;

namespace {

std::vector<double> list(const VectorXd& values) {
  return {values.begin(), values.end()};
}

Json columns(const MatrixXd& matrix) {
  Json all = Json::array();
  for (const auto& column : matrix.colwise()) all.push_back(list(column));
  return all;
}

std::vector<double> factors_of(const std::vector<NoisierSegment>& noisier) {
  std::vector<double> factors;
  for (const NoisierSegment& one : noisier) factors.push_back(one.factor);
  return factors;
}

std::vector<bool> clocks(const Experiment& experiment) {
  std::vector<bool> all;
  for (const Run& run : experiment.runs) all.push_back(!run.counts_readings());
  return all;
}

/// The command of every reading, from rest.
Json runs(const Experiment& experiment) {
  Json all = Json::array();
  for (const Run& run : experiment.runs) {
    const Eigen::Vector2d rest =
        run.holds_end_point() ? Eigen::Vector2d(unloaded_end(experiment, run.rest)) : Eigen::Vector2d(0, 0);
    Json command = Json::array();
    for (const Reading& reading : run.readings) {
      const Eigen::Vector2d now = run.command(reading) - rest;
      command.push_back(now.allFinite() ? Json{now.x(), now.y()} : Json(nullptr));
    }
    all.push_back({{"displacement", run.holds_end_point()}, {"rest", run.rest}, {"command", command}});
  }
  return all;
}

Json parameter(std::size_t effect, const ParameterRange& range, double value, bool at_bound) {
  const bool gaussian = range.tolerance > 0;
  const bool size = range.may_be_nothing() || range.coordinate == Coordinate::reciprocal;
  return {{"value", value},
          {"at_bound", at_bound},
          {"effect", effect},
          {"prior", gaussian           ? "gaussian"
                    : size             ? "size"
                    : range.is_onset() ? "cauchy"
                                       : "uniform"},
          {"scale", gaussian ? range.tolerance : range.scale},
          {"low", range.low},
          {"high", range.high}};
}

Json hypothesis(const Study& study, const Findings& findings, const Hypothesis& one) {
  Json effects = Json::array(), parameters = Json::array();
  bool outside = false;
  bool untimed = false;
  for (const EffectAt& at : one.candidate.effects) {
    untimed =
        untimed || std::find(findings.untimed.begin(), findings.untimed.end(), at) != findings.untimed.end();
    const bool tolerance = one.candidate.has_as_tolerance(at);
    outside = outside || at.effect->outside;
    effects.push_back({{"label", at.label()}, {"tolerance", tolerance}, {"outside", at.effect->outside}});
  }
  for (std::size_t e = 0; e < one.candidate.effects.size(); ++e)
    for (const ParameterRange& range : study.ranges(one.candidate.effects[e])) {
      const std::size_t p = parameters.size();
      parameters.push_back(parameter(e, range, one.parameters[p], one.at_bound[p]));
    }
  Json result{{"effects", effects},
              {"parameters", parameters},
              {"residual", list(one.residual)},
              {"jacobian", columns(one.jacobian)},
              {"untimed", untimed},
              {"log_prior", one.log_prior}};
  if (outside) result["discrepancy"] = discrepancy_share(study, findings, one);
  return result;
}

/// Every way in which the readings may have come about.
Json all_ways(const Study& study, const Findings& findings) {
  static constexpr const char* of[] = {"nothing", "listed", "outside"};
  Json all = Json::array();
  for (const Way& way : ways(study, findings)) {
    const bool fitted = way.hypothesis != Way::none;
    const Candidate candidate = fitted ? findings.hypotheses[way.hypothesis].candidate : Candidate{};
    all.push_back({{"of", of[static_cast<std::size_t>(way.of)]},
                   {"effects", candidate.label()},
                   {"count", candidate.count()},
                   {"log_prior", way.log_prior},
                   {"log_evidence", way.log_evidence},
                   {"discrepancy", way.discrepancy}});
  }
  return all;
}

Json described(const std::string& folder) {
  const Study study(decimated(with_probable_motion(read_experiment(folder, nullptr))));
  const Findings findings = search(study);
  const Posterior found = posterior(study, findings);
  const Verdict verdict = decide(found);
  const Measurements& measurements = study.measurements();
  const NoiseShape& shape = findings.likelihood->shape();
  Json blocks = Json::array(), places = Json::array(), named = Json::array(), hypotheses = Json::array();
  for (const Block& block : measurements.blocks()) blocks.push_back({block.first, block.count});
  for (const ReadingPlace& place : measurements.places()) places.push_back({place.run, place.reading});
  for (std::size_t i = 0; i < verdict.named; ++i) named.push_back(found.causes[i].labels);
  for (const Hypothesis& one : findings.hypotheses) hypotheses.push_back(hypothesis(study, findings, one));
  return {{"folder", folder},
          {"runs", runs(study.experiment())},
          {"blocks", blocks},
          {"places", places},
          {"clock", clocks(study.experiment())},
          {"value", list(measurements.value())},
          {"sigma", list(measurements.sigma())},
          {"relative", list(shape.relative)},
          {"outlier", shape.outlier},
          {"noisier", factors_of(shape.noisier)},
          {"periodic", columns(shape.periodic)},
          {"nominal", list(study.nominal_residual())},
          {"hypotheses", hypotheses},
          {"ways", all_ways(study, findings)},
          {"verdict", verdict_word(verdict.verdict)},
          {"named", named},
          {"or_outside", verdict.or_outside},
          {"no_gap", found.no_gap},
          {"outside", found.outside}};
}

}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) std::cout << described(arguments[i]) << std::endl;
}
