#include "diagnose/noise/noise_shape.hpp"

namespace plumbline::diagnose {

NoiseShape::NoiseShape(const Measurements& measurements)
    : relative(VectorXd::Ones(static_cast<Eigen::Index>(measurements.size()))),
      outlier(measurements.size(), false),
      periodic(static_cast<Eigen::Index>(measurements.size()), 0) {}

}  // namespace plumbline::diagnose
