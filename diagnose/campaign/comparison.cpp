#include "diagnose/campaign/comparison.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <set>

namespace plumbline::campaign {
namespace {

using Names = std::vector<std::string>;

double variance(const Estimate& one) {
  constexpr double two_sided = 1.959963984540054;  // 97.5 % quantile of the normal distribution
  const double deviation = (one.high - one.low) / (2 * two_sided);
  return deviation * deviation;
}

/// 97.5 % quantile of Student's distribution.
double quantile(std::size_t freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(freedom)), 0.975);
}

/// Weighted sums over places.
struct Sums {
  double w = 0, wx = 0, wxx = 0, wy = 0, wxy = 0;
  Sums(const std::vector<double>& weight, const std::vector<double>& x, const std::vector<Estimate>& y) {
    for (std::size_t i = 0; i < weight.size(); ++i) {
      w += weight[i], wx += weight[i] * x[i], wxx += weight[i] * x[i] * x[i];
      wy += weight[i] * y[i].value, wxy += weight[i] * x[i] * y[i].value;
    }
  }
  [[nodiscard]] double determinant() const { return w * wxx - wx * wx; }
  [[nodiscard]] double slope() const { return (w * wxy - wx * wy) / determinant(); }
  [[nodiscard]] double start() const { return (wxx * wy - wx * wxy) / determinant(); }
};

std::vector<double> weights(const std::vector<Estimate>& estimates, double between) {
  std::vector<double> all;
  for (const Estimate& one : estimates) all.push_back(1 / (variance(one) + between));
  return all;
}

double squares(const std::vector<double>& weight, const std::vector<Estimate>& y,
               const std::vector<double>& x, double start, double slope) {
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double left = y[i].value - start - slope * x[i];
    sum += weight[i] * left * left;
  }
  return sum;
}

/// The variance between sessions of Paule and Mandel (1982), at which the weighted squares of a fit equal
/// their degrees of freedom.
/// \param left  those squares as a function of the variance, falling
template <class Left>
double between(const std::vector<Estimate>& estimates, std::size_t freedom, const Left& left) {
  const double wanted = static_cast<double>(freedom);
  if (left(0) <= wanted) return 0;
  double low = 0, high = 0;
  for (const Estimate& one : estimates) high = std::max(high, variance(one));
  while (left(high) > wanted) low = high, high *= 2;
  constexpr int halvings = 100;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (left(middle) > wanted ? low : high) = middle;
  }
  return high;
}

Names sorted(Names names) {
  std::sort(names.begin(), names.end());
  return names;
}

Names named(const StatedReport& report) {
  if (report.verdict == "none" || report.verdict == "unknown") return {report.verdict};
  return sorted(report.effects);
}

std::vector<Cause> causes_of(const std::vector<Outcome>& outcomes) {
  std::map<Names, Cause> all;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i].failure.empty()) continue;
    const StatedReport& report = outcomes[i].report;
    const bool sure = report.verdict != "ambiguous";
    (sure ? all[named(report)].named_by : all[named(report)].allowed_by).push_back(i);
    for (const Names& other : report.equivalent) all[sorted(other)].allowed_by.push_back(i);
  }
  std::vector<Cause> causes;
  for (auto& [names, cause] : all) {
    cause.effects = names;
    causes.push_back(cause);
  }
  std::stable_sort(causes.begin(), causes.end(), [](const Cause& a, const Cause& b) {
    const std::size_t all_a = a.named_by.size() + a.allowed_by.size(),
                      all_b = b.named_by.size() + b.allowed_by.size();
    return std::pair(all_a, a.named_by.size()) > std::pair(all_b, b.named_by.size());
  });
  return causes;
}

/// The estimates of identified causes; bounds without a width give no precision.
std::map<std::string, Parameter> parameters_of(const std::vector<Outcome>& outcomes) {
  std::map<std::string, Parameter> all;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i].failure.empty() || outcomes[i].report.verdict != "identified") continue;
    for (const auto& [key, bounds] : outcomes[i].report.bounds) {
      if (!(bounds.high > bounds.low)) continue;
      const std::size_t slash = key.find('/');
      Parameter& one = all[key];
      one.effect = key.substr(0, slash), one.name = key.substr(slash + 1), one.unit = bounds.unit;
      one.outcomes.push_back(i);
      one.estimates.push_back({bounds.value, bounds.low, bounds.high});
    }
  }
  return all;
}

}  // namespace

Pooled pooled(const std::vector<Estimate>& estimates) {
  const std::vector<double> nowhere(estimates.size(), 0.0);
  const auto mean = [&](const std::vector<double>& weight) {
    const Sums sums(weight, nowhere, estimates);
    return sums.wy / sums.w;
  };
  const auto left = [&](double variance_between) {
    const std::vector<double> weight = weights(estimates, variance_between);
    return squares(weight, estimates, nowhere, mean(weight), 0);
  };
  const std::size_t freedom = estimates.size() - 1;
  const double variance_between = between(estimates, freedom, left);
  const std::vector<double> weight = weights(estimates, variance_between);
  const double value = mean(weight), count = static_cast<double>(freedom);
  // Hartung and Knapp: the remaining squares scale the variance, never below that of the bounds alone.
  const double scale = std::max(1.0, left(variance_between) / count);
  const double half = quantile(freedom) * std::sqrt(scale / Sums(weight, nowhere, estimates).w);
  const double p_no_spread = boost::math::cdf(complement(boost::math::chi_squared(count), left(0)));
  return {{value, value - half, value + half}, std::sqrt(variance_between), p_no_spread};
}

Estimate drift(const std::vector<Estimate>& estimates, const std::vector<double>& places) {
  const auto left = [&](double variance_between) {
    const std::vector<double> weight = weights(estimates, variance_between);
    const Sums line(weight, places, estimates);
    return squares(weight, estimates, places, line.start(), line.slope());
  };
  const std::size_t freedom = estimates.size() - 2;
  const double variance_between = between(estimates, freedom, left);
  const Sums line(weights(estimates, variance_between), places, estimates);
  const double scale = std::max(1.0, left(variance_between) / static_cast<double>(freedom));
  const double half = quantile(freedom) * std::sqrt(scale * line.w / line.determinant());
  return {line.slope(), line.slope() - half, line.slope() + half};
}

Comparison compare(const std::vector<Outcome>& outcomes) {
  Comparison result;
  result.causes = causes_of(outcomes);
  const auto failed = [](const Outcome& one) { return !one.failure.empty(); };
  result.failed = static_cast<std::size_t>(std::count_if(outcomes.begin(), outcomes.end(), failed));
  result.by_date = std::all_of(outcomes.begin(), outcomes.end(),
                               [&](const Outcome& one) { return failed(one) || one.date.has_value(); });
  for (auto& [key, parameter] : parameters_of(outcomes)) {
    if (parameter.estimates.size() < 2) continue;
    const Pooled together = pooled(parameter.estimates);
    parameter.mean = together.mean, parameter.spread = together.spread,
    parameter.p_no_spread = together.p_no_spread;
    std::vector<double> places;
    for (const std::size_t i : parameter.outcomes)
      places.push_back(
          result.by_date
              ? static_cast<double>(outcomes[i].date->time_since_epoch().count() -
                                    outcomes[parameter.outcomes.front()].date->time_since_epoch().count())
              : static_cast<double>(i));
    if (places.size() > 2 && std::set<double>(places.begin(), places.end()).size() > 1)
      parameter.drift = drift(parameter.estimates, places);
    result.parameters.push_back(parameter);
  }
  return result;
}

}  // namespace plumbline::campaign
