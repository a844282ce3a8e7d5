#include "diagnose/noise/between.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// How far along the direction in which its commands differ most each value was read; not a number where the
/// command is missing.
std::vector<double> places(const Run& run, const std::vector<std::size_t>& readings) {
  Eigen::Vector2d mean(0, 0);
  double count = 0;
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const std::size_t i : readings) {
    const Eigen::Vector2d command = run.command(run.readings[i]);
    if (!command.allFinite()) continue;
    count += 1;
    const Eigen::Vector2d off = command - mean;
    mean += off / count;
    squares += off * (command - mean).transpose();
  }
  const Eigen::Vector2d way = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(squares).eigenvectors().col(1);
  std::vector<double> along;
  for (const std::size_t i : readings) along.push_back(way.dot(run.command(run.readings[i]) - mean));
  return along;
}

/// Of values in the order of their places, those beside which others were read at another time.
std::vector<Between> beside_others(const std::vector<std::size_t>& order, const std::vector<double>& place) {
  const auto another_time = [](std::size_t a, std::size_t b) { return std::max(a, b) - std::min(a, b) > 2; };
  std::vector<Between> all;
  for (std::size_t k = 1; k + 1 < order.size(); ++k) {
    const std::size_t before = order[k - 1], value = order[k], after = order[k + 1];
    if (!another_time(before, value) || !another_time(after, value)) continue;
    const double way = place[after] - place[before];
    all.push_back({value, before, after, way > 0 ? (place[value] - place[before]) / way : 0.5});
  }
  return all;
}

}  // namespace

double Between::squares() const {
  return 1 + share * share + (1 - share) * (1 - share);
}

double Between::off(const double* values) const {
  const double line = (1 - share) * values[before] + share * values[after];
  return (values[value] - line) / std::sqrt(squares());
}

std::vector<Between> between(const Run& run, const std::vector<std::size_t>& readings) {
  const std::vector<double> place = places(run, readings);
  std::vector<std::size_t> all, there, back;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!std::isfinite(place[i])) continue;
    const bool returns = !all.empty() && place[i] < place[all.back()];
    (returns ? back : there).push_back(i);
    all.push_back(i);
  }
  const auto beside = [&](std::vector<std::size_t>& values) {
    std::stable_sort(values.begin(), values.end(),
                     [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    return beside_others(values, place);
  };
  std::vector<Between> same_way = beside(there);
  for (const Between& one : beside(back)) same_way.push_back(one);
  return 3 * same_way.size() > all.size() ? same_way : beside(all);
}

}  // namespace plumbline::diagnose
