#pragma once
/// \file
/// Whether fitted parameters leave an effect what it is.

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// Whether a hypothesis is what it says: none of its effects is switched off by a parameter at zero, or has
/// every parameter nearer to zero than the readings tell, and none has run to the end of a range where it
/// turns into another effect (a stop that always touches is a stiffer joint, a relaxation slower than the
/// experiment a stiffer spring), unless the readings hardly tell it from zero.
bool genuine(const Study& study, const Fit& fit);

}  // namespace plumbline::diagnose
