#pragma once
/// \file
/// What causes the gap: the causes by their probability, those of them that are the answer, and each effect's
/// own probability.

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

struct Cause {
  CauseVerdict verdict = CauseVerdict::none;
  std::vector<RankedCause> ranking;  ///< most probable first
  std::size_t named = 0;             ///< so many of them are the answer: the first one and its alternatives
  bool or_unknown = false;           ///< a cause outside of the catalogue is an alternative too
  double unknown = 0;                ///< probability of a cause outside of the catalogue
  std::vector<EffectProbability> effects;  ///< most probable first
  /// Share of the nominal residual that the leading cause leaves to a discrepancy; zero where it probably
  /// leaves none.
  double discrepancy = 0;
  double discrepancy_torque = 0;         ///< the same as a torque at the joints, root mean square
  std::string_view torque_unit = "N m";  ///< or "N" of a joint that slides

  [[nodiscard]] bool is_explained() const {
    return verdict == CauseVerdict::identified || verdict == CauseVerdict::ambiguous;
  }
};

Cause judge(const Study& study, const Findings& findings, const Posterior& posterior,
            const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
