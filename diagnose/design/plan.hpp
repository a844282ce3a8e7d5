#pragma once
/// \file
/// A plan before any data: which effects a bench cannot see, which it cannot tell apart, and the fewest runs
/// that separate the rest.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Effects of which no two are told apart, and which are mistaken for the same others.
struct Indistinguishable {
  std::vector<EffectAt> effects;
  std::vector<EffectAt> others;  ///< that each of them may be mistaken for, or the other way round
  bool exactly = false;          ///< several effects, and no reading differs between them
};

/// What some runs leave open.
struct Unidentifiable {
  std::vector<EffectAt> undetectable;                ///< at a sizeable value below the noise
  std::vector<Indistinguishable> indistinguishable;  ///< of those that are seen
};

/// What takes more runs than this is never seen or told apart: a lab makes so many for one question.
inline constexpr std::size_t few_runs = 5;

struct Plan {
  std::string experiment;
  std::vector<EffectAt> impossible;       ///< what cannot act on the bench, or nothing shows
  std::size_t candidates = 0;             ///< runs that the bench could make
  Unidentifiable unidentifiable;          ///< by any few of them
  std::optional<Unidentifiable> planned;  ///< by the runs that are planned, where their commands are given
  std::size_t separated = 0;              ///< pairs of effects that some of the runs tell apart
  std::vector<std::string> fewest;        ///< runs that do it, the most telling first
  bool proved_minimal = false;            ///< no fewer of the candidates do
};

/// An effect is seen, and two are told apart, where the right explanation is expected to lead in
/// log-likelihood by `beliefs::told_apart` over the other, refitted: the nominal model, or the other effect;
/// each of the two in turn is true, of a sizeable value. As for the verdict, an effect does not compete with
/// its own special cases, nor with parameters to spare.
/// \param bench     its measured channels empty; a run without readings says what the bench can do
/// \param progress  called now and then with the share of the work that is done
/// \throws Error where the nominal chain cannot follow what is planned, or no run could be made
Plan plan(const Experiment& bench, const std::function<void(double)>& progress = {});

}  // namespace plumbline::diagnose
