#include "diagnose/answers/diagnosis.hpp"

#include <algorithm>
#include <limits>
#include <plumbline/base/error.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/acceptance.hpp"
#include "diagnose/decision/rotation.hpp"
#include "diagnose/discrepancy/implied_shares.hpp"
#include "diagnose/discrepancy/single_joint.hpp"
#include "diagnose/noise/hum.hpp"
#include "diagnose/noise/outliers.hpp"

namespace plumbline::diagnose {
namespace {

using Report = std::function<void(double)>;

void require_reached(const Study& study) {
  if (study.nominal().reached) return;
  const std::vector<Run>& runs = study.experiment().runs;
  if (study.experiment().link_length.size() == 1 &&
      std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.holds_end_point(); }))
    throw Error("experiment \"" + study.experiment().name + "\"",
                "a single link whose end point is imposed, which pulls along the link with any force",
                "runs under a force, or a second link that turns freely to carry the force");
  throw Error("experiment \"" + study.experiment().name + "\"", "runs that the nominal chain cannot follow",
              "end points within reach and a stable posture at every reading");
}

/// What the runs never touched: a nominal parameter's change that no measured value shows; and what the user
/// stated of time, or of readings, that this bench has not.
std::vector<EffectAt> not_excited(const Study& study, const Findings& findings, const Cause& cause) {
  const std::vector<EffectAt> possible = possible_effects(study);
  std::vector<EffectAt> result;
  for (std::size_t stated = catalogue().size(); stated < study.effects().size(); ++stated) {
    const Effect& row = *study.effects()[stated];
    if (std::none_of(possible.begin(), possible.end(), [&](const EffectAt& at) { return at.effect == &row; }))
      result.emplace_back(row);
  }
  for (const EffectAt& at : possible) {
    const auto place =
        std::find_if(findings.hypotheses.begin(), findings.hypotheses.end(),
                     [&](const Hypothesis& one) { return one.fit.candidate == Candidate{{at}}; });
    const bool is_told = std::any_of(result.begin(), result.end(), [&](const EffectAt& form) {
      return Candidate{{form}}.is_form_of({{at}});
    });
    if (place != findings.hypotheses.end() && place->fit.information.size() > 0 &&
        place->fit.information.maxCoeff() == 0 && !is_told)
      result.push_back(at);
  }
  if (cause.ranking.empty()) return result;
  // What the best explanation is made of has been seen at work.
  const std::vector<EffectAt>& best = cause.ranking[cause.best].hypothesis.fit.candidate.effects;
  std::erase_if(result, [&](const EffectAt& at) {
    return std::any_of(best.begin(), best.end(),
                       [&](const EffectAt& seen) { return Candidate{{seen}}.is_form_of({{at}}); });
  });
  return result;
}

/// Whether what led on fewer readings falls behind on all of them.
bool overturned(const Findings& on_fewer, const Findings& on_all) {
  const Candidate& led = on_fewer.hypotheses.front().fit.candidate;
  const auto place = std::find_if(on_all.hypotheses.begin(), on_all.hypotheses.end(),
                                  [&](const Hypothesis& one) { return one.fit.candidate.is_form_of(led); });
  return place == on_all.hypotheses.end() ||
         place->log_evidence < on_all.hypotheses.front().log_evidence - beliefs::told_apart;
}

bool leaves_structure(const Measurements& measurements, const Findings& findings) {
  return structure_p_value(measurements, findings.hypotheses.front().fit.residual) < beliefs::fit_level;
}

