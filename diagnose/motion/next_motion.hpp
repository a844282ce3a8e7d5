#pragma once
/// \file
/// The motion to be logged next: the one in which two explanations differ most.

#include <optional>
#include <string>

#include "diagnose/motion/bench.hpp"

namespace plumbline::motion {

struct NextMotion {
  std::string words;  ///< "a sine of 0.62 rad at 3 Hz"
  double gain;        ///< of the servo, duty per rad
  double apart;       ///< of the two predictions, root mean square, rad
};

/// Tries sines, ramps and steps within the commands and gains of the logs, from rest. Both drives are fitted
/// to these logs, so that they agree there as far as they can.
/// \returns nothing where no motion shows more than the noise of a reading
std::optional<NextMotion> next_motion(const Bench& bench, const Drive<double>& one,
                                      const Drive<double>& other);

}  // namespace plumbline::motion
