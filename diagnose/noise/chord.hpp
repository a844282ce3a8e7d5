#pragma once
/// \file
/// Tones that are heard in several series together.

#include "diagnose/noise/series_tone.hpp"

namespace plumbline::diagnose {

/// A tone in some series of a run, alike in frequency.
using Chord = std::vector<Hum>;

/// Adds to the tones that were heard in some run those that others then have too: the same channels first,
/// and the rest, for what hums in one may be in the room.
/// \param level  the chance that noise alone may have of them
void add_known(const Measurements& measurements, const std::vector<double>& residual, double level,
               std::vector<Hum>& all);

/// Adds to each run the tones that its series share.
/// \param spectra  of all series, from `tone_shares`
void add_shared(const Measurements& measurements, const std::vector<double>& residual,
                const std::vector<Eigen::VectorXd>& spectra, double level, std::vector<Hum>& all);

}  // namespace plumbline::diagnose
