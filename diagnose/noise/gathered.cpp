#include "diagnose/noise/gathered.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <map>

namespace plumbline::diagnose {
namespace {

/// Values, and how many of them are marked.
struct Marked {
  std::size_t marked = 0, values = 0;
  bool gather = false;  ///< of one reading: they do with its neighbours'

  void operator+=(const Marked& other) { marked += other.marked, values += other.values; }
};

/// By run, the readings that have any value, in the order in which they were taken.
using Runs = std::map<std::size_t, std::map<std::size_t, Marked>>;

Runs by_reading(const Measurements& measurements, const std::vector<bool>& marked) {
  Runs runs;
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      runs[series.run][series.readings[i]] += {marked[series.first + i] ? 1U : 0U, 1};
  return runs;
}

/// Chance that so many are marked here where it befalls values as seldom as elsewhere.
double chance(const Marked& here, const Marked& all) {
  const auto elsewhere = static_cast<double>(all.values - here.values);
  const double share = (static_cast<double>(all.marked - here.marked) + 1) / (elsewhere + 1);
  if (share >= 1) return 1;
  const boost::math::binomial_distribution<> by_chance(static_cast<double>(here.values), share);
  return cdf(complement(by_chance, static_cast<double>(here.marked) - 1));
}

/// Finds in every five neighbours of a run whether what is marked gathers. \param places  there are of five
void look_along(std::map<std::size_t, Marked>& run, const Marked& all, double places) {
  constexpr double level = 1e-3;
  constexpr std::size_t width = 5;
  constexpr std::ptrdiff_t least = 3;
  if (run.size() < width) return;
  auto end = std::next(run.begin(), width - 1);
  for (auto begin = run.begin(); end != run.end(); ++begin) {
    ++end;
    Marked here;
    for (auto one = begin; one != end; ++one) here += one->second;
    const auto readings =
        std::count_if(begin, end, [](const auto& reading) { return reading.second.marked > 0; });
    if (readings < least || places * chance(here, all) > level) continue;
    for (auto one = begin; one != end; ++one) one->second.gather = true;
  }
}

}  // namespace

std::vector<bool> gathered(const Measurements& measurements, const std::vector<bool>& marked) {
  Runs runs = by_reading(measurements, marked);
  Marked all;
  double places = 0;
  for (const auto& [number, run] : runs)
    for (const auto& [reading, one] : run) all += one, places += 1;
  for (auto& [number, run] : runs) look_along(run, all, places);
  std::vector<bool> result(marked.size(), false);
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      result[series.first + i] = marked[series.first + i] && runs[series.run][series.readings[i]].gather;
  return result;
}

}  // namespace plumbline::diagnose
