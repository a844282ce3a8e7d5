#pragma once
/// \file
/// Effects as a diagnosis would have found them.

#include "diagnose/answers/diagnosis.hpp"
#include "tests/diagnose/bench.hpp"

namespace plumbline::exchange::test {

using diagnose::EffectAt, diagnose::Study, diagnose::test::chosen;

/// A sizeable amount of the effect, in fitted coordinates.
inline std::vector<double> sizeable(const Study& study, const EffectAt& at) {
  if (const auto own = chosen(at); own && !own->sizeable.empty()) return own->sizeable;
  std::vector<double> values;
  for (const diagnose::ParameterRange& range : study.ranges(at)) values.push_back(0.5 * range.scale);
  return values;
}

/// A cause with these values, in fitted coordinates.
inline diagnose::RankedCause ranked(const diagnose::Candidate& candidate,
                                    const std::vector<double>& parameters) {
  diagnose::RankedCause cause{};
  cause.hypothesis.candidate = cause.cause = candidate;
  cause.hypothesis.parameters = parameters;
  return cause;
}

/// A diagnosis that found this.
inline diagnose::Diagnosis found(const Study& study, const EffectAt& at,
                                 const std::vector<double>& parameters) {
  diagnose::Diagnosis diagnosis{study.experiment().name,
                                {},
                                {},
                                {},
                                diagnose::test::declared_noise(study),
                                {},
                                {},
                                {},
                                false,
                                {},
                                {},
                                {}};
  diagnosis.cause.verdict = diagnose::CauseVerdict::identified;
  diagnosis.cause.ranking.push_back(ranked({{at}}, parameters));
  diagnosis.cause.named = 1;
  diagnosis.estimates.emplace_back();
  std::size_t p = 0;
  for (const diagnose::ParameterRange& range : study.ranges(at)) {
    const double value = diagnose::catalogue_value(range.coordinate, parameters[p++]);
    diagnosis.estimates.back().push_back({std::string(range.name), "", value, value, value, false});
  }
  return diagnosis;
}

}  // namespace plumbline::exchange::test
