#pragma once
/// \file
/// Noise of what is imposed on a joint alone, where a sensor read it: the motion behind it, and what is left
/// of it in what is measured.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// The experiment with the angles or torques that were probably imposed on its joint alone, in place of those
/// that a sensor read: they drive every model, and a history does not remember noise. Motions keep their
/// speed from reading to reading but for changes with a Student density of two degrees of freedom, small ones
/// for the most part, whose size the readings of the run say. What is measured moves along the nominal model
/// with what is imposed, so that its noise is as it was, independent from reading to reading. Where nothing
/// imposed has noise, or another run measures it, the experiment is as it was; so is a run of less than four
/// readings, or with readings without what is imposed.
Experiment with_probable_motion(Experiment experiment);

/// Variances that the noise of an imposed angle or torque adds to every predicted value of a joint alone,
/// through the nominal model: a trace a run, in squares of SI units. Empty where nothing imposed has noise;
/// that of a chain's imposed channels does not count.
std::vector<Trace> variance_by_imposed(const Experiment& experiment);

}  // namespace plumbline::diagnose
