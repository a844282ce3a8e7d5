#include "diagnose/bench/condense.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::size_t wanted_readings = 500, least_readings = 40, short_enough = 1000;

/// Draws the readings of one run together, group by group.
class Condenser {
 public:
  Condenser(const Run& run, std::size_t size) : run_(run), size_(size), result_(run) {
    result_.readings.clear();
    result_.groups = {size, {}};
  }

  Run result() {
    const std::vector<bool> turns = run_.turning_points();
    const std::size_t end = run_.readings.size();
    for (std::size_t from = 0; from < end;) {
      std::size_t to = from + 1;
      const bool alone = from == 0 || to == end || turns[from];
      while (!alone && to - from < size_ && to + 1 < end && !turns[to]) ++to;
      add(from, to, alone);
      from = to;
    }
    result_.groups.first.push_back(end);
    return std::move(result_);
  }

 private:
  template <class Value>
  [[nodiscard]] double mean(std::size_t from, std::size_t to, Value value) const {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += value(run_.readings[i]);
    return sum / static_cast<double>(to - from);
  }

  [[nodiscard]] double middle(std::size_t from, std::size_t to, const Channel& channel) const {
    std::vector<double> values;
    for (std::size_t i = from; i < to; ++i) values.push_back(channel.of(run_.readings[i]));
    std::erase_if(values, [](double v) { return std::isnan(v); });
    return median(std::move(values));
  }

  /// Of a reading that stands alone the measured values would scatter more than those of a group.
  void add(std::size_t from, std::size_t to, bool alone) {
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    Reading drawn = run_.readings[from];
    drawn.t = mean(from, to, [](const Reading& reading) { return reading.t; });
    for (const Channel& channel : run_.imposed())
      channel.in(drawn) = mean(from, to, [&](const Reading& reading) { return channel.of(reading); });
    for (const Channel& channel : run_.measured())
      channel.in(drawn) = alone ? unseen : middle(from, to, channel);
    result_.readings.push_back(std::move(drawn));
    result_.groups.first.push_back(from);
  }

  const Run& run_;
  std::size_t size_;
  Run result_;
};

}  // namespace

Experiment condensed(Experiment experiment) {
  std::size_t total = 0;
  for (const Run& run : experiment.runs) total += run.readings.size();
  if (total <= short_enough) return experiment;
  for (Run& run : experiment.runs) {
    const std::size_t count = run.readings.size(),
                      groups = std::max(least_readings, count * wanted_readings / total);
    const std::size_t size = (count + groups - 1) / groups;
    if (size > 2) run = Condenser(run, size).result();
  }
  return experiment;
}

}  // namespace plumbline::diagnose
