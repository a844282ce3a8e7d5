#include "diagnose/draft/column_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace plumbline::diagnose {
namespace {

using Values = std::vector<double>;

double median(Values values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double range_of(const Values& all) {
  const Values values = finite(all);
  if (values.empty()) return 0;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// The last decimal that the values are written to: a reading is no better than that.
double written_step(const Values& values) {
  constexpr int most = 6;
  for (int digits = 0; digits < most; ++digits) {
    const double scale = std::pow(10, digits);
    const auto whole = [&](double value) {
      return std::abs(value * scale - std::round(value * scale)) < 1e-6;
    };
    if (std::all_of(values.begin(), values.end(), whole)) return 1 / scale;
  }
  return std::pow(10, -most);
}

}  // namespace

std::optional<std::vector<double>> numbers_in(const std::string& text) {
  std::string plain = text;
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == ',' || c == ';' || c == '[' || c == ']'; }, ' ');
  std::istringstream in(plain);
  Values all;
  for (double value = 0; in >> value;) all.push_back(value);
  return in.eof() ? std::optional(all) : std::nullopt;
}

double farthest(const Values& xs, const Values& ys, const std::array<double, 2>& base, double unit) {
  double far = 0;
  for (std::size_t i = 0; i < std::max(xs.size(), ys.size()); ++i) {
    const double a = i < xs.size() && std::isfinite(xs[i]) ? xs[i] * unit - base[0] : 0;
    const double b = i < ys.size() && std::isfinite(ys[i]) ? ys[i] * unit - base[1] : 0;
    far = std::max(far, std::hypot(a, b));
  }
  return far;
}

std::vector<double> finite(Values values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  return values;
}

double roughness(const Values& all) {
  const Values values = finite(all);
  Values bends;
  for (std::size_t i = 1; i + 1 < values.size(); ++i)
    bends.push_back(std::abs(values[i - 1] - 2 * values[i] + values[i + 1]));
  const double range = range_of(values);
  return range > 0 ? median(bends) / range : 0;
}

double scatter_of(const std::vector<double>& all) {
  const Values values = finite(all);
  Values bends, steps;
  // Third differences, which neither a slope nor a bend of the curve has.
  for (std::size_t i = 3; i < values.size(); ++i)
    bends.push_back(std::abs(values[i] - 3 * values[i - 1] + 3 * values[i - 2] - values[i - 3]));
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] != values[i - 1]) steps.push_back(std::abs(values[i] - values[i - 1]));
  // The median size of a normal error is 0.6745 of its deviation; a third difference has 20 variances.
  const double scatter = median(bends) / 0.6745 / std::sqrt(20);
  const double step = steps.empty() ? written_step(values) : *std::min_element(steps.begin(), steps.end());
  return std::max(scatter, step / std::sqrt(12));
}

}  // namespace plumbline::diagnose
