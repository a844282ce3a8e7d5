#pragma once
/// \file
/// The weight of an arm whose model has no masses: it weighs something all the same, and yields under that.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Whether the arm is rigid and its model has no masses: then no pose tells its weight, until something
/// yields.
bool is_weightless(const SerialArm<double>& arm);

/// The arm with links of this density, kg/m, each about the middle of its way to the next joint or the tip.
SerialArm<double> weighed(SerialArm<double> arm, double density);

/// Gives the links of a rigid arm without masses a usual density, where no drive tells its weight and no load
/// is imposed: its compliances are then told for that.
void assume_weights(Experiment& experiment);

}  // namespace plumbline::diagnose
