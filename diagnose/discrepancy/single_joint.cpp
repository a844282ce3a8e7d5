#include "diagnose/discrepancy/single_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <plumbline/base/parallel.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/rotation.hpp"
#include "diagnose/noise/gap.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

using Effects = std::vector<EffectAt>;

/// The only sprung joint, from 1; nothing where there are others.
std::optional<std::size_t> only_joint(const Study& study) {
  const auto& stiffness = study.scales().joint_stiffness;
  const auto sprung = [](double k) { return k > 0; };
  if (std::count_if(stiffness.begin(), stiffness.end(), sprung) != 1) return std::nullopt;
  return std::find_if(stiffness.begin(), stiffness.end(), sprung) - stiffness.begin() + 1;
}

/// Every law that is tried of the joint: its nominal spring's two values, with a shape, a memory or both.
std::vector<Candidate> laws(const Study& study, std::size_t joint) {
  const std::vector<EffectAt> possible = possible_effects(study);
  const auto of_these = [&](Effects rows) {
    std::erase_if(rows, [&](const EffectAt& one) {
      return std::find(possible.begin(), possible.end(), one) == possible.end();
    });
    return rows;
  };
  const Effects nominal = of_these({{"joint_stiffness", joint}, {"rest_angle", joint}});
  std::vector<Effects> shapes{{}}, memories{{}};
  for (const EffectAt& one : of_these({"nonlinear_spring",
                                       "asymmetric_spring",
                                       {"piecewise_spring", joint},
                                       {"joint_stop", joint},
                                       "joint_stops",
                                       {"backlash", joint}}))
    shapes.push_back({one});
  for (const EffectAt& one :
       of_these({{"hysteresis", joint}, "joint_friction", "viscoelasticity", "plastic_set"}))
    memories.push_back({one});
  std::vector<Candidate> all;
  for (const Effects& shape : shapes)
    for (const Effects& memory : memories) {
      Candidate law;
      for (const Effects* part : {&shape, &memory, &nominal})
        law.effects.insert(law.effects.end(), part->begin(), part->end());
      if (!(shape.empty() && memory.empty())) all.push_back(std::move(law));
    }
  return all;
}

/// What an ideal law may leave of a device: of each channel's gap a share, where that is more than noise.
/// What is left is no noise that remembers; how neighbours share it is in what the law is worth.
NoiseModel allowed_of(const Study& study, const NoiseModel& noise) {
  const std::array<double, channel_names> gap =
      rms_by_name(study.measurements(), without_outliers(study.measurements(), study.nominal_residual()));
  NoiseModel allowed{noise.scale, 0};
  for (std::size_t c = 0; c < channel_names; ++c)
    allowed.scale[c] = std::max(noise.scale[c], beliefs::tolerated_share * gap[c]);
  return allowed;
}

double worth(const Study& study, const Fit& one) {
  return partial_criterion(study.measurements(), one);
}

/// The law without what of the nominal spring's values is worth less than it costs.
Fit simplified(const Study& study, Fit law, const FitSettings& settings) {
  for (const char* id : {"rest_angle", "joint_stiffness"}) {
    const Instance less =
        part(study, law.candidate, law.parameters, [&](const EffectAt& at) { return at.effect->id != id; });
    if (less.candidate == law.candidate) continue;
    Fit plainer = fit_from(study, less.candidate, settings, less.parameters);
    if (plainer.converged && worth(study, plainer) < worth(study, law)) law = std::move(plainer);
  }
  return law;
}

/// Whether a parameter ran to an end of its range that is not nothing: the law stands for another one then (a
/// relaxation slower than the experiment for a softer spring). Where something sets in may be anywhere, and
/// of several elements one may be anything.
bool runs_away(const Study& study, const Fit& law) {
  constexpr double end = 0.05;  // of it, or of the range where its logarithm has no zero of its own
  std::size_t p = 0;
  for (const EffectAt& at : law.candidate.effects)
    for (const ParameterRange& range : study.ranges(at)) {
      const double value = law.parameters[p++];
      if (range.is_onset() || at.effect->element_size > 0) continue;
      const bool low_is_nothing = range.coordinate == Coordinate::plain && range.low == 0;
      const bool logarithmic = range.coordinate == Coordinate::logarithm;
      const auto near_end = [&](double bound) {
        return std::abs(value - bound) < end * (logarithmic ? range.high - range.low : std::abs(bound));
      };
      if (near_end(range.high) || (!low_is_nothing && near_end(range.low))) return true;
    }
  return false;
}

