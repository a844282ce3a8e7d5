#include <cmath>
#include <limits>

#include "diagnose/outside/outside_cause.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// A run, or a segment of one, that scatters more than the rest does so by the device: any order of magnitude
/// up to two is as probable, where noise has the density of a scale.
class ScatterOfAPart final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    constexpr double orders = 2, student = 0.375;  // density of four degrees of freedom at zero
    std::vector<double> gain{-std::numeric_limits<double>::infinity()};
    for (const NoisierSegment& one : left.likelihood.shape().noisier)
      gain.push_back(-std::log(orders * std::log(10.0)) - std::log(student / priors::noise_scale_spread) -
                     log_scale_prior(std::log(one.factor)));
    return {left.look.log_by_amplitude.front() + log_sum(gain)};
  }
};

}  // namespace

std::unique_ptr<OutsideCause> scatter_of_a_part() {
  return std::make_unique<ScatterOfAPart>();
}

}  // namespace plumbline::diagnose
