#include "diagnose/noise/differences.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// Sum of squares of the coefficients 1, -3, 3, -1.
constexpr double third_difference_squares = 20;

}  // namespace

Differences::Differences(const std::vector<double>& values, double sigma) {
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

Differences::Differences(const std::vector<double>& values, double sigma,
                         const std::vector<Between>& between) {
  for (const Between& one : between) {
    const double before = (1 - one.share) * values[one.before], after = one.share * values[one.after];
    sizes.push_back(one.off(values.data()) / sigma);
    levels.push_back(
        std::sqrt((std::pow(values[one.value], 2) + before * before + after * after) / one.squares()));
  }
}

Differences Differences::where(const std::vector<bool>& even) const {
  Differences kept;
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

double alternation(const std::vector<Differences>& series) {
  double products = 0, sizes = 0;
  for (const Differences& one : series) {
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

std::size_t count_of(const std::vector<Differences>& series) {
  std::size_t count = 0;
  for (const Differences& one : series) count += one.sizes.size();
  return count;
}

double reach_of(const std::vector<Differences>& series) {
  double reach = 0;
  for (const Differences& one : series)
    for (const double level : one.levels) reach = std::max(reach, level);
  return reach;
}

double spread(const std::vector<Differences>& series, double ratio) {
  std::vector<double> sizes;
  for (const Differences& one : series)
    for (std::size_t i = 0; i < one.sizes.size(); ++i)
      sizes.push_back(one.sizes[i] / std::hypot(1.0, ratio * one.levels[i]));
  return median_deviation(std::move(sizes));
}

std::vector<Differences> without_steps(std::vector<Differences> series) {
  constexpr double limit = 4.5;
  const double usual = spread(series);
  for (Differences& one : series) {
    const double tolerance = limit * std::max(usual, spread({one}));
    const auto off = [&](std::size_t i) {
      return i < one.sizes.size() && std::abs(one.sizes[i]) > tolerance;
    };
    Differences kept;
    for (std::size_t i = 0; i < one.sizes.size(); ++i) {
      if (off(i) || off(i + 1) || (i > 0 && off(i - 1))) continue;
      kept.sizes.push_back(one.sizes[i]);
      kept.levels.push_back(one.levels[i]);
    }
    one = std::move(kept);
  }
  return series;
}

Proportion in_proportion(const std::vector<Differences>& series, double r) {
  double widths = 0, squares_sum = 0, count = 0;
  for (const Differences& one : series) {
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

std::vector<double> possible_ratios(double reach) {
  constexpr double step = 1.15;
  constexpr int count = 33;  // from 1 to 88, over the reach
  std::vector<double> ratios{0};
  for (int i = 0; reach > 0 && i < count; ++i) ratios.push_back(std::pow(step, i) / reach);
  return ratios;
}

}  // namespace plumbline::diagnose
