#include "diagnose/decision/genuine.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Whether the readings tell a parameter, were it the only one, to a third of its value: where a stop begins
/// that nothing touched, or an element that never yielded would, is anybody's guess.
bool known_to_itself(const Fit& fit, std::size_t parameter) {
  const auto p = static_cast<Eigen::Index>(parameter);
  return fit.information(p, p) * fit.parameters[parameter] * fit.parameters[parameter] > 9;
}

/// Whether parameters are farther from zero than their standard deviations: one of them, or all together,
/// where each could take the place of another.
bool are_beyond_zero(const Fit& fit, const std::vector<Eigen::Index>& parameters) {
  const Eigen::Map<const Eigen::VectorXd> all(fit.parameters.data(),
                                              static_cast<Eigen::Index>(fit.parameters.size()));
  std::vector<Eigen::Index> free;
  for (const Eigen::Index p : parameters) {
    if (all[p] * all[p] > fit.covariance(p, p)) return true;
    if (fit.covariance(p, p) > 0) free.push_back(p);
  }
  if (free.empty()) return false;
  const Eigen::VectorXd values = all(free);
  const Eigen::MatrixXd spread = fit.covariance(free, free);
  return values.dot(spread.ldlt().solve(values)) > static_cast<double>(free.size());
}

}  // namespace

bool genuine(const Study& study, const Fit& fit) {
  // What machining leaves is one cause: of its three kinds one may be nothing here.
  const bool machined = fit.candidate.has_all_tolerances();
  std::vector<Eigen::Index> machining;
  std::size_t p = 0;
  for (const EffectAt& at : fit.candidate.effects) {
    std::size_t acting = 0;
    bool begins = false, seen = false, away = false, element_is_idle = false;
    std::vector<Eigen::Index> from_zero;
    const std::vector<ParameterRange> ranges = study.ranges(at);
    for (std::size_t own = 0; own < ranges.size(); ++own) {
      const ParameterRange& range = ranges[own];
      const bool natural_zero = range.may_be_nothing();
      const bool at_zero = fit.at_bound[p] && natural_zero && std::abs(fit.parameters[p]) < range.scale;
      // Where the readings hardly tell a parameter from nothing it runs to the end of its range for nothing.
      const bool idle = at_zero || (fit.at_bound[p] && natural_zero && !known_to_itself(fit, p));
      // Of several elements one may be nothing: wherever it would set in.
      const bool first_of_element = at.effect->element_size > 0 && own % at.effect->element_size == 0;
      if (first_of_element) element_is_idle = idle;
      const bool of_idle_element = at.effect->element_size > 0 && !first_of_element && element_is_idle;
      if (fit.at_bound[p] && !idle && !of_idle_element) return false;
      acting += (natural_zero && !idle) || range.coordinate == Coordinate::reciprocal;
      away = away || !natural_zero;
      from_zero.push_back(static_cast<Eigen::Index>(p));
      if (range.is_onset()) {
        begins = true;
        seen = seen || known_to_itself(fit, p);
      }
      ++p;
    }
    const bool of_machining = fit.candidate.has_as_tolerance(at);
    if (of_machining) machining.insert(machining.end(), from_zero.begin(), from_zero.end());
    if (acting < at.effect->at_least || (begins && !seen)) return false;
    if (!of_machining && !away && !are_beyond_zero(fit, from_zero)) return false;
  }
  return !machined || are_beyond_zero(fit, machining);
}

}  // namespace plumbline::diagnose