/// Whether the choice that is made without a part falls on the best explanation, or among those that are then
/// not told apart on it. Every single effect has been looked at; several together are looked for anew, for
/// which were found is a choice too.
bool chosen_without(const Study& study, const HeldOut& part, const Findings& findings, const Cause& cause) {
  const Study seen = study.of(without(study.experiment(), part));
  const Candidate& best = cause.ranking[cause.best].hypothesis.fit.candidate;
  const Cause blind = judge(seen, best.count() > 1 ? search(seen) : confirmed(seen, findings));
  if (blind.ranking.empty()) return false;
  const auto is_best = [&](std::size_t place) {
    return blind.ranking[place].hypothesis.fit.candidate.is_form_of(best);
  };
  return is_best(blind.best) || std::any_of(blind.equivalent.begin(), blind.equivalent.end(), is_best);
}

/// How far the best explanation shrinks the residual where its fit, and a choice like that which fell on it,
/// have not seen it.
std::optional<Shrink> shrink_of(const Study& study, const Findings& findings, const NoiseModel& noise,
                                const Cause& cause) {
  if (cause.ranking.empty()) return std::nullopt;
  std::optional<Rotated> blind = rotated(study, cause.ranking[cause.best].hypothesis.fit, noise, noise);
  if (!blind) return std::nullopt;
  blind->shrink.chosen_blind =
      std::all_of(blind->parts.begin(), blind->parts.end(),
                  [&](const HeldOut& part) { return chosen_without(study, part, findings, cause); });
  return blind->shrink;
}

/// Whether readings that were held out tell against it: it does not leave clearly less of them than the
/// nominal model.
bool fails(const Shrink& shrink) {
  return shrink.tested() && !(shrink.ratio_high < 1);
}

/// Whether a law is no use: it does not predict, or no better than what is named, or clearly worse than what
/// explains a part of the gap; where these leave much the same, the law has a picture.
bool is_no_use(const OfferedLaw& law, const Diagnosis& diagnosis) {
  constexpr double clearly = 1.25;
  if (!law.shrink) return false;
  if (fails(*law.shrink)) return true;
  const double times = diagnosis.cause.verdict == CauseVerdict::unknown ? clearly : 1;
  return diagnosis.shrink && !(law.shrink->ratio < times * diagnosis.shrink->ratio);
}

/// The best of a few partial explanations, as it is fitted to a study.
Instance best_part(const Study& study, const Findings& found) {
  constexpr std::size_t few = 8;
  Findings leading = found;
  if (leading.hypotheses.size() > few) leading.hypotheses.resize(few);
  const Findings findings = confirmed(study, leading);
  std::vector<const Fit*> fits;
  for (const Hypothesis& hypothesis : findings.hypotheses) fits.push_back(&hypothesis.fit);
  if (fits.empty()) return {};
  const Fit& partial = *fits[best_partial(study.measurements(), fits)];
  return {partial.candidate, partial.parameters};
}

/// Where no known effect explains the gap: a law that closes it, if one predicts; on the nominal model,
/// unless it predicts clearly better beside a partial explanation.
void offer_law_to(const Study& study, const Findings& chosen, Diagnosis& diagnosis) {
  constexpr double clearly = 0.8;
  diagnosis.law = offer_law(study, diagnosis.noise, [](const Study&) { return Instance(); });
  std::optional<OfferedLaw> beside =
      offer_law(study, diagnosis.noise, [&](const Study& seen) { return best_part(seen, chosen); });
  const auto ratio = [](const std::optional<OfferedLaw>& law) {
    return law && law->shrink ? law->shrink->ratio : std::numeric_limits<double>::infinity();
  };
  if (!diagnosis.law || ratio(beside) < clearly * ratio(diagnosis.law)) diagnosis.law = std::move(beside);
  if (diagnosis.law && is_no_use(*diagnosis.law, diagnosis)) diagnosis.law.reset();
  if (diagnosis.offers_law()) diagnosis.shrink = diagnosis.law->shrink;
}

void offer_only_what_predicts(Diagnosis& diagnosis) {
  const bool unknown = diagnosis.cause.verdict == CauseVerdict::unknown;
  if (!unknown || !diagnosis.shrink || !fails(*diagnosis.shrink)) return;
  diagnosis.shrink.reset();
  diagnosis.nothing_predicts = true;
}

