#include "diagnose/decision/local_departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {

double log_local_departure(const Measurements& measurements, const VectorXd& left, const NoiseEstimate& noise) {
  constexpr std::size_t longest = 8;  // readings, and a quarter of a run
  const VectorXd sigma = noise.sigma(measurements);
  // By run and reading: log density in the departure over that outside of it.
  std::vector<std::vector<double>> gain;
  for (const Series& series : measurements.series()) {
    gain.resize(std::max(gain.size(), series.run + 1));
    std::vector<double>& run = gain[series.run];
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      run.resize(std::max(run.size(), series.readings[i] + 1), 0.0);
      const double z = left(static_cast<Eigen::Index>(series.first + i)) / sigma(static_cast<Eigen::Index>(series.first + i));
      const double otherwise = log_sum(Eigen::Vector2d(log_outlier(z), log_inlier(z)));
      run[series.readings[i]] += log_outlier(z) - std::log(priors::outlier_share) - otherwise;
    }
  }
  std::vector<double> places;
  for (const std::vector<double>& run : gain) {
    const std::size_t most = std::clamp<std::size_t>(run.size() / 4, 1, longest);
    for (std::size_t from = 0; from < run.size(); ++from) {
      double sum = 0;
      for (std::size_t to = from; to < std::min(run.size(), from + most); ++to)
        places.push_back(sum += run[to]);
    }
  }
  if (places.empty()) return -std::numeric_limits<double>::infinity();
  const VectorXd all = Eigen::Map<const VectorXd>(places.data(), static_cast<Eigen::Index>(places.size()));
  return log_sum(all) - std::log(static_cast<double>(places.size()));
}

}  // namespace plumbline::diagnose
