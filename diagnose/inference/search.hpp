#pragma once
/// \file
/// Looking for what explains the readings: every effect alone, then two and three together where one is not
/// enough.

#include <functional>
#include <optional>

#include "diagnose/inference/evidence.hpp"
#include "diagnose/noise/gap.hpp"

namespace plumbline::diagnose {

/// An explanation that was fitted.
struct Hypothesis {
  Fit fit;
  double log_likelihood = 0;
  double log_evidence = 0;
  std::optional<double> p_value;  ///< of the test for structure in what it leaves, where it was needed
};

/// What the search found, best evidence first, and the noise that the best of them leaves.
struct Findings {
  std::vector<Hypothesis> hypotheses;
  NoiseModel noise;
  /// What an explanation may leave, where that is more than the readings scatter. `noise` is then wider by as
  /// much as makes neighbours that share what is left count as one.
  std::optional<NoiseModel> tolerance = std::nullopt;
};

/// Fits every possible effect; where the best still leaves structure, combinations of two, then of three.
/// \param progress  called with the share of the work that is done
/// \param known     what was fitted to the same readings already, and is looked at too
Findings search(const Study& study, const std::function<void(double)>& progress = {},
                const Findings& known = {});

/// Weighs fitted hypotheses against each other, best evidence first, in the noise that the best of them
/// leaves, or in what is tolerated and shared by neighbours.
void weigh(const Study& study, Findings& findings);

}  // namespace plumbline::diagnose
