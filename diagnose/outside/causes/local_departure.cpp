#include "diagnose/outside/departure.hpp"

namespace plumbline::diagnose {

/// A few readings in a row of one run lie anywhere: a snap, a stop that is met, a cell at its end.
std::unique_ptr<OutsideCause> local_departure() {
  return std::make_unique<EventDeparture>([](const Measurements& measurements, const CommandStates&) {
    return in_order_of_reading(measurements);
  });
}

}  // namespace plumbline::diagnose