/// What was chosen on fewer readings, judged on all; searched for again on all of them where what was held
/// out holds the trace of a further cause.
Findings judged_on_all(const Study& study, const Study& seen, const Findings& chosen, Cause& cause,
                       const Report& progress) {
  const bool structured = leaves_structure(seen.measurements(), chosen);
  Findings findings = confirmed(study, chosen);
  cause = judge(study, findings);
  const bool missed = cause.verdict == CauseVerdict::unknown && !structured;
  if (!missed && !overturned(chosen, findings)) return findings;
  findings = search(study, progress, findings);
  cause = judge(study, findings);
  return findings;
}

/// Tests the best explanation on held-out readings and settles what is said of it. \returns the findings that
/// this is said by
Findings put_to_the_test(const Study& study, const Study& seen, const Findings& chosen, Findings findings,
                         Diagnosis& diagnosis) {
  const auto test_best = [&] {
    diagnosis.shrink = shrink_of(study, findings, diagnosis.noise, diagnosis.cause);
  };
  test_best();
  if (step_down(diagnosis.shrink, diagnosis.cause)) test_best();
  demand_prediction(study, diagnosis.shrink, diagnosis.cause);
  if (accept_remainder(study, findings.noise, diagnosis.cause) ||
      accept_tolerable(study, seen, chosen, findings, diagnosis.cause) ||
      accept_doubtful(study, findings.noise, diagnosis.cause)) {
    test_best();
    if (diagnosis.shrink && diagnosis.shrink->tested())
      diagnosis.cause.remainder = diagnosis.shrink->beyond_noise();
  }
  demand_shrink(diagnosis.shrink, diagnosis.cause);
  demand_second_run(study, diagnosis.cause);
  return findings;
}

/// Tones that the leading explanation leaves: of the readings themselves a gap hides them.
std::vector<Hum> heard_beside(const Study& study, const Findings& findings) {
  if (findings.hypotheses.empty()) return {};
  const Measurements& measurements = study.measurements();
  return find_hum(measurements, without_outliers(measurements, findings.hypotheses.front().fit.residual));
}

enum class Hears { hum, nothing };

/// \param hears  whether hum may be left in the readings: what is heard is taken out, and all is done again
void explain(const Study& study, Diagnosis& diagnosis, const Report& progress, Hears hears) {
  const HeldOut heldout = choose_heldout(study.experiment());
  const Study seen = study.of(without(study.experiment(), heldout));
  const Findings chosen = search(seen, [&](double share) { progress(0.1 + 0.4 * share); });
  if (chosen.hypotheses.empty()) {
    diagnosis.cause.verdict = CauseVerdict::unknown;
    diagnosis.cause.unknown = 1;
    offer_law_to(study, chosen, diagnosis);
    return;
  }
  Findings findings =
      judged_on_all(study, seen, chosen, diagnosis.cause, [&](double share) { progress(0.5 + 0.4 * share); });
  if (hears == Hears::hum) {
    const std::vector<Hum> hum = heard_beside(study, findings);
    diagnosis.gap.hum = listed(study, hum);
    if (!hum.empty()) {
      const Study still = study.of(quiet(study.experiment(), study.measurements(), hum));
      explain(
          still, diagnosis, [&](double share) { progress(0.9 + 0.1 * share); }, Hears::nothing);
      return;
    }
  }
  diagnosis.noise = findings.noise;
  findings = put_to_the_test(study, seen, chosen, std::move(findings), diagnosis);
  diagnosis.allowed = findings.noise;
  if (const std::optional<NamedLaw> named = name_single_joint(study, diagnosis.noise, diagnosis.cause)) {
    diagnosis.shrink = named->shrink;
    diagnosis.allowed = named->allowed;
  }
  share_with_class(diagnosis.cause);
  if (diagnosis.cause.verdict == CauseVerdict::unknown || diagnosis.cause.reservation != Reservation::none)
    offer_law_to(study, chosen, diagnosis);
  offer_only_what_predicts(diagnosis);
  diagnosis.not_excited = not_excited(study, chosen, diagnosis.cause);
  if (diagnosis.cause.verdict != CauseVerdict::unknown)
    diagnosis.estimates =
        estimate(study, diagnosis.cause.ranking[diagnosis.cause.best].hypothesis.fit, diagnosis.allowed);
}

