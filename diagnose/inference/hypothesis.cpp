#include "diagnose/inference/hypothesis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "diagnose/inference/fitted_volume.hpp"
#include "diagnose/inference/prior.hpp"

namespace plumbline::diagnose {
namespace {

double log_density(const std::vector<ParameterRange>& ranges, const std::vector<double>& parameters,
                   const Effort& effort) {
  double sum = 0;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0 || !effort.likelihood_alone)
      sum += ParameterPrior(ranges[p]).log_density(parameters[p]);
  return sum;
}

/// Residual and Jacobian at parameters. \returns whether the rig can follow the experiment there
bool predict_into(const Study& study, Hypothesis& h, bool with_jacobian) {
  const Prediction predicted = predict(study, h.candidate, h.parameters, with_jacobian);
  h.converged = predicted.reached;
  if (!h.converged) return false;
  h.residual = study.residual(predicted);
  h.jacobian.resize(h.residual.size(), with_jacobian ? static_cast<Eigen::Index>(h.parameters.size()) : 0);
  for (Eigen::Index p = 0; p < h.jacobian.cols(); ++p)
    h.jacobian.col(p) = -study.in_sigmas(predicted.sensitivity[static_cast<std::size_t>(p)]);
  h.converged = h.residual.allFinite() && h.jacobian.allFinite();
  return h.converged;
}

void mark_bounds(const std::vector<ParameterRange>& ranges, Hypothesis& h) {
  h.at_bound.assign(ranges.size(), false);
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const double margin = 1e-6 * ranges[p].scale;
    h.at_bound[p] = h.parameters[p] <= ranges[p].low + margin || h.parameters[p] >= ranges[p].high - margin;
  }
}

/// Gradient and curvature of the log posterior by the parameters.
struct Slope {
  VectorXd gradient;
  MatrixXd curvature;
  /// Of a step, by the second order.
  [[nodiscard]] double gain(const VectorXd& step) const {
    return gradient.dot(step) - step.dot(curvature * step) / 2;
  }
};

Slope slope_of(const std::vector<ParameterRange>& ranges, const Hypothesis& h, const Effort& effort) {
  Slope slope{h.look.gradient, h.look.information};
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const auto k = static_cast<Eigen::Index>(p);
    if (effort.likelihood_alone && !(ranges[p].tolerance > 0)) continue;
    const double c = ParameterPrior(ranges[p]).curvature(h.parameters[p]);
    slope.gradient(k) -= c * h.parameters[p];
    slope.curvature(k, k) += c;
  }
  return slope;
}

/// Parameters that may move: not at a bound beyond which they would go.
std::vector<Eigen::Index> free_parameters(const std::vector<ParameterRange>& ranges, const Hypothesis& h,
                                          const VectorXd& gradient) {
  std::vector<Eigen::Index> free;
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const auto k = static_cast<Eigen::Index>(p);
    const double margin = 1e-9 * ranges[p].scale;
    const bool held = (h.parameters[p] <= ranges[p].low + margin && gradient(k) < 0) ||
                      (h.parameters[p] >= ranges[p].high - margin && gradient(k) > 0);
    if (!held) free.push_back(k);
  }
  return free;
}

Eigen::Map<const VectorXd> vector(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// Whether the derivatives hold along a step: next to parameters' typical sizes.
bool is_short(const std::vector<ParameterRange>& ranges, const VectorXd& step) {
  constexpr double next_to = 0.1;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (!(std::abs(step(static_cast<Eigen::Index>(p))) <= next_to * ranges[p].scale)) return false;
  return true;
}

/// The parameters after a damped step of Gauss and Newton: those that it would lead beyond their bounds end
/// there, and the others make the best of that.
std::vector<double> stepped(const std::vector<ParameterRange>& ranges, std::vector<double> parameters,
                            const Slope& slope, std::vector<Eigen::Index> free, double damping) {
  VectorXd step = VectorXd::Zero(slope.gradient.size());
  for (bool all_inside = false; !all_inside;) {
    MatrixXd curvature = slope.curvature(free, free);
    for (std::size_t f = 0; f < free.size(); ++f) {
      const auto k = static_cast<Eigen::Index>(f);
      const double scale = ranges[static_cast<std::size_t>(free[f])].scale;
      curvature(k, k) += damping * std::max(curvature(k, k), 1 / (scale * scale));
    }
    const VectorXd left = slope.gradient - slope.curvature * step;
    const VectorXd own = curvature.ldlt().solve(VectorXd(left(free)));
    std::vector<Eigen::Index> inside;
    std::vector<double> by;
    for (std::size_t f = 0; f < free.size(); ++f) {
      const auto p = static_cast<std::size_t>(free[f]);
      const double wanted = own(static_cast<Eigen::Index>(f)), least = ranges[p].low - parameters[p],
                   most = ranges[p].high - parameters[p];
      if (wanted < least || wanted > most)
        step(free[f]) = std::clamp(wanted, least, most);
      else
        inside.push_back(free[f]), by.push_back(wanted);
    }
    all_inside = inside.size() == free.size();
    for (std::size_t f = 0; all_inside && f < free.size(); ++f) step(free[f]) = by[f];
    free = std::move(inside);
  }
  for (std::size_t p = 0; p < parameters.size(); ++p)
    parameters[p] =
        std::clamp(parameters[p] + step(static_cast<Eigen::Index>(p)), ranges[p].low, ranges[p].high);
  return parameters;
}

/// Evidence by Laplace's method at the parameters.
void weigh(const Study& study, Hypothesis& h) {
  h.log_volume = log_volume(study, h);
  h.log_prior = log_prior(study, h.candidate);
  h.log_evidence = h.log_prior + h.look.log_likelihood + h.log_volume;
}

}  // namespace

