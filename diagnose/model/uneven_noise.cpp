#include "diagnose/model/uneven_noise.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "diagnose/beliefs.hpp"

namespace plumbline::diagnose {
namespace {

using Group = std::vector<Differences>;

/// Above which ratio of two deviations, one of `values` third differences, no chance is left. A median of
/// sizes is 0.37 as efficient as their squares, and every second of third differences is new, so that the
/// logarithm of a deviation scatters by the root of 1 / (2 * 0.37 * values / 2); three of these are chance
/// one time in 700.
double beyond_chance(std::size_t values) {
  constexpr double noticeable = 1.5, efficiency = 0.37;
  return std::max(noticeable, std::exp(3 / std::sqrt(efficiency * static_cast<double>(values))));
}

std::size_t values_of(const Group& group) {
  std::size_t count = 0;
  for (const Differences& one : group) count += one.sizes.size();
  return count;
}

/// Whether its third differences are those of noise, and enough to say how large it is.
bool shows_noise(const Group& group) {
  constexpr std::size_t few = 20;
  return values_of(group) >= few && spread(group) > 0 && alternation(group) <= beliefs::alternates;
}

/// The share of themselves, over what all scatter, by which readings scatter if each group has a scatter of
/// its own besides; nothing where one for all explains them nearly as well, with a share that suits it.
std::optional<double> proportion_within(const std::vector<Group>& groups) {
  std::vector<Group> plain;
  Group all;
  double reach = 0;
  for (const Group& group : groups) {
    plain.push_back(without_steps(group));
    all.insert(all.end(), plain.back().begin(), plain.back().end());
    for (const Differences& one : plain.back())
      for (const double level : one.levels) reach = std::max(reach, level);
  }
  double together = 0, apart = 0, ratio = 0;
  const std::vector<double> ratios = possible_ratios(reach);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double one = in_proportion(all, ratios[i]).twice_likelihood;
    double sum = 0;
    for (const Group& group : plain)
      if (values_of(group) > 0) sum += in_proportion(group, ratios[i]).twice_likelihood;
    if (i == 0 || one > together) together = one;
    if (i == 0 || sum > apart) apart = sum, ratio = ratios[i];
  }
  if (apart - together > beliefs::proportional_gain) return ratio;
  return std::nullopt;
}

double deviation(Group group, double ratio) {
  for (Differences& one : group)
    for (std::size_t i = 0; i < one.sizes.size(); ++i) one.sizes[i] /= std::hypot(1.0, ratio * one.levels[i]);
  return spread(group);
}

double lower_median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

}  // namespace

std::vector<double> uneven_noise(const std::vector<Group>& groups) {
  std::vector<double> times(groups.size(), 1.0);
  std::vector<Group> noisy;
  std::copy_if(groups.begin(), groups.end(), std::back_inserter(noisy), shows_noise);
  if (noisy.size() < 2) return times;
  const std::optional<double> ratio = proportion_within(noisy);
  if (!ratio) return times;
  std::vector<double> deviations;
  for (const Group& group : noisy) deviations.push_back(deviation(group, *ratio));
  const double usual = lower_median(deviations);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!shows_noise(groups[g])) continue;
    const double own = deviation(groups[g], *ratio);
    if (own > beyond_chance(values_of(groups[g])) * usual) times[g] = own / usual;
  }
  return times;
}

}  // namespace plumbline::diagnose
