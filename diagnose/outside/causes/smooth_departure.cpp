#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// A smooth function of the command in all channels, of any size.
class SmoothDeparture final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    const Hyperpriors& priors = left.likelihood.priors();
    return {log_sum(sum(left.look.log_by_amplitude, priors.log_amplitude_outside)), 0,
            expected(left.look.log_by_amplitude, priors.log_amplitude_outside, left.look.discrepancy)};
  }
};

}  // namespace

std::unique_ptr<OutsideCause> smooth_departure() {
  return std::make_unique<SmoothDeparture>();
}

}  // namespace plumbline::diagnose
