#pragma once
/// \file
/// Is there a gap? A test of a residual against noise whose scale and correlation are themselves uncertain.

#include "diagnose/noise/hum.hpp"

namespace plumbline::diagnose {

/// The answer for one residual.
struct GapTest {
  double p_value;    ///< chance of as much structure from noise alone, over all that was looked at
  double structure;  ///< low-frequency energy over what this noise explains; 1 without a gap
  std::vector<double> series_p_value;  ///< by series, each alone
  NoiseModel noise;                    ///< scale and correlation estimated along, beside hum
  std::vector<Hum> hum;                ///< tones that were taken for noise
};

/// Tests whether a residual is noise: of any scale, correlated between neighbours up to a limit, with
/// isolated outliers and hum. Looks at the energy of the six slowest cosine components of every series,
/// together and one by one, and at the energy of all of them, against the noise that the differences of
/// neighbours show; the p-value covers all three. The null distribution comes from simulated noise of the
/// same layout that runs through the same estimators, over every correlation that the estimate leaves open.
GapTest test_gap(const Measurements& measurements, const std::vector<double>& residual);

/// The same chance for what a fit leaves, by which the levels that verdicts go by were found: noise that is
/// slower than it seems is taken to be as large as it seems. In long runs that refuses more than the test for
/// a gap does, in short ones it may refuse less.
double structure_p_value(const Measurements& measurements, const std::vector<double>& residual);

/// Root mean square of a residual by Channel::Name; zero where nothing was measured.
std::array<double, channel_names> rms_by_name(const Measurements& measurements,
                                              const std::vector<double>& residual);

}  // namespace plumbline::diagnose
