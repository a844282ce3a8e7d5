#include "diagnose/next/noise_shape.hpp"

#include <cmath>
#include <cstdlib>

namespace plumbline::diagnose::next {
namespace {

/// A reading is an outlier where that is more probable than noise: two in a hundred are, as a Cauchy density ten
/// times as wide.
bool is_outlier(double z) {
  constexpr double share = 0.02, width = 10;
  const double noise = (1 - share) * std::exp(-z * z / 2) / std::sqrt(2 * M_PI);
  return share / (width * M_PI * (1 + z * z / (width * width))) > noise;
}

}  // namespace

NoiseShape even_noise(const Data& data) {
  NoiseShape shape;
  for (const Block& block : data.blocks()) {
    shape.relative.push_back(VectorXd::Ones(block.size()));
    shape.outlier.emplace_back(static_cast<std::size_t>(block.size()), false);
  }
  return shape;
}

NoiseShape noise_shape(const Data& data, const States& states, const Hyperpriors& priors,
                       const std::vector<VectorXd>& nominal_residual, const std::vector<VectorXd>& residual,
                       NoiseShape shape) {
  for (int round = 0; round < 3; ++round) {
    const Likelihood likelihood(data, states, priors, shape, nominal_residual);
    const Split split = likelihood.split(residual);
    bool changed = false;
    for (std::size_t b = 0; b < residual.size(); ++b)
      for (Eigen::Index i = 0; i < residual[b].size(); ++i) {
        const double z = (residual[b](i) - split.delta[b](i)) / (split.scale[b] * shape.relative[b](i));
        auto marked = shape.outlier[b].begin() + i;
        const bool is = is_outlier(z);
        changed = changed || *marked != is;
        *marked = is;
      }
    if (!changed) break;
  }
  return shape;
}

}  // namespace plumbline::diagnose::next
