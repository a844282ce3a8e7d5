#include "diagnose/answers/diagnosis.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/answers/implied_shares.hpp"
#include "diagnose/answers/in_part.hpp"
#include "diagnose/decision/cross_validation.hpp"

namespace plumbline::diagnose {
namespace {

void require_reached(const Study& study) {
  if (study.nominal().reached) return;
  if (study.experiment().arm)
    throw Error("experiment \"" + study.experiment().name + "\"",
                "loads under which the nominal arm does not hold its poses",
                "joints and links that are stiffer than their loads");
  const std::vector<Run>& runs = study.experiment().runs;
  if (!study.experiment().has_links())
    throw Error("experiment \"" + study.experiment().name + "\"",
                "readings that the nominal joint cannot follow",
                "a stiffness under which the joint holds every load");
  if (study.experiment().link_length.size() == 1 &&
      std::any_of(runs.begin(), runs.end(), [](const Run& run) { return run.holds_end_point(); }))
    throw Error("experiment \"" + study.experiment().name + "\"",
                "a single link whose end point is imposed, which pulls along the link with any force",
                "runs under a force, or a second link that turns freely to carry the force");
  throw Error("experiment \"" + study.experiment().name + "\"", "runs that the nominal chain cannot follow",
              "end points within reach and a stable posture at every reading");
}

/// Effects that no measured value shows; and what the user stated of time, or of readings, that this bench
/// has not.
std::vector<EffectAt> not_excited(const Study& study, const Findings& findings) {
  std::vector<EffectAt> result = findings.not_excited;
  const std::vector<EffectAt> possible = possible_effects(study);
  if (!study.experiment().stated) return result;
  for (const Effect& row : *study.experiment().stated) {
    if (std::none_of(possible.begin(), possible.end(), [&](const EffectAt& at) { return at.effect == &row; }))
      result.emplace_back(row);
  }
  return result;
}

/// What the next run is to tell apart; nothing beside a calibration, whose tolerances forecasts do not know:
/// the class that these runs leave; on request, where they leave none, the most probable two.
std::vector<Hypothesis> to_separate(const Study& study, const Cause& cause, bool on_request) {
  if (study.experiment().arm_bench.calibration) return {};
  std::size_t count = cause.is_explained() && cause.named > 1 ? cause.named : on_request ? 2 : 0;
  std::vector<Hypothesis> hypotheses;
  for (std::size_t i = 0; i < std::min(count, cause.ranking.size()); ++i)
    hypotheses.push_back(cause.ranking[i].hypothesis);
  return hypotheses;
}

/// Shares of the joints where nothing measured shows them: from what was found, else from unknown torques.
void imply_joints(const Study& study, const Findings& findings, const Cause& cause, Where& where) {
  if (!where.joints.empty()) return;
  if (!cause.is_explained()) {
    where.joints = shares_by_unknown_torques(study, findings);
    where.joint_evidence = JointEvidence::implied_by_law;
    return;
  }
  const std::vector<RankedCause> named(cause.ranking.begin(),
                                       cause.ranking.begin() + static_cast<std::ptrdiff_t>(cause.named));
  const bool arm = study.experiment().arm != nullptr;
  where.joints = arm ? shares_by_names(study, named) : shares_by_causes(study, named);
  where.joint_evidence = arm ? JointEvidence::named_by_fits : JointEvidence::implied_by_fits;
}

/// Tests the leading cause on readings that its fit has not seen. It is dropped where it surely predicts no
/// better than the nominal model.
void test_cause(const Study& study, const Findings& findings, Diagnosis& diagnosis) {
  Cause& cause = diagnosis.cause;
  if (cause.ranking.empty()) return;
  diagnosis.shrink = cross_validated(study, findings, diagnosis.noise, cause.ranking.front().hypothesis);
  if (!cause.is_explained() || !diagnosis.shrink || !diagnosis.shrink->fails()) return;
  diagnosis.fails_to_predict = true;
  cause.verdict = CauseVerdict::unknown;
  cause.named = 0;
  cause.or_unknown = false;
}

/// Where the cause may be outside of the catalogue: a law that closes the gap, if one predicts.
void offer_law_to(const Study& study, Diagnosis& diagnosis) {
  std::optional<OfferedLaw> law = offer_law(study, diagnosis.noise);
  if (!law || (law->shrink && law->shrink->ratio_high >= 1)) return;
  const bool predicts_worse = diagnosis.shrink && law->shrink && law->shrink->ratio > diagnosis.shrink->ratio;
  if (predicts_worse) return;
  diagnosis.law = std::move(law);
  if (diagnosis.offers_law()) diagnosis.shrink = diagnosis.law->shrink;
}

/// A cause that is named may be only a part.
void look_for_rest(Diagnosis& diagnosis) {
  Cause& cause = diagnosis.cause;
  if (cause.verdict != CauseVerdict::identified) return;
  cause.rest =
      rest_of(cause.ranking.front(), diagnosis.noise, diagnosis.shrink, diagnosis.gap.chi2_per_value);
  if (cause.rest) cause.verdict = CauseVerdict::partial;
}

/// A cause that is unknown may be known in part. The law closes the gap then, or the part by itself where
/// that predicts better.
void look_for_parts(const Study& study, const Findings& findings, const Posterior& posterior,
                    Diagnosis& diagnosis) {
  Cause& cause = diagnosis.cause;
  if (cause.verdict != CauseVerdict::unknown || diagnosis.fails_to_predict) return;
  std::optional<InPart> found = in_part(study, findings, posterior, diagnosis.noise);
  if (!found) return;
  const bool predicts = found->shrink && found->shrink->ratio_high < 1;
  if (!predicts && !diagnosis.offers_law()) return;
  if (predicts && !(diagnosis.offers_law() && diagnosis.law->shrink->ratio < found->shrink->ratio))
    diagnosis.law.reset(), diagnosis.shrink = found->shrink;
  cause.verdict = CauseVerdict::partial;
  cause.named = found->causes.size();
  cause.rest = std::move(found->rest);
  std::erase_if(cause.ranking, [&](const RankedCause& one) {
    return std::any_of(found->causes.begin(), found->causes.end(),
                       [&](const RankedCause& part) { return part.cause == one.cause; });
  });
  cause.ranking.insert(cause.ranking.begin(), std::make_move_iterator(found->causes.begin()),
                       std::make_move_iterator(found->causes.end()));
}

void explain(const Study& study, const Findings& findings, const Posterior& posterior, Diagnosis& diagnosis) {
  test_cause(study, findings, diagnosis);
  look_for_rest(diagnosis);
  const Cause& cause = diagnosis.cause;
  if (cause.verdict == CauseVerdict::unknown || cause.or_unknown) offer_law_to(study, diagnosis);
  look_for_parts(study, findings, posterior, diagnosis);
  diagnosis.not_excited = not_excited(study, findings);
  if (cause.is_explained())
    diagnosis.estimates = estimate(study, cause.ranking.front().hypothesis, posterior.temper);
}

}  // namespace

Diagnosis diagnose(const Study& study, const std::function<void(double)>& progress, bool plan) {
  const auto report = [&](double share) {
    if (progress) progress(share);
  };
  require_reached(study);
  const Findings findings = search(study, [&](double share) { report(0.8 * share); });
  const Posterior posterior = diagnose::posterior(study, findings);
  const bool gap = decide(posterior).verdict != CauseVerdict::none;
  const VectorXd residual =
      gap && !findings.hypotheses.empty() ? findings.hypotheses.front().residual : study.nominal_residual();
  const Decomposition parts = findings.likelihood->decompose(residual);
  const Cause cause = judge(study, findings, posterior, parts.noise);
  Diagnosis diagnosis{study.experiment().name,
                      describe_gap(study, parts.noise, residual - parts.delta - parts.periodic),
                      locate(study, parts.noise),
                      cause,
                      parts.noise,
                      {},
                      {},
                      {},
                      false,
                      {},
                      {},
                      {}};
  diagnosis.joints = study.experiment().joint_names();
  diagnosis.calibration = study.experiment().arm_bench.calibration;
  diagnosis.assumed_density = study.experiment().arm_bench.assumed_density;
  diagnosis.gap.present = gap;
  diagnosis.gap.probability = 1 - posterior.no_gap;
  diagnosis.gap.log_odds = posterior.log_odds_of_gap;
  diagnosis.gap.seen = posterior.seen_gap;
  if (gap) explain(study, findings, posterior, diagnosis);
  report(0.9);
  imply_joints(study, findings, diagnosis.cause, diagnosis.where);
  if (diagnosis.cause.verdict == CauseVerdict::unknown)
    diagnosis.missing = describe_missing(study, diagnosis.noise, diagnosis.where);
  const Aim aim = diagnosis.shrink && diagnosis.shrink->tested() ? Aim::discriminate : Aim::detect;
  if (const std::vector<Hypothesis> hypotheses = to_separate(study, diagnosis.cause, plan && gap);
      hypotheses.size() > 1)
    diagnosis.proposals = next_runs(study, hypotheses, diagnosis.noise, 5, aim);
  report(1);
  return diagnosis;
}

}  // namespace plumbline::diagnose
