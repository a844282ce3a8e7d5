#include "diagnose/model/proportional_noise.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// Sum of squares of the coefficients 1, -3, 3, -1.
constexpr double third_difference_squares = 20;

/// Mean of the products of neighbours over the larger of their squares, so that a step in a curve counts no
/// more than noise does.
double alternation(const std::vector<ThirdDifferences>& series) {
  double products = 0, sizes = 0;
  for (const ThirdDifferences& one : series) {
    for (std::size_t i = 1; i < one.sizes.size(); ++i) {
      const double a = one.sizes[i - 1], b = one.sizes[i];
      const double size = std::max(a * a, b * b);
      if (!(size > 0)) continue;
      products += a * b / size;
      sizes += 1;
    }
  }
  return sizes > 0 ? products / sizes : 0;
}

/// Standard deviation by the median of the sizes; zero where most of them are.
double spread(const std::vector<ThirdDifferences>& series) {
  std::vector<double> sizes;
  for (const ThirdDifferences& one : series) sizes.insert(sizes.end(), one.sizes.begin(), one.sizes.end());
  return median_deviation(std::move(sizes));
}

/// The differences without those that an outlier or a step enters: one reading that is off spoils four in a
/// row, the two in the middle most. Of what is large all along the noise is.
std::vector<ThirdDifferences> without_steps(std::vector<ThirdDifferences> series) {
  constexpr double limit = 4.5;
  const double usual = spread(series);
  for (ThirdDifferences& one : series) {
    const double tolerance = limit * std::max(usual, spread({one}));
    const auto off = [&](std::size_t i) {
      return i < one.sizes.size() && std::abs(one.sizes[i]) > tolerance;
    };
    ThirdDifferences kept;
    for (std::size_t i = 0; i < one.sizes.size(); ++i) {
      if (off(i) || off(i + 1) || (i > 0 && off(i - 1))) continue;
      kept.sizes.push_back(one.sizes[i]);
      kept.levels.push_back(one.levels[i]);
    }
    one = std::move(kept);
  }
  return series;
}

/// Sizes whose standard deviations are s sqrt(1 + r^2 level^2).
struct Proportion {
  double ratio = 0;             ///< r
  double common = 0;            ///< s, the one that is most likely
  double twice_likelihood = 0;  ///< with it, logarithmic
};

Proportion in_proportion(const std::vector<ThirdDifferences>& series, double r) {
  double widths = 0, squares_sum = 0, count = 0;
  for (const ThirdDifferences& one : series) {
    for (std::size_t i = 0; i < one.sizes.size(); ++i) {
      const double width = std::hypot(1.0, r * one.levels[i]);
      widths += std::log(width);
      squares_sum += std::pow(one.sizes[i] / width, 2);
      count += 1;
    }
  }
  const double variance = squares_sum / count;
  return {r, std::sqrt(variance), -2 * widths - count * std::log(variance)};
}

/// How well a proportion agrees with the readings and with the declared sigma, which is what all of them
/// scatter; where neighbours correlate, third differences show but half of it. Where no value is small, the
/// readings say nothing of it; they overrule it where they do (Cauchy).
double agreement(const Proportion& one) {
  const double off = std::log(one.common / std::clamp(one.common, 0.5, 1.0));
  return one.twice_likelihood / beliefs::third_differences_alike -
         2 * std::log1p(std::pow(off / beliefs::scale_spread, 2));
}

}  // namespace

ThirdDifferences::ThirdDifferences(const std::vector<double>& values, double sigma) {
  for (std::size_t i = 3; i < values.size(); ++i) {
    const double difference = values[i] - 3 * values[i - 1] + 3 * values[i - 2] - values[i - 3];
    sizes.push_back(difference / (std::sqrt(third_difference_squares) * sigma));
    // Of the parabola through the four, whose noise is independent of the difference's: a reading that is
    // noise alone is large where its noise is.
    const double share = difference / third_difference_squares;
    const double a = values[i - 3] + share, b = values[i - 2] - 3 * share, c = values[i - 1] + 3 * share,
                 d = values[i] - share;
    levels.push_back(std::sqrt((a * a + 9 * b * b + 9 * c * c + d * d) / third_difference_squares));
  }
}

ThirdDifferences ThirdDifferences::where(const std::vector<bool>& even) const {
  ThirdDifferences kept;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!even[i]) continue;
    kept.sizes.push_back(sizes[i]);
    kept.levels.push_back(levels[i]);
  }
  return kept;
}

std::vector<bool> goes_evenly(const Run& run, const std::vector<std::size_t>& readings) {
  constexpr double alike = 0.25;
  std::vector<Eigen::Vector2d> steps;
  for (std::size_t i = 1; i < readings.size(); ++i)
    steps.emplace_back(run.command(run.readings[readings[i]]) - run.command(run.readings[readings[i - 1]]));
  std::vector<bool> even;
  for (std::size_t i = 2; i < steps.size(); ++i) {
    const double apart = std::max((steps[i] - steps[i - 1]).norm(), (steps[i - 1] - steps[i - 2]).norm());
    even.push_back(apart <= alike * steps[i - 1].norm());
  }
  return even;
}

double proportional_noise(const std::vector<ThirdDifferences>& series) {
  constexpr std::size_t few = 30;
  constexpr double step = 1.15;
  constexpr int ratios = 33;  // from 1 to 88
  if (alternation(series) > beliefs::alternates || !(spread(series) > 0)) return 0;
  const std::vector<ThirdDifferences> plain = without_steps(series);
  double reach = 0;
  std::size_t count = 0;
  for (const ThirdDifferences& one : plain) {
    for (const double level : one.levels) reach = std::max(reach, level);
    count += one.sizes.size();
  }
  if (count < few || !(reach > 0)) return 0;
  const double plain_likelihood = in_proportion(plain, 0).twice_likelihood;
  double gain = 0;
  Proportion best;
  for (int i = 0; i < ratios; ++i) {
    const Proportion one = in_proportion(plain, std::pow(step, i) / reach);
    gain = std::max(gain, one.twice_likelihood - plain_likelihood);
    if (i == 0 || agreement(one) > agreement(best)) best = one;
  }
  return gain > beliefs::proportional_gain ? best.ratio : 0;
}

}  // namespace plumbline::diagnose
