#pragma once
/// \file
/// What causes the gap: the causes by their probability, those of them that are the answer, and each effect's
/// own probability.

#include <optional>
#include <string_view>

#include "diagnose/decision/verdict.hpp"

namespace plumbline::diagnose {

/// A cause in its most probable form.
struct RankedCause {
  Hypothesis hypothesis;
  Candidate cause;  ///< its effects, without manufacturing tolerances beside others
  double probability;
  double chi2_per_value;  ///< in the noise as it is, without outliers
};

/// That an effect is part of whatever is the cause.
struct EffectProbability {
  std::string label;
  double probability;
};

/// What a partial cause leaves, which is outside of the catalogue.
struct Rest {
  double share;        ///< of the residual that it leaves of readings that its fit has not seen
  double noise_floor;  ///< what noise alone would leave
  std::string why;     ///< a clause: why it is not the whole cause
};

struct Cause {
  CauseVerdict verdict = CauseVerdict::none;
  std::vector<RankedCause> ranking;  ///< most probable first
  std::size_t named = 0;             ///< so many of them are the answer: the first one and its alternatives
  bool or_unknown = false;           ///< a cause outside of the catalogue is an alternative too
  bool too_few_readings = false;     ///< to tell causes that leave nothing from one outside of the catalogue
  std::optional<Rest> rest;          ///< of a partial cause
  double unknown = 0;                ///< probability of a cause outside of the catalogue
  std::vector<EffectProbability> effects;  ///< most probable first
  /// Share of the nominal residual that the leading cause leaves to a discrepancy; zero where it probably
  /// leaves none.
  double discrepancy = 0;
  double discrepancy_torque = 0;         ///< the same as a torque at the joints, root mean square
  std::string_view torque_unit = "N m";  ///< or "N" of a joint that slides

  [[nodiscard]] bool is_explained() const {
    return verdict == CauseVerdict::identified || verdict == CauseVerdict::ambiguous ||
           verdict == CauseVerdict::partial;
  }
  /// Whether more than the causes named acts: the gap, or what a part leaves of it, is outside the catalogue.
  [[nodiscard]] bool leaves_a_rest() const {
    return verdict == CauseVerdict::unknown || verdict == CauseVerdict::partial;
  }
};

/// Mean square of a residual in the noise as it is, without outliers.
double chi2_per_value(const Study& study, const NoiseEstimate& noise, const VectorXd& residual);

Cause judge(const Study& study, const Findings& findings, const Posterior& posterior,
            const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
