#include "diagnose/decision/acceptance.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <map>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/alike.hpp"
#include "diagnose/decision/genuine.hpp"
#include "diagnose/decision/rival.hpp"
#include "diagnose/decision/rotation.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether it leaves of held-out readings at most so many times the noise.
bool predicts(const std::optional<Shrink>& blind, double times) {
  return blind && blind->chi2_per_value_after < times * times;
}

/// Whether it leaves of held-out readings clearly more than noise does, by more than chance.
bool leaves_more_than_noise(const Shrink& blind) {
  if (!(blind.independent >= 1)) return false;
  const boost::math::chi_squared_distribution<double> noise(blind.independent);
  const double by_chance =
      boost::math::quantile(boost::math::complement(noise, beliefs::gap_level)) / blind.independent;
  return blind.chi2_per_value_after >
         std::max(by_chance, beliefs::clearly_more_than_noise * beliefs::clearly_more_than_noise);
}

/// Place of the best partial explanation of one effect.
std::optional<std::size_t> best_single(const Study& study, const Cause& cause) {
  std::vector<const Fit*> fits;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cause.ranking.size(); ++i) {
    const Fit& one = cause.ranking[i].hypothesis.fit;
    if (one.candidate.count() != 1 || !genuine(study, one)) continue;
    fits.push_back(&one);
    places.push_back(i);
  }
  if (fits.empty()) return std::nullopt;
  return places[best_partial(study.measurements(), fits)];
}

/// What an explanation may leave of the readings though they scatter less: what was declared, for readings
/// may repeat better than they are true; and of a gap that is far beyond the noise a share, for no model of a
/// device reaches what such readings show. Nothing where this is no more than the noise.
std::optional<NoiseModel> tolerance(const Study& study, const NoiseModel& noise) {
  const std::array<double, channel_names> gap =
      rms_by_name(study.measurements(), without_outliers(study.measurements(), study.nominal_residual()));
  NoiseModel tolerated{noise.scale, {}};
  for (std::size_t c = 0; c < channel_names; ++c) {
    if (gap[c] == 0) continue;
    // What a reading brings anew: how large the noise is beside depends on how long it is said to remember.
    const double correlation = noise.correlation_of({static_cast<Channel::Name>(c)}),
                 innovation = std::sqrt(1 - correlation * correlation);
    if (std::log(noise.scale[c]) < -2 * beliefs::scale_spread) tolerated.scale[c] = 1;
    if (gap[c] > beliefs::far_beyond * noise.scale[c] * innovation)
      tolerated.scale[c] = std::max(tolerated.scale[c], beliefs::tolerated_share * gap[c]);
  }
  return tolerated.scale == noise.scale ? std::nullopt : std::optional(tolerated);
}

/// Gives the chance of a cause outside the catalogue, and the rest to what is ranked.
void leave_to_unknown(Cause& cause, double unknown) {
  for (Ranked& one : cause.ranking) one.probability *= (1 - unknown) / (1 - cause.unknown);
  cause.unknown = unknown;
}

/// Names nothing; the best is no more than a partial explanation.
void refuse(Cause& cause, double unknown) {
  cause.verdict = CauseVerdict::unknown;
  cause.equivalent.clear();
  cause.reservation = Reservation::none;
  leave_to_unknown(cause, unknown);
}

/// Names the best only beside a cause outside the catalogue.
void hedge(Cause& cause, Reservation why) {
  cause.verdict = CauseVerdict::ambiguous;
  cause.reservation = why;
  leave_to_unknown(cause, std::max(cause.unknown, beliefs::wrong_unpredicted));
}

/// Whether the values that tolerances hold are larger than their priors let them be.
bool beyond_tolerance(const Study& study, const Fit& fit) {
  const std::vector<ParameterRange> ranges = study.ranges(fit.candidate);
  const auto held = static_cast<double>(std::count_if(
      ranges.begin(), ranges.end(), [](const ParameterRange& one) { return one.tolerance > 0; }));
  if (held == 0) return false;
  const boost::math::chi_squared_distribution<double> expected(held);
  return boost::math::cdf(boost::math::complement(expected, tolerance_charge(study, fit))) <
         beliefs::gap_level;
}

