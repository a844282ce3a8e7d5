#include "diagnose/inference/fits.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <plumbline/base/parallel.hpp>

#include "diagnose/inference/affordable.hpp"

namespace plumbline::diagnose {
namespace {

/// Hypotheses within so many nats of the best are maximised beside a discrepancy, so many at most.
constexpr double near_best = 25;
constexpr std::size_t refined_at_once = 12, refined_at_last = 24;

constexpr Effort fine{12, 0.03};

/// A rough fit ends where an iteration takes half a per cent off the squares.
Effort rough(std::size_t values) {
  return {12, std::max(0.1, 0.0025 * static_cast<double>(values)), true};
}

}  // namespace

bool is_same(const Candidate& a, const Candidate& b) {
  return a.effects.size() == b.effects.size() &&
         std::is_permutation(a.effects.begin(), a.effects.end(), b.effects.begin(), b.effects.end());
}

Fits::Fits(const Study& study) : study_(study), nominal_residual_(study.nominal_residual()) {
  found.states = std::make_shared<CommandStates>(study.experiment());
  set_noise(nominal_residual_, NoiseShape(study.measurements()), Departures::ignored);
}

/// The likelihoods for the noise that a residual shows.
void Fits::set_noise(const VectorXd& residual, NoiseShape start, Departures departures) {
  const Measurements& measurements = study_.measurements();
  const NoiseShape shape = estimate_noise(study_.experiment(), measurements, *found.states, nominal_residual_,
                                          residual, std::move(start), departures);
  const auto likelihood_of = [&](const Hyperpriors& priors, const NoiseShape& in) {
    return std::make_shared<Likelihood>(measurements, *found.states, priors, in, nominal_residual_);
  };
  const auto full = likelihood_of(full_model(), shape);
  full->prune(residual);
  found.likelihood = full;
  rough_likelihood_ = likelihood_of(white_noise_alone(), shape);
  all_readings_ =
      shape.has_outliers() ? likelihood_of(white_noise_alone(), NoiseShape(measurements)) : nullptr;
  found.nominal = full->look(nominal_residual_);
  const Decomposition parts = full->decompose(residual);
  weight_ = shape.relative.cwiseInverse();
  for (std::size_t b = 0; b < parts.noise.channels.size(); ++b) {
    const Block& block = measurements.blocks()[b];
    weight_.segment(block.first, block.count) /= parts.noise.channels[b].scale;
  }
  for (std::size_t i = 0; i < shape.outlier.size(); ++i)
    if (shape.outlier[i]) weight_(static_cast<Eigen::Index>(i)) = 0;
}

const Hypothesis* Fits::find(const Candidate& candidate) const {
  const auto place = std::find_if(found.hypotheses.begin(), found.hypotheses.end(),
                                  [&](const Hypothesis& h) { return is_same(h.candidate, candidate); });
  return place == found.hypotheses.end() ? nullptr : &*place;
}

/// Probability that nothing is left beside a hypothesis.
double Fits::nothing_left(const Hypothesis& one) const {
  return std::exp(log_posterior(one.look.log_by_amplitude, found.likelihood->priors().log_amplitude).front());
}

double Fits::squares(const Hypothesis& h) const {
  return weight_.cwiseProduct(h.residual).squaredNorm();
}

/// Fits side by side, in white noise and then weighed beside a discrepancy; maximises there what leads.
void Fits::fit(const std::vector<Task>& tasks, const std::function<void(double)>& report) {
  std::vector<Hypothesis> fitted(tasks.size());
  std::size_t done = 0;
  std::mutex one_at_a_time;
  in_parallel(tasks.size(), study_.threads(), [&](std::size_t t) {
    if (affordable(study_, tasks[t].candidate)) {
      fitted[t] = fitted_roughly(tasks[t], *rough_likelihood_);
      // An outlier may be what an effect does, which a fit without it does not see.
      if (all_readings_ && tasks[t].candidate.effects.size() == 1)
        if (Hypothesis other = fitted_roughly(tasks[t], *all_readings_);
            other.converged && !(other.log_evidence < fitted[t].log_evidence && fitted[t].converged))
          fitted[t] = std::move(other);
    }
    const std::lock_guard only(one_at_a_time);
    report(static_cast<double>(++done) / static_cast<double>(tasks.size()));
  });
  for (Hypothesis& one : fitted) add(std::move(one));
  sort();
  refine(refined_at_once, near_best);
}

/// Fitted in white noise, and weighed beside a discrepancy.
Hypothesis Fits::fitted_roughly(const Task& task, const Likelihood& white) const {
  Hypothesis one = maximised(study_, white, task.candidate, task.starts, rough(study_.measurements().size()));
  if (one.converged) look_again(study_, *found.likelihood, one);
  return one;
}

/// Keeps the better of two fits of one candidate.
void Fits::add(Hypothesis one) {
  if (!one.converged) return;
  const auto place = std::find_if(found.hypotheses.begin(), found.hypotheses.end(),
                                  [&](const Hypothesis& h) { return is_same(h.candidate, one.candidate); });
  if (place == found.hypotheses.end()) {
    found.hypotheses.push_back(std::move(one));
  } else if (one.log_evidence > place->log_evidence) {
    *place = std::move(one);
  }
}

void Fits::sort() {
  std::stable_sort(found.hypotheses.begin(), found.hypotheses.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
}

/// Maximises beside a discrepancy what leads, and was not yet.
void Fits::refine(std::size_t most, double near) {
  std::vector<Hypothesis*> leading;
  for (Hypothesis& h : found.hypotheses)
    if (!h.refined && leading.size() < most && h.log_evidence > found.hypotheses.front().log_evidence - near)
      leading.push_back(&h);
  in_parallel(leading.size(), study_.threads(), [&](std::size_t i) {
    Hypothesis better =
        maximised(study_, *found.likelihood, leading[i]->candidate, leading[i]->parameters, fine);
    better.refined = true;
    if (better.converged) *leading[i] = std::move(better);
  });
  sort();
}

/// Estimates the noise again where the best hypothesis is taken away, and weighs all by it.
void Fits::settle() {
  if (found.hypotheses.empty()) return;
  for (int round = 0; round < 2; ++round) {
    const NoiseShape before = found.likelihood->shape();
    NoiseShape start(study_.measurements());
    start.outlier = before.outlier;
    set_noise(found.hypotheses.front().residual, std::move(start), Departures::sought);
    for (Hypothesis& h : found.hypotheses) look_again(study_, *found.likelihood, h);
    sort();
    const NoiseShape& now = found.likelihood->shape();
    if (now.outlier == before.outlier && now.relative == before.relative) break;
  }
  for (Hypothesis& h : found.hypotheses) h.refined = false;
  refine(refined_at_last, near_best / 2);
}

void Fits::maximise(const std::vector<Instance>& starts) {
  std::vector<Hypothesis> fitted(starts.size());
  in_parallel(starts.size(), study_.threads(), [&](std::size_t i) {
    fitted[i] = maximised(study_, *found.likelihood, starts[i].candidate, starts[i].parameters, fine);
  });
  for (Hypothesis& one : fitted) add(std::move(one));
  sort();
}

}  // namespace plumbline::diagnose
