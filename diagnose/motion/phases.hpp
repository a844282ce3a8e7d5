#pragma once
/// \file
/// The phases of a motion, and the error in each.

#include <array>
#include <string_view>

#include "diagnose/motion/bench.hpp"

namespace plumbline::motion {

enum class Phase : std::size_t { at_rest, speeding_up, slowing_down, unpowered, count };
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Phase::count)> phase_words{
    "at rest", "speeding up", "slowing down", "without power"};

/// Mean |predicted - measured| over all readings of a phase, rad.
struct PhaseError {
  Phase phase;
  double readings;  ///< share of all
  double before, after;
};

/// Those phases that the logs have, each rolled out whole.
std::vector<PhaseError> errors_by_phase(const std::vector<MotionLog>& logs, const Drive<double>& before,
                                        const Drive<double>& after);

}  // namespace plumbline::motion
