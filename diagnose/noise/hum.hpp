#pragma once
/// \file
/// Hum: one tone in the readings, of a mains or a pump, which is noise and no matter of the chain.

#include "diagnose/noise/noise.hpp"
#include "diagnose/noise/series_tone.hpp"

namespace plumbline::diagnose {

/// Tones that stand out of the spectrum of a residual free of outliers, faster than what a gap test calls
/// slow, and no larger than noise may be (`beliefs::largest_hum`): what is larger is a ripple of the
/// device. Two a series at most; found by Fisher's test (1929) for the largest of many ordinates, by the
/// clock of the readings. What is too soft for one series is looked for in all that were read together,
/// beside a tone that one of them has, or else where it stands out as a line. A tone that is fast in one run
/// is looked for in others where it is slow, or their readings show it so, in the same channels and then in
/// the rest, at the same time's period and about as loud.
std::vector<Hum> find_hum(const Measurements& measurements, const std::vector<double>& residual);

/// The experiment whose readings are without these tones.
Experiment quiet(Experiment experiment, const Measurements& measurements, const std::vector<Hum>& hum);

}  // namespace plumbline::diagnose
