#include "diagnose/noise/noise_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/log_sum.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {

double OutlierModel::log_outlier(double distance) const {
  return std::log(share / (priors::outlier_width * std::numbers::pi)) -
         std::log1p(std::pow(distance / priors::outlier_width, 2));
}

double OutlierModel::log_inlier(double distance) const {
  return std::log((1 - share) / std::sqrt(2 * std::numbers::pi)) - distance * distance / 2;
}

double OutlierModel::log_density(double distance) const {
  return log_sum({log_outlier(distance), log_inlier(distance)});
}

NoiseShape::NoiseShape(const Measurements& measurements)
    : relative(VectorXd::Ones(static_cast<Eigen::Index>(measurements.size()))),
      outlier(measurements.size(), false),
      periodic(static_cast<Eigen::Index>(measurements.size()), 0) {}

bool NoiseShape::has_outliers() const {
  return std::find(outlier.begin(), outlier.end(), true) != outlier.end();
}

OutlierModel NoiseShape::outliers() const {
  const auto marked = std::max<std::ptrdiff_t>(1, std::count(outlier.begin(), outlier.end(), true));
  const double others = priors::outlier_evidence * priors::outlier_share + static_cast<double>(marked) - 1;
  return {others / (priors::outlier_evidence + static_cast<double>(outlier.size()) - 1)};
}

bool NoiseShape::is_noisier(std::size_t run, Sensor sensor) const {
  return std::any_of(noisier.begin(), noisier.end(),
                     [&](const NoisierSegment& one) { return one.run == run && one.sensor == sensor; });
}

}  // namespace plumbline::diagnose
