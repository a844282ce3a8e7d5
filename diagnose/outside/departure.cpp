#include "diagnose/outside/departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace plumbline::diagnose {
namespace {

std::vector<std::size_t> readings_by_run(const Measurements& measurements) {
  std::vector<std::size_t> readings;
  for (const ReadingPlace& place : measurements.places()) {
    readings.resize(std::max(readings.size(), place.run + 1), 0);
    readings[place.run] = std::max(readings[place.run], place.reading + 1);
  }
  return readings;
}

/// [run][channel][reading]: log density of a value in an event over that outside of it; zero where none is.
std::vector<std::vector<std::vector<double>>> gains(const Measurements& measurements,
                                                    const VectorXd& standardised, const OutlierModel& model) {
  const std::vector<std::size_t> readings = readings_by_run(measurements);
  std::vector<std::vector<std::vector<double>>> all(readings.size());
  for (const Series& series : measurements.series()) {
    std::vector<double>& own = all[series.run].emplace_back(readings[series.run], 0.0);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double z = standardised(static_cast<Eigen::Index>(series.first + i));
      own[series.readings[i]] = model.log_outlier(z) - std::log(model.share) - model.log_density(z);
    }
  }
  return all;
}

/// log(product(1 + exp(sum)) - 1), over the number of its terms: some of the channels, whichever.
double log_of_some(const std::vector<double>& sums) {
  double all = 0;
  for (const double one : sums) all += log_sum({one, 0.0});
  const double some = all > 1e-6 ? all + std::log(-std::expm1(-all)) : log_sum(sums);
  return some - std::log(std::pow(2.0, static_cast<double>(sums.size())) - 1);
}

std::vector<std::size_t> counted(std::size_t readings) {
  std::vector<std::size_t> all(readings);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

double log_departure(const Measurements& measurements, const VectorXd& left, const NoiseEstimate& noise,
                     const std::vector<EventOrder>& orders) {
  const auto gain =
      gains(measurements, left.cwiseQuotient(noise.sigma(measurements)), noise.shape.outliers());
  std::vector<double> places;
  for (const EventOrder& order : orders) {
    const std::vector<std::vector<double>>& channels = gain[order.run];
    const std::size_t readings = order.readings.size();
    for (std::size_t from = 0; from < (order.at_first ? 1 : readings); ++from) {
      std::vector<double> sums(channels.size(), 0.0);
      for (std::size_t to = from; to < std::min(readings, from + order.most); ++to) {
        for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += channels[c][order.readings[to]];
        places.push_back(log_of_some(sums));
      }
    }
  }
  if (places.empty()) return -std::numeric_limits<double>::infinity();
  return log_sum(places) - std::log(static_cast<double>(places.size()));
}

std::vector<EventOrder> in_order_of_reading(const Measurements& measurements) {
  constexpr std::size_t longest = 8;  // readings, and a quarter of a run
  std::vector<EventOrder> orders;
  const std::vector<std::size_t> readings = readings_by_run(measurements);
  for (std::size_t run = 0; run < readings.size(); ++run)
    if (readings[run] > 0)
      orders.push_back({run, counted(readings[run]), std::clamp<std::size_t>(readings[run] / 4, 1, longest)});
  return orders;
}

std::vector<EventOrder> from_the_ends(const Measurements& measurements, const CommandStates& states) {
  constexpr double varies = 1e-9;
  std::vector<EventOrder> orders;
  const std::vector<std::size_t> readings = readings_by_run(measurements);
  for (std::size_t run = 0; run < readings.size(); ++run) {
    if (readings[run] == 0) continue;
    const std::vector<CommandState>& state = states.of[run];
    for (std::size_t k = 0; k < state.front().command.size(); ++k)
      for (const Eigen::Index axis : {0, 1, 2}) {
        const auto far = [&](std::size_t a, std::size_t b) {
          return state[a].command[k](axis) > state[b].command[k](axis) + varies;
        };
        EventOrder order{run, counted(readings[run]), std::max<std::size_t>(1, readings[run] / 2), true};
        std::stable_sort(order.readings.begin(), order.readings.end(), far);
        if (!far(order.readings.front(), order.readings.back())) continue;
        orders.push_back(order);
        std::reverse(order.readings.begin(), order.readings.end());
        orders.push_back(std::move(order));
      }
  }
  return orders;
}

OutsideFit EventDeparture::fit(const Leftover& left) const {
  const Measurements& measurements = left.likelihood.measurements();
  const Decomposition parts = left.likelihood.decompose(left.residual);
  return {left.look.log_by_amplitude.front() +
          log_departure(measurements, left.residual - parts.delta - parts.periodic, parts.noise,
                        orders_(measurements, left.likelihood.states()))};
}

}  // namespace plumbline::diagnose
