#include "diagnose/answers/estimates.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

constexpr double reach_95 = 1.96, tail_95 = 3.0;  // of a Gaussian to either side; of an exponential to one

struct Bounds {
  double low, high;
};

/// Of a parameter in the fitted coordinate. At a bound the posterior falls from there by its slope.
Bounds bounds(const Hypothesis& found, const MatrixXd& spread, const ParameterRange& range, std::size_t p,
              double temper) {
  const auto k = static_cast<Eigen::Index>(p);
  const double value = found.parameters[p];
  double below = reach_95 * std::sqrt(spread(k, k)), above = below;
  if (found.at_bound[p]) {
    const double slope = temper * std::abs(found.look.gradient(k));
    const double reach = slope > 0 ? tail_95 / slope : range.high - range.low;
    const bool at_low = value - range.low < range.high - value;
    below = at_low ? 0 : reach, above = at_low ? reach : 0;
  }
  return {std::max(range.low, value - below), std::min(range.high, value + above)};
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

std::vector<std::vector<Estimate>> estimate(const Study& study, const Hypothesis& found, double temper) {
  const MatrixXd spread = covariance(study, found, temper);
  std::vector<std::vector<Estimate>> result;
  std::size_t p = 0;
  for (const EffectAt& at : found.candidate.effects) {
    result.emplace_back();
    for (const ParameterRange& range : study.ranges(at)) {
      const Bounds reach = bounds(found, spread, range, p, temper);
      const double one = catalogue_value(range.coordinate, reach.low),
                   other = catalogue_value(range.coordinate, reach.high);
      result.back().push_back({std::string(range.name), std::string(range.unit),
                               catalogue_value(range.coordinate, found.parameters[p]), std::min(one, other),
                               std::max(one, other), found.at_bound[p]});
      ++p;
    }
    if (at.effect->element_size > 0) put_in_order(result.back(), at.effect->element_size);
  }
  return result;
}

}  // namespace plumbline::diagnose
