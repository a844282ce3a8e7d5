#pragma once
/// \file
/// An arm as it is: its frames solved for, and every joint a little off.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// The study of an arm whose frames are unknown, with its calibration: tracker and points where they fit
/// best, joints at the posterior mean of what every arm is a little off by, as large as the readings say.
/// \returns the study as it is where frames are known
/// \throws Error where there are fewer values than unknowns, or the arm does not hold its poses
Study calibrated(const Study& study);

}  // namespace plumbline::diagnose
