#pragma once
/// \file
/// Random noise of the instruments.

#include "trial/simulator/instruments.hpp"

namespace plumbline::simulator {

/// First trial: the declared sigma is the true one, rounded; in 18 of 100 it is wrong by up to 1.5, 12 have
/// one or two percent of outliers, 10 correlated noise.
/// \param force  largest of the experiment
Scatter draw_scatter(const Plan& plan, double force, Random& random);

/// Second trial: in 15 of 100 the noise is 1.5 to 3 times the declared, in 10 a third to a half; 12 have 2 to
/// 8 % of outliers, 12 an autocorrelation of 0.7 to 0.9, and 10 each proportional noise, periodic
/// interference, and one channel 2 to 4 times noisier.
Scatter draw_rough_scatter(const Plan& plan, double force, Random& random);

}  // namespace plumbline::simulator
