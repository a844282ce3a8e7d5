#pragma once
/// \file
/// The hypotheses of a search, each candidate with the best of its fits, weighed by the same noise.

#include <functional>
#include <memory>

#include "diagnose/inference/search.hpp"
#include "diagnose/noise/estimate_noise.hpp"

namespace plumbline::diagnose {

/// A candidate to be fitted.
struct Task {
  Candidate candidate;
  InitialGuesses starts;
  double promise = 0;  ///< forecast of the logarithm of its evidence, at most
};

/// Whether both have the same effects, in any order.
bool is_same(const Candidate& a, const Candidate& b);

class Fits {
 public:
  /// With the noise that the nominal model leaves beside a discrepancy.
  explicit Fits(const Study& study);

  /// Nothing where it was not fitted.
  [[nodiscard]] const Hypothesis* find(const Candidate& candidate) const;
  /// Probability that nothing is left beside a hypothesis.
  [[nodiscard]] double nothing_left(const Hypothesis& one) const;
  /// That it leaves, in the noise.
  [[nodiscard]] double squares(const Hypothesis& h) const;
  /// By value: one over its noise, in declared sigmas; zero of outliers.
  [[nodiscard]] const VectorXd& weight() const { return weight_; }

  /// Fits side by side, in white noise and then weighed beside a discrepancy; maximises there what leads.
  /// \param report  called with the share that is done
  void fit(
      const std::vector<Task>& tasks, const std::function<void(double)>& report = [](double) {});
  /// Maximises beside a discrepancy from given values.
  void maximise(const std::vector<Instance>& starts);
  /// Estimates the noise again where the best hypothesis is taken away, and weighs all by it.
  void settle();

  Findings found;

 private:
  void set_noise(const VectorXd& residual, NoiseShape start, Departures departures);
  [[nodiscard]] Hypothesis fitted_roughly(const Task& task, const Likelihood& white) const;
  void add(Hypothesis one);
  void sort();
  void refine(std::size_t most, double near);

  const Study& study_;
  VectorXd nominal_residual_;
  std::shared_ptr<const Likelihood> rough_likelihood_;  ///< in white noise
  std::shared_ptr<const Likelihood>
      all_readings_;  ///< the same, no reading an outlier; none where none is marked
  VectorXd weight_;
};

}  // namespace plumbline::diagnose