/// Whether a part of a law is worth more than all of it.
bool is_outdone(const Study& study, const Fit& law, const std::vector<Fit>& others) {
  return std::any_of(others.begin(), others.end(), [&](const Fit& other) {
    return other.candidate.is_part_of(law.candidate) && worth(study, other) <= worth(study, law);
  });
}

/// The laws that are worth most, best first.
std::vector<Fit> leading(const Study& study, const std::vector<Candidate>& laws,
                         const FitSettings& settings) {
  std::vector<Fit> fits(laws.size());
  in_parallel(laws.size(), study.threads(),
              [&](std::size_t i) { fits[i] = simplified(study, fit(study, laws[i], settings), settings); });
  std::erase_if(fits, [&](const Fit& one) { return !one.converged || runs_away(study, one); });
  const std::vector<Fit> all = fits;
  std::erase_if(fits, [&](const Fit& one) { return is_outdone(study, one, all); });
  std::sort(fits.begin(), fits.end(),
            [&](const Fit& a, const Fit& b) { return worth(study, a) < worth(study, b); });
  constexpr std::size_t few = 8;
  if (fits.size() > few) fits.resize(few);
  return fits;
}

/// A law with what it leaves of held-out readings.
struct Tried {
  Fit fit;
  Rotated blind;
};

/// Those of the leading laws that close the gap, and come near the one that closes most.
std::vector<Tried> closing(const Study& study, const std::vector<Fit>& leading, const NoiseModel& noise,
                           const NoiseModel& allowed) {
  std::vector<Tried> tried;
  double least = beliefs::closed;
  for (const Fit& one : leading) {
    std::optional<Rotated> blind = rotated(study, one, noise, allowed);
    if (!blind || !blind->shrink.tested() || blind->shrink.ratio > beliefs::closed) continue;
    least = std::min(least, blind->shrink.ratio);
    tried.push_back({one, std::move(*blind)});
  }
  std::erase_if(tried,
                [&](const Tried& one) { return one.blind.shrink.ratio > beliefs::closes_near * least; });
  return tried;
}

/// Whether without any part of the readings one of these would have been worth most.
bool chosen_blind(const Study& study, const std::vector<Fit>& leading, const std::vector<Tried>& named,
                  const FitSettings& settings) {
  return std::all_of(named[0].blind.parts.begin(), named[0].blind.parts.end(), [&](const HeldOut& part) {
    const Study seen = study.of(without(study.experiment(), part));
    std::vector<double> worths;
    for (const Fit& one : leading) {
      const Fit blind = fit_from(seen, one.candidate, settings, one.parameters);
      worths.push_back(blind.converged ? worth(seen, blind) : std::numeric_limits<double>::infinity());
    }
    const auto best = std::min_element(worths.begin(), worths.end()) - worths.begin();
    const Candidate& chosen = leading[static_cast<std::size_t>(best)].candidate;
    return std::any_of(named.begin(), named.end(),
                       [&](const Tried& one) { return one.fit.candidate == chosen; });
  });
}

/// Names them in place of what was ranked before, none of which explained the gap.
void name(const Study& study, const std::vector<Tried>& named, const NoiseModel& noise, Cause& cause) {
  double sum = 0;
  cause.ranking.clear();
  for (const Tried& one : named) {
    const double odds = std::exp((worth(study, named[0].fit) - worth(study, one.fit)) / 2);
    sum += odds;
    Hypothesis hypothesis;
    hypothesis.fit = one.fit;
    cause.ranking.push_back(
        {std::move(hypothesis), odds, chi2_per_dof(study.measurements(), one.fit, noise)});
  }
  for (Ranked& one : cause.ranking) one.probability *= (1 - beliefs::wrong_single_joint) / sum;
  cause.best = 0;
  cause.equivalent.clear();
  for (std::size_t i = 1; i < named.size(); ++i) cause.equivalent.push_back(i);
  cause.verdict = CauseVerdict::ambiguous;
  cause.reservation = Reservation::single_joint;
  cause.unknown = beliefs::wrong_single_joint;
}

}  // namespace

std::optional<NamedLaw> name_single_joint(const Study& study, const NoiseModel& noise, Cause& cause) {
  const std::optional<std::size_t> joint = only_joint(study);
  if (!joint || cause.verdict != CauseVerdict::unknown) return std::nullopt;
  FitSettings settings;
  settings.noise = allowed_of(study, noise);
  const std::vector<Fit> best = leading(study, laws(study, *joint), settings);
  const std::vector<Tried> named = closing(study, best, noise, settings.noise);
  if (named.empty()) return std::nullopt;
  name(study, named, noise, cause);
  NamedLaw result{named[0].blind.shrink, settings.noise};
  result.shrink.chosen_blind = chosen_blind(study, best, named, settings);
  return result;
}

}  // namespace plumbline::diagnose
