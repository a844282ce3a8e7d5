#include "diagnose/noise/uneven_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "diagnose/beliefs.hpp"

namespace plumbline::diagnose {
namespace {

using Group = std::vector<Differences>;

Group all_of(const std::vector<SeenNoise>& series, Differences SeenNoise::*kind) {
  Group all;
  for (const SeenNoise& one : series) all.push_back(one.*kind);
  return all;
}

/// So many differences say little of how large noise is.
constexpr std::size_t few = 20;

/// Above which ratio of two deviations, of so many third differences each, no chance is left. Of such
/// differences two in five are new, so that the logarithm of a deviation scatters by 1.1 over the root of
/// their number, and of noise with heavier tails by somewhat more: three times 1.1 are chance in one of 700.
double beyond_chance(std::size_t one, std::size_t other) {
  constexpr double noticeable = 1.5, chance = 4;
  return std::max(noticeable, std::exp(chance * std::sqrt(1 / static_cast<double>(one) +
                                                          1 / static_cast<double>(other))));
}

/// Whether its third differences are those of noise, and enough to say how large it is.
bool shows_noise(const Group& group) {
  if (count_of(group) < few || !(spread(group) > 0)) return false;
  // The mean of so many products, each of 0.55, scatters so.
  const double by_chance = 0.55 / std::sqrt(static_cast<double>(count_of(group)));
  return alternation(group) <= beliefs::alternates + by_chance;
}

/// How much each group scatters if readings scatter by a share of themselves besides; nothing where one
/// scatter for all explains them nearly as well, with a share that suits it.
std::optional<std::vector<double>> deviations(const std::vector<Group>& groups) {
  std::vector<Group> plain;
  Group all;
  for (const Group& group : groups) {
    plain.push_back(without_steps(group));
    if (count_of(plain.back()) == 0) return std::nullopt;
    all.insert(all.end(), plain.back().begin(), plain.back().end());
  }
  double together = 0, apart = 0;
  std::vector<double> likeliest;
  for (const double ratio : possible_ratios(reach_of(all))) {
    const double one = in_proportion(all, ratio).twice_likelihood;
    double sum = 0;
    std::vector<double> deviation;
    for (const Group& group : plain) {
      const Proportion own = in_proportion(group, ratio);
      sum += own.twice_likelihood;
      deviation.push_back(std::min(own.common, spread(group, ratio)));  // outliers move the median less
    }
    if (likeliest.empty() || one > together) together = one;
    if (likeliest.empty() || sum > apart) apart = sum, likeliest = std::move(deviation);
  }
  if (apart - together > beliefs::proportional_gain) return likeliest;
  return std::nullopt;
}

/// By how much the values of a group differ at the same place of the path, which no curve adds to, outliers
/// included; infinite where few do.
double deviation_in_place(const std::vector<SeenNoise>& group) {
  const Group in_place = all_of(group, &SeenNoise::in_place);
  return count_of(in_place) < few ? std::numeric_limits<double>::infinity()
                                  : in_proportion(in_place, 0).common;
}

double lower_median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

}  // namespace

std::vector<double> uneven_noise(const std::vector<std::vector<SeenNoise>>& groups) {
  std::vector<double> times(groups.size(), 1.0);
  std::vector<Group> noisy;
  std::vector<std::size_t> places;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Group in_time = all_of(groups[g], &SeenNoise::in_time);
    if (!shows_noise(in_time)) continue;
    noisy.push_back(std::move(in_time));
    places.push_back(g);
  }
  if (noisy.size() < 2) return times;
  std::optional<std::vector<double>> own = deviations(noisy);
  if (!own) return times;
  for (std::size_t g = 0; g < noisy.size(); ++g)
    (*own)[g] = std::min((*own)[g], deviation_in_place(groups[places[g]]));
  const double usual = lower_median(*own);
  std::size_t all = 0;
  for (const Group& group : noisy) all += count_of(group);
  for (std::size_t g = 0; g < noisy.size(); ++g) {
    const std::size_t values = count_of(noisy[g]);
    if ((*own)[g] > beyond_chance(values, all - values) * usual) times[places[g]] = (*own)[g] / usual;
  }
  return times;
}

}  // namespace plumbline::diagnose
