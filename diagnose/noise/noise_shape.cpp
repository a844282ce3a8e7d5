#include "diagnose/noise/noise_shape.hpp"

#include <algorithm>

namespace plumbline::diagnose {

NoiseShape::NoiseShape(const Measurements& measurements)
    : relative(VectorXd::Ones(static_cast<Eigen::Index>(measurements.size()))),
      outlier(measurements.size(), false),
      periodic(static_cast<Eigen::Index>(measurements.size()), 0) {}

bool NoiseShape::has_outliers() const {
  return std::find(outlier.begin(), outlier.end(), true) != outlier.end();
}

bool NoiseShape::is_noisier(std::size_t run, Sensor sensor) const {
  return std::any_of(noisier.begin(), noisier.end(),
                     [&](const NoisierSegment& one) { return one.run == run && one.sensor == sensor; });
}

}  // namespace plumbline::diagnose