/// The best explanation and those that cannot be told apart from it.
std::vector<Fit> rivals(const Cause& cause) {
  std::vector<Fit> fits{cause.ranking[cause.best].hypothesis.fit};
  for (const std::size_t place : cause.equivalent) fits.push_back(cause.ranking[place].hypothesis.fit);
  return fits;
}

/// What the next run is to tell apart: the class that these runs leave; on request, where they leave none,
/// the most probable two.
std::vector<Fit> to_separate(const Cause& cause, bool on_request) {
  if (cause.verdict == CauseVerdict::ambiguous && !cause.equivalent.empty()) return rivals(cause);
  if (!on_request || cause.ranking.size() < 2) return {};
  const std::size_t other = cause.best == 0 ? 1 : 0;
  return {cause.ranking[cause.best].hypothesis.fit, cause.ranking[other].hypothesis.fit};
}

Aim aim_of(const Cause& cause) {
  const bool hardly_shown =
      cause.reservation == Reservation::not_tested || cause.reservation == Reservation::small_gap;
  return hardly_shown ? Aim::detect : Aim::discriminate;
}

/// Shares of the joints where nothing measured shows them: from what was found, else by the best torque law.
void imply_joints(const Study& study, const std::vector<double>& residual, Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  if (!diagnosis.where.joints.empty()) return;
  if (cause.verdict != CauseVerdict::identified && cause.verdict != CauseVerdict::ambiguous) {
    diagnosis.where.joints = shares_by_torque_law(study, residual, diagnosis.noise);
    diagnosis.where.joint_evidence = JointEvidence::implied_by_law;
    return;
  }
  std::vector<double> probability{cause.ranking[cause.best].probability};
  for (const std::size_t place : cause.equivalent) probability.push_back(cause.ranking[place].probability);
  diagnosis.where.joints = shares_by_fits(study, rivals(cause), probability);
  diagnosis.where.joint_evidence = JointEvidence::implied_by_fits;
}

}  // namespace

Diagnosis diagnose(const Study& study, const Report& progress, bool plan) {
  const Report report = progress ? progress : [](double) {};
  require_reached(study);
  const std::vector<double> residual = study.nominal_residual();
  Diagnosis diagnosis;
  diagnosis.experiment = study.experiment().name;
  diagnosis.gap = ask_for_gap(study, residual);
  diagnosis.allowed = diagnosis.noise = diagnosis.gap.test.noise;
  if (diagnosis.gap.present) explain(study, diagnosis, report, Hears::hum);
  diagnosis.where = locate(study, study.nominal(), residual, diagnosis.noise);
  imply_joints(study, residual, diagnosis);
  if (diagnosis.gap.present && diagnosis.cause.verdict == CauseVerdict::unknown)
    diagnosis.missing = describe_missing(study, residual, diagnosis.where);
  if (const std::vector<Fit> fits = to_separate(diagnosis.cause, plan); fits.size() > 1)
    diagnosis.proposals = next_runs(study, fits, diagnosis.allowed, 5, aim_of(diagnosis.cause));
  report(1);
  return diagnosis;
}

bool Diagnosis::may_hide_ripple() const {
  return !gap.present && std::any_of(gap.rms.begin(), gap.rms.end(), [&](const auto& measured) {
    return noise.of(measured.first) > beliefs::largest_hum;
  });
}

}  // namespace plumbline::diagnose
