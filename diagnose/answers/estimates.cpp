#include "diagnose/answers/estimates.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// The rise of twice the log-likelihood at the end of a 95 % interval of one parameter.
constexpr double rise_95 = 3.841;

/// 95 % bounds of one parameter: of what a tolerance holds, nearly a Gaussian, by its spread; of others by
/// profile likelihood.
Profile bounds(const Study& study, const Fit& fit, std::size_t parameter, const FitSettings& settings) {
  const ParameterRange range = study.ranges(fit.candidate)[parameter];
  const auto p = static_cast<Eigen::Index>(parameter);
  if (!(range.tolerance > 0) || fit.at_bound[parameter])
    return profile(study, fit, parameter, settings, rise_95);
  const double reach = std::sqrt(rise_95 * fit.covariance(p, p)), value = fit.parameters[parameter];
  return {std::max(range.low, value - reach), std::min(range.high, value + reach)};
}

}  // namespace

void put_in_order(std::vector<Estimate>& estimates, std::size_t element) {
  std::vector<std::vector<Estimate>> elements;
  for (std::size_t p = 0; p < estimates.size(); p += element)
    elements.emplace_back(estimates.begin() + static_cast<std::ptrdiff_t>(p),
                          estimates.begin() + static_cast<std::ptrdiff_t>(p + element));
  std::stable_sort(elements.begin(), elements.end(),
                   [](const std::vector<Estimate>& a, const std::vector<Estimate>& b) {
                     return a.back().value < b.back().value;
                   });
  for (std::size_t p = 0; p < estimates.size(); ++p) {
    Estimate& moved = elements[p / element][p % element];
    moved.name = estimates[p].name;
    estimates[p] = moved;
  }
}

std::vector<std::vector<Estimate>> estimate(const Study& study, const Fit& found, const NoiseModel& noise) {
  FitSettings settings;
  settings.noise = noise;
  const Fit again = fit_from(study, found.candidate, settings, found.parameters);
  const Fit& fit = again.converged ? again : found;
  std::vector<std::vector<Estimate>> result;
  std::size_t p = 0;
  for (const EffectAt& at : fit.candidate.effects) {
    result.emplace_back();
    for (const ParameterRange& range : study.ranges(at)) {
      const Profile reach = bounds(study, fit, p, settings);
      result.back().push_back({std::string(range.name), std::string(range.unit),
                               catalogue_value(range.coordinate, fit.parameters[p]), reach.low, reach.high,
                               fit.at_bound[p]});
      ++p;
    }
    if (at.effect->element_size > 0) put_in_order(result.back(), at.effect->element_size);
  }
  return result;
}

}  // namespace plumbline::diagnose
