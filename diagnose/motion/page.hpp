#pragma once
/// \file
/// The report of a joint in motion as a page, with the plots that people look at.

#include <string>

#include "diagnose/motion/diagnosis.hpp"

namespace plumbline::motion {

/// The report as text, and of the logs that are predicted worst without a cause: position and error over time
/// before and after, and the torque that friction takes over the speed, with the fitted law.
/// \returns a whole document
std::string as_html(const Bench& bench, const Diagnosis& diagnosis);

}  // namespace plumbline::motion
