#include "diagnose/outside/departure.hpp"
#include "diagnose/outside/outside_cause.hpp"

namespace plumbline::diagnose {
namespace {

/// The readings at the farthest commands of a run lie anywhere: a limit of travel, of the drive or of a
/// sensor.
class DepartureAtTheEnds final : public OutsideCause {
  [[nodiscard]] OutsideFit fit(const Leftover& left) const override {
    const Measurements& measurements = left.likelihood.measurements();
    const Decomposition parts = left.likelihood.decompose(left.residual);
    return {left.look.log_by_amplitude.front() +
            log_departure(measurements, left.residual - parts.delta - parts.periodic, parts.noise,
                          from_the_ends(measurements, left.likelihood.states()))};
  }
};

}  // namespace

std::unique_ptr<OutsideCause> departure_at_the_ends() {
  return std::make_unique<DepartureAtTheEnds>();
}

}  // namespace plumbline::diagnose