/// Whether a value at every joint, link or run stands beside another effect: many, or what tolerances hold,
/// which on a short chain are few. Alone as well, where they are very many.
bool has_values_everywhere(const Study& study, const Candidate& candidate) {
  if (candidate.effects.size() == 1) return study.ranges(candidate).size() > beliefs::too_many_values;
  if (candidate.count() < 2) return false;
  if (many_valued(study, candidate) > 0) return true;
  return std::any_of(candidate.effects.begin(), candidate.effects.end(), [&](const EffectAt& at) {
    return !candidate.has_as_tolerance(at) && study.ranges(at).front().tolerance > 0;
  });
}

/// Whether there is nothing in it but what machining leaves, all of that or one kind: of fifteen experiments
/// in which one kind was named alone two had another cause.
bool is_of_machining(const Candidate& candidate) {
  return std::all_of(candidate.effects.begin(), candidate.effects.end(),
                     [](const EffectAt& at) { return at.effect->is_tolerance; });
}

/// Whether an effect of it only says how a torque goes with the angle: of benches of another simulator whose
/// springs came to a plateau four of four were named `piecewise_spring`.
bool is_a_shape(const Study& study, const Fit& fit) {
  const std::vector<EffectAt>& effects = fit.candidate.effects;
  if (std::any_of(effects.begin(), effects.end(), [](const EffectAt& at) { return at.effect->of_shape; }))
    return true;
  const std::vector<ParameterRange> ranges = study.ranges(fit.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (fit.parameters[p] < ranges[p].shape_below) return true;
  return false;
}

/// Whether it takes three relaxation times: of sixteen benches of another simulator that relaxed by a power
/// of time fifteen were named so.
bool relaxes_in_many_ways(const Candidate& candidate) {
  const auto has = [&](std::string_view id) {
    return std::any_of(candidate.effects.begin(), candidate.effects.end(),
                       [&](const EffectAt& at) { return at.effect->id == id; });
  };
  return has("relaxation_spectrum") && has("viscoelasticity");
}

/// Whether it is friction of which nearly all grows with the load: of sixteen benches of another simulator
/// that were loaded over a pulley three were named so.
bool rubs_by_load_alone(const Study& study, const Fit& fit) {
  constexpr double much = 0.1;  // of the growth that is possible: ten times as much at a typical deflection
  std::size_t p = 0;
  for (const EffectAt& at : fit.candidate.effects)
    for (const ParameterRange& range : study.ranges(at)) {
      if (at.effect->id == "load_friction" && range.name == "growth" && fit.parameters[p] > much * range.high)
        return true;
      ++p;
    }
  return false;
}

/// Whether it turns a chain that forces load together with these, or makes it longer and as much stiffer:
/// what is read of its place is then turned or scaled as a whole. Of sixteen benches of another simulator
/// whose camera was off eight were explained so, one of them alone.
bool is_what_a_camera_does(const Study& study, const Candidate& candidate) {
  const std::vector<Run>& runs = study.experiment().runs;
  if (std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.holds_end_point(); }))
    return false;
  const auto has = [&](const EffectAt& at) {
    return std::find(candidate.effects.begin(), candidate.effects.end(), at) != candidate.effects.end();
  };
  const bool turns = has({"rail_misalignment"}) && has({"rest_angle", 1});
  const bool scales = has({"length_scale"}) &&
                      (has({"force_gain"}) || has({"stiffness_scale"}) || has({"asymmetric_spring"}));
  return turns || scales;
}

/// Whether an effect of this rig sets in where a parameter says, as a stop does; what gives back less than it
/// took does so anew after every reversal.
bool sets_in(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  return !at.effect->dissipates &&
         std::any_of(ranges.begin(), ranges.end(), [](const ParameterRange& one) { return one.is_onset(); });
}

/// In how many runs an effect of an explanation changes what is predicted by more than readings are declared
/// to scatter.
std::size_t runs_that_show(const Study& study, const Fit& fit, const EffectAt& at) {
  const Instance without =
      part(study, fit.candidate, fit.parameters, [&](const EffectAt& one) { return !(one == at); });
  const Prediction lacking = predict(study, without.candidate, without.parameters);
  if (!lacking.reached) return study.experiment().runs.size();  // without it the chain would stand nowhere
  const std::vector<double> with = study.residual(predict(study, fit.candidate, fit.parameters)),
                            plain = study.residual(lacking);
  std::map<std::size_t, double> change;
  for (const Series& series : study.measurements().series())
    for (std::size_t i = series.first; i < series.first + series.readings.size(); ++i)
      change[series.run] += std::pow(with[i] - plain[i], 2);
  constexpr double clearly = 9;  // three deviations of one reading
  std::size_t runs = 0;
  for (const auto& [run, squares] : change) runs += squares > clearly;
  return runs;
}

