#include "diagnose/outside/departure.hpp"

namespace plumbline::diagnose {

/// The readings at the farthest commands of a run lie anywhere: a limit of travel, of the drive or of a
/// sensor.
std::unique_ptr<OutsideCause> departure_at_the_ends() {
  return std::make_unique<EventDeparture>(from_the_ends);
}

}  // namespace plumbline::diagnose