Hypothesis maximised(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                     const std::vector<double>& start, const Effort& effort) {
  const std::vector<ParameterRange> ranges = study.ranges(candidate);
  Hypothesis best;
  best.candidate = candidate;
  best.parameters = start;
  const auto look = [&](Hypothesis& h) {
    h.look = likelihood.look(h.residual, h.jacobian);
    h.log_posterior = h.look.log_likelihood + log_density(ranges, h.parameters, effort);
  };
  const auto evaluate = [&](Hypothesis& h) {
    if (!predict_into(study, h, true)) return false;
    look(h);
    return std::isfinite(h.log_posterior);
  };
  if (!evaluate(best)) {
    best.converged = false;
    return best;
  }
  constexpr double least_damping = 1e-9;
  double damping = 1e-4;
  for (int iteration = 0; iteration < effort.iterations && !ranges.empty(); ++iteration) {
    const Slope slope = slope_of(ranges, best, effort);
    const std::vector<Eigen::Index> free = free_parameters(ranges, best, slope.gradient);
    if (free.empty()) break;
    Hypothesis next = best;
    next.parameters = stepped(ranges, best.parameters, slope, free, least_damping);
    const VectorXd whole = vector(next.parameters) - vector(best.parameters);
    if (slope.gain(whole) < effort.gain && is_short(ranges, whole)) {
      // The last steps are taken by the derivatives that are there, until one that ends at a bound moves no
      // other.
      constexpr double nothing = 1e-3;  // of what counts
      next.residual += best.jacobian * whole;
      look(next);
      const double gained = next.log_posterior - best.log_posterior;
      if (gained > 0) best = std::move(next);
      if (!(gained > nothing * effort.gain)) break;
      continue;
    }
    double gain = 0;
    for (int attempt = 0; attempt < 5; ++attempt) {
      next = {};
      next.candidate = candidate;
      next.parameters = stepped(ranges, best.parameters, slope, free, damping);
      if (evaluate(next) && next.log_posterior > best.log_posterior) {
        gain = next.log_posterior - best.log_posterior;
        best = std::move(next);
        damping = std::max(least_damping, damping / 10);
        break;
      }
      // A step that went too far is shortened at once: to three quarters, a quarter, a thirtieth, …
      damping = std::max(0.3, 10 * damping);
    }
    if (gain < effort.gain) break;
  }
  mark_bounds(ranges, best);
  weigh(study, best);
  return best;
}

Hypothesis maximised(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                     const InitialGuesses& starts, const Effort& effort) {
  std::vector<std::pair<double, const std::vector<double>*>> order;
  const std::vector<ParameterRange> ranges = study.ranges(candidate);
  for (const std::vector<double>& start : starts.points) {
    if (starts.points.size() == 1) {
      order.emplace_back(0, &start);
      break;
    }
    Hypothesis h;
    h.candidate = candidate;
    h.parameters = start;
    if (predict_into(study, h, false))
      order.emplace_back(-likelihood.look(h.residual).log_likelihood - log_density(ranges, start, effort),
                         &start);
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (order.size() > starts.refined) order.resize(starts.refined);
  Hypothesis best;
  best.candidate = candidate;
  for (const auto& [cost, start] : order) {
    Hypothesis one = maximised(study, likelihood, candidate, *start, effort);
    if (one.converged && (!best.converged || one.log_posterior > best.log_posterior)) best = std::move(one);
  }
  return best;
}

MatrixXd covariance(const Study& study, const Hypothesis& h, double temper) {
  const std::vector<ParameterRange> ranges = study.ranges(h.candidate);
  std::vector<Eigen::Index> inside;
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (!h.at_bound[p]) inside.push_back(static_cast<Eigen::Index>(p));
  const auto count = static_cast<Eigen::Index>(ranges.size());
  MatrixXd result = MatrixXd::Zero(count, count);
  if (inside.empty()) return result;
  VectorXd width(static_cast<Eigen::Index>(inside.size()));
  for (std::size_t f = 0; f < inside.size(); ++f)
    width(static_cast<Eigen::Index>(f)) = ParameterPrior(ranges[static_cast<std::size_t>(inside[f])]).width();
  const MatrixXd scaled =
      MatrixXd::Identity(width.size(), width.size()) +
      temper * width.asDiagonal() * MatrixXd(h.look.information(inside, inside)) * width.asDiagonal();
  const MatrixXd inverse = scaled.ldlt().solve(MatrixXd::Identity(width.size(), width.size()));
  result(inside, inside) = width.asDiagonal() * inverse * width.asDiagonal();
  return result;
}

void look_again(const Study& study, const Likelihood& likelihood, Hypothesis& h) {
  h.look = likelihood.look(h.residual, h.jacobian);
  h.log_posterior = h.look.log_likelihood + log_density(study.ranges(h.candidate), h.parameters, {});
  weigh(study, h);
}

}  // namespace plumbline::diagnose