/// Whether an explanation takes so many effects that it explains much that it is not.
bool takes_three(const Ranked& one) {
  return one.hypothesis.fit.candidate.count() >= 3;
}

/// Weighs the ranking anew where what one of it leaves is taken for noise: beside a remainder any that has
/// more effects would be more probable, for it makes something of that. \returns the place of that one
std::size_t weigh_beside_remainder(const Study& study, const NoiseModel& noise, std::size_t place,
                                   Cause& cause) {
  const Fit accepted = cause.ranking[place].hypothesis.fit;
  const std::array<double, channel_names> left =
      rms_by_name(study.measurements(), without_outliers(study.measurements(), accepted.residual));
  Findings findings;
  for (const Ranked& one : cause.ranking) findings.hypotheses.push_back(one.hypothesis);
  findings.tolerance = {noise.scale, 0};
  for (std::size_t c = 0; c < channel_names; ++c)
    findings.tolerance->scale[c] = std::max(noise.scale[c], left[c]);
  weigh(study, findings);
  cause.ranking.clear();
  for (Hypothesis& one : findings.hypotheses) {
    const double left_over = chi2_per_dof(study.measurements(), one.fit, noise);
    cause.ranking.push_back({std::move(one), 0, left_over});
  }
  const auto is_it = [&](const Ranked& one) { return one.hypothesis.fit.candidate == accepted.candidate; };
  return static_cast<std::size_t>(std::find_if(cause.ranking.begin(), cause.ranking.end(), is_it) -
                                  cause.ranking.begin());
}

/// Settles on the best partial explanation of one effect that leaves of held-out readings at most so many
/// times the noise, where that is clearly less than the gap, and no other that lacks it is told apart from it
/// beside what it leaves. \returns what it leaves
std::optional<Shrink> accept_what_leaves(const Study& study, const NoiseModel& noise, double times,
                                         Cause& cause) {
  if (cause.verdict != CauseVerdict::unknown) return std::nullopt;
  const std::optional<std::size_t> place = best_single(study, cause);
  // What is held out is not all: a run that it does not explain may carry no gap that could be held out.
  constexpr double most = beliefs::predicts * beliefs::predicts;
  if (!place || cause.ranking[*place].chi2_per_dof > most) return std::nullopt;
  const std::optional<Rotated> blind = rotated(study, cause.ranking[*place].hypothesis.fit, noise, noise);
  if (!blind) return std::nullopt;
  if (!predicts(blind->shrink, times) || blind->shrink.noise_floor_ratio > beliefs::clear)
    return std::nullopt;
  Cause weighed = cause;
  const std::size_t accepted = weigh_beside_remainder(study, noise, *place, weighed);
  const Hypothesis &one = weighed.ranking[accepted].hypothesis, &first = weighed.ranking.front().hypothesis;
  const bool is_behind = first.log_evidence - one.log_evidence > beliefs::told_apart;
  if (is_behind && !contains(first.fit.candidate, one.fit.candidate)) return std::nullopt;
  cause = std::move(weighed);
  settle_on(cause, accepted, beliefs::other_than_nearly);
  return blind->shrink;
}

}  // namespace

bool accept_remainder(const Study& study, const NoiseModel& noise, Cause& cause) {
  const std::optional<Shrink> blind = accept_what_leaves(study, noise, beliefs::nearly, cause);
  if (!blind) return false;
  const Candidate& best = cause.ranking[cause.best].hypothesis.fit.candidate;
  if (leaves_more_than_noise(*blind) || study.ranges(best).size() >= beliefs::many_to_leave_structure)
    hedge(cause, Reservation::beyond_noise);
  return true;
}

bool accept_doubtful(const Study& study, const NoiseModel& noise, Cause& cause) {
  if (!accept_what_leaves(study, noise, beliefs::predicts, cause)) return false;
  hedge(cause, Reservation::beyond_noise);
  return true;
}

bool step_down(const std::optional<Shrink>& blind, Cause& cause) {
  if (cause.verdict == CauseVerdict::unknown || !takes_three(cause.ranking[cause.best])) return false;
  if (predicts(blind, beliefs::predicts)) return false;
  const auto adequate = [](const Ranked& one) {
    return !takes_three(one) && one.hypothesis.p_value.value_or(0) >= beliefs::fit_level;
  };
  if (std::none_of(cause.ranking.begin(), cause.ranking.end(), adequate)) return false;
  std::erase_if(cause.ranking, takes_three);
  const auto plainer = std::find_if(cause.ranking.begin(), cause.ranking.end(), adequate);
  settle_on(cause, static_cast<std::size_t>(plainer - cause.ranking.begin()), cause.unknown);
  return true;
}

