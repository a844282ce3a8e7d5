#pragma once
/// \file
/// The identifiability study of a bench before any data: undetectable effects, indistinguishable effects, and
/// the fewest runs that distinguish the rest.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Effects that are pairwise indistinguishable and share their further alternatives.
struct Indistinguishable {
  std::vector<EffectAt> effects;
  std::vector<EffectAt> others;  ///< further effects from which none of them can be distinguished
  bool exactly = false;          ///< several effects with identical readings
};

/// Effects that a set of runs cannot detect or distinguish.
struct Unidentifiable {
  std::vector<EffectAt> undetectable;                ///< below the noise at their typical size
  std::vector<Indistinguishable> indistinguishable;  ///< among the detectable ones
};

/// Largest number of runs for one question: effects that need more count as unidentifiable.
inline constexpr std::size_t few_runs = 5;

struct Plan {
  std::string experiment;
  std::vector<EffectAt> impossible;       ///< effects that cannot act on the bench, or that it cannot measure
  std::size_t candidates = 0;             ///< number of feasible runs
  Unidentifiable unidentifiable;          ///< with any few of the feasible runs
  std::optional<Unidentifiable> planned;  ///< with the planned runs, where their commands are given
  std::size_t separated = 0;              ///< pairs of effects that some of the runs distinguish
  std::vector<std::string> fewest;        ///< the fewest runs that do so, in the order of their contribution
  bool proved_minimal = false;            ///< no smaller set of feasible runs does so
};

/// An effect is detected, and two effects are distinguished, where the expected log-likelihood ratio of the
/// truth over the refitted alternative exceeds `beliefs::told_apart`. The alternative is the nominal model,
/// or the other effect; either effect is taken as the truth, at its typical size. An alternative does not
/// compete with its own special case, nor where it has more than one parameter more than the truth.
/// \param bench     its measured channels are empty; a run without readings describes the bench
/// \param progress  called from time to time with the fraction of work done
/// \throws Error where the nominal model cannot follow a planned run, or no run is feasible
Plan plan(const Experiment& bench, const std::function<void(double)>& progress = {});

}  // namespace plumbline::diagnose
