#include "diagnose/outside/departure.hpp"
#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// A few readings in a row of one run lie anywhere: a snap, a stop that is met, a cell at its end.
class LocalDeparture final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    const Measurements& measurements = left.likelihood.measurements();
    const Decomposition parts = left.likelihood.decompose(left.residual);
    return {left.look.log_by_amplitude.front() +
            log_departure(measurements, left.residual - parts.delta - parts.periodic, parts.noise,
                          in_order_of_reading(measurements))};
  }
};

}  // namespace

std::unique_ptr<OutsideCause> local_departure() {
  return std::make_unique<LocalDeparture>();
}

}  // namespace plumbline::diagnose