void demand_prediction(const Study& study, const std::optional<Shrink>& blind, Cause& cause) {
  if (cause.verdict == CauseVerdict::unknown) return;
  const Fit& best = cause.ranking[cause.best].hypothesis.fit;
  if (takes_three(cause.ranking[cause.best])) {
    refuse(cause, beliefs::wrong_three);
  } else if (!blind || !blind->tested()) {
    hedge(cause, Reservation::not_tested);
  } else if (!predicts(blind, beliefs::predicts) && best.candidate.count() > 1 &&
             !best.candidate.has_all_tolerances()) {
    refuse(cause, beliefs::wrong_unpredicted_compound);
  } else if (!predicts(blind, beliefs::predicts)) {
    hedge(cause, Reservation::not_predicted);
  } else if (leaves_more_than_noise(*blind)) {
    hedge(cause, Reservation::beyond_noise);
  } else if (has_values_everywhere(study, best.candidate)) {
    hedge(cause, Reservation::many_values);
  } else if (best.candidate.count() > 1 && blind->noise_floor_ratio > beliefs::tells_compounds) {
    hedge(cause, Reservation::small_gap);
  } else if (beyond_tolerance(study, best)) {
    hedge(cause, Reservation::beyond_tolerance);
  } else if (is_of_machining(best.candidate)) {
    hedge(cause, Reservation::machining_alone);
  } else if (is_a_shape(study, best)) {
    hedge(cause, Reservation::shape_alone);
  } else if (rubs_by_load_alone(study, best)) {
    hedge(cause, Reservation::load_alone);
  } else if (is_what_a_camera_does(study, best.candidate)) {
    hedge(cause, Reservation::camera);
  } else if (relaxes_in_many_ways(best.candidate)) {
    hedge(cause, Reservation::many_times);
  }
}

void demand_shrink(const std::optional<Shrink>& blind, Cause& cause) {
  if (cause.verdict == CauseVerdict::unknown || !blind || !blind->tested()) return;
  const bool shrinks = blind->ratio * blind->ratio <= beliefs::leaves_the_gap;
  if (!shrinks && !predicts(blind, beliefs::predicts)) refuse(cause, beliefs::wrong_unshrunk);
}

void demand_second_run(const Study& study, Cause& cause) {
  if (cause.verdict == CauseVerdict::unknown || cause.reservation != Reservation::none) return;
  const Fit& best = cause.ranking[cause.best].hypothesis.fit;
  const std::vector<EffectAt>& effects = best.candidate.effects;
  if (std::any_of(effects.begin(), effects.end(), [&](const EffectAt& at) {
        return sets_in(study, at) && runs_that_show(study, best, at) < 2;
      }))
    hedge(cause, Reservation::one_run);
}

void share_with_class(Cause& cause) {
  if (cause.equivalent.empty()) return;
  double& best = cause.ranking[cause.best].probability;
  double others = 0;
  for (const std::size_t place : cause.equivalent) others += cause.ranking[place].probability;
  const double missing = beliefs::another_of_class * (best + others) - others;
  if (!(missing > 0)) return;
  best -= missing;
  for (const std::size_t place : cause.equivalent)
    cause.ranking[place].probability += missing / static_cast<double>(cause.equivalent.size());
}

bool accept_tolerable(const Study& study, const Study& seen, Findings chosen, Findings& findings,
                      Cause& cause) {
  if (cause.verdict != CauseVerdict::unknown) return false;
  chosen.tolerance = tolerance(study, findings.noise);
  if (!chosen.tolerance) return false;
  weigh(seen, chosen);
  // What fewer readings refuse, more do.
  if (judge(seen, chosen).verdict == CauseVerdict::unknown) return false;
  Findings tolerable = confirmed(study, chosen);
  Cause within = judge(study, tolerable);
  if (within.verdict == CauseVerdict::unknown) return false;
  if (within.ranking[within.best].hypothesis.fit.candidate.count() > 1) return false;
  hedge(within, Reservation::beyond_noise);
  cause = std::move(within);
  findings = std::move(tolerable);
  return true;
}

}  // namespace plumbline::diagnose
