#pragma once
/// \file
/// How well the instruments of a bench read, at random.

#include "trial/simulator/instruments.hpp"

namespace plumbline::simulator {

/// What the lab declares is the true sigma rounded; in 18 of 100 it is wrong by up to a factor of 1.5, 12
/// have one or two percent of outliers, 10 correlated noise. \param force  the largest of the experiment
Scatter draw_scatter(const Plan& plan, double force, Random& random);

/// As benches are: in 15 of 100 the scatter is 1.5 to 3 times what is declared, in 10 a third to a half of
/// it, 12 have 2 to 8 % of outliers, 12 noise that correlates by 0.7 to 0.9 from reading to reading, and 10
/// each noise in proportion to the reading, a hum, and one channel 2 to 4 times worse than the others.
Scatter draw_rough_scatter(const Plan& plan, double force, Random& random);

}  // namespace plumbline::simulator
