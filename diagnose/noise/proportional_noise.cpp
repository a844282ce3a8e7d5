#include "diagnose/noise/proportional_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/beliefs.hpp"

namespace plumbline::diagnose {
namespace {

/// How well a proportion agrees with the readings and with the declared sigma, which is what all of them
/// scatter; where neighbours correlate, third differences show but half of it. Where no value is small, the
/// readings say nothing of it; they overrule it where they do (Cauchy).
double agreement(const Proportion& one) {
  const double off = std::log(one.common / std::clamp(one.common, 0.5, 1.0));
  return one.twice_likelihood / beliefs::third_differences_alike -
         2 * std::log1p(std::pow(off / beliefs::scale_spread, 2));
}

bool enough_to_say(const std::vector<Differences>& series) {
  constexpr std::size_t few = 30;
  return count_of(series) >= few && spread(series) > 0;
}

}  // namespace

double proportional_noise(const std::vector<Differences>& series) {
  if (alternation(series) > beliefs::alternates || !enough_to_say(series)) return 0;
  const std::vector<Differences> plain = without_steps(series);
  const double reach = reach_of(plain);
  if (!enough_to_say(plain) || !(reach > 0)) return 0;
  const std::vector<double> ratios = possible_ratios(reach);
  const double plain_likelihood = in_proportion(plain, ratios.front()).twice_likelihood;
  double gain = 0;
  Proportion best;
  for (std::size_t i = 1; i < ratios.size(); ++i) {
    const Proportion one = in_proportion(plain, ratios[i]);
    gain = std::max(gain, one.twice_likelihood - plain_likelihood);
    if (i == 1 || agreement(one) > agreement(best)) best = one;
  }
  return gain > beliefs::proportional_gain ? best.ratio : 0;
}

bool is_likely(const std::vector<Differences>& series, double ratio) {
  const std::vector<Differences> plain = without_steps(series);
  return !enough_to_say(plain) ||
         in_proportion(plain, ratio).twice_likelihood >= in_proportion(plain, 0).twice_likelihood;
}

}  // namespace plumbline::diagnose
