#include "diagnose/decision/local_departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {

namespace {

/// [run][channel][reading]: log density of a value in the departure over that outside of it; zero where none
/// is.
std::vector<std::vector<std::vector<double>>> gains(const Measurements& measurements,
                                                    const VectorXd& standardised) {
  std::vector<std::size_t> readings;
  for (const ReadingPlace& place : measurements.places()) {
    readings.resize(std::max(readings.size(), place.run + 1), 0);
    readings[place.run] = std::max(readings[place.run], place.reading + 1);
  }
  std::vector<std::vector<std::vector<double>>> all(readings.size());
  for (const Series& series : measurements.series()) {
    std::vector<double>& own = all[series.run].emplace_back(readings[series.run], 0.0);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double z = standardised(static_cast<Eigen::Index>(series.first + i)), outlier = log_outlier(z);
      own[series.readings[i]] =
          outlier - std::log(priors::outlier_share) - log_sum(Eigen::Vector2d(outlier, log_inlier(z)));
    }
  }
  return all;
}

}  // namespace

double log_local_departure(const Measurements& measurements, const VectorXd& left,
                           const NoiseEstimate& noise) {
  constexpr std::size_t longest = 8;  // readings, and a quarter of a run
  std::vector<double> places;
  for (const std::vector<std::vector<double>>& run :
       gains(measurements, left.cwiseQuotient(noise.sigma(measurements)))) {
    const std::size_t readings = run.empty() ? 0 : run.front().size();
    const std::size_t most = std::clamp<std::size_t>(readings / 4, 1, longest);
    for (std::size_t from = 0; from < readings; ++from) {
      std::vector<double> sum(run.size(), 0.0);
      for (std::size_t to = from; to < std::min(readings, from + most); ++to) {
        double all = 0;
        for (std::size_t c = 0; c < run.size(); ++c) {
          sum[c] += run[c][to];
          all += log_sum(Eigen::Vector2d(sum[c], 0)) - std::log(2.0);
        }
        places.push_back(all);
      }
    }
  }
  if (places.empty()) return -std::numeric_limits<double>::infinity();
  const VectorXd all = Eigen::Map<const VectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
  return log_sum(all) - std::log(static_cast<double>(places.size()));
}

}  // namespace plumbline::diagnose
