#pragma once
/// \file
/// Which side a chain went to where its nominal model may go to either.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Near its loss of stiffness a chain goes to the side that its imperfections choose, and smaller ones than
/// anybody measures: a straight chain that is pressed goes to either, one that is nearly symmetric nearly
/// to either. A run whose readings are not where the nominal chain goes is looked at on the sides to which a
/// rest angle that is off by half a degree sends it; where they are there, clearly, its Side is set. Where
/// the nominal chain gets nowhere by itself, to the one that they are nearest to.
Experiment on_their_sides(const Study& study);

}  // namespace plumbline::diagnose
