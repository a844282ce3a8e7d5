#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnose/design/separation.hpp"
#include "diagnose/report/calibration_text.hpp"
#include "diagnose/report/law.hpp"
#include "diagnose/report/noise_text.hpp"
#include "diagnose/report/report.hpp"
#include "diagnose/report/sketch.hpp"
#include "diagnose/report/view.hpp"

namespace plumbline::diagnose {
namespace {

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// A ratio as a percentage with three figures.
std::string precise_percent(double ratio) {
  return fmt::format("{:.3g} %", 100 * ratio);
}

std::string by_channel(const std::map<Channel, double>& values) {
  std::string text;
  for (const auto& [channel, value] : values)
    text += fmt::format("{}{} {:.3g} {}", text.empty() ? "" : ", ", channel.label(), value, channel.unit());
  return text;
}

/// What the gap is one of.
const char* model(const Diagnosis& diagnosis) {
  return diagnosis.calibration ? "the calibrated arm" : "the nominal model";
}

std::string gap(const Diagnosis& diagnosis) {
  const GapAnswer& answer = diagnosis.gap;
  std::string text = fmt::format(
      "Is there a gap?  {} (probability of a gap {}): {} misses {} rms, chi-square per value {:.3g}\n",
      answer.present ? "Yes" : "No", probability_in_words(answer.probability), model(diagnosis),
      by_channel(answer.rms), answer.chi2_per_value);
  text += noise_as_text(diagnosis);
  if (!answer.taken_for_weights.empty())
    text += fmt::format("  all forces of {} point straight down without noise: assumed to be weights\n",
                        fmt::join(answer.taken_for_weights, ", "));
  for (const ContinuedRun& one : answer.continued)
    text += fmt::format("  {} goes on where {} ends, in time and command: read as one run\n",
                        fmt::join(one.by, ", "), one.run);
  for (const InterpolatedCovariate& one : answer.interpolated)
    text += fmt::format("  {} has no value at {} of {} readings of {}: interpolated in time\n", one.covariate,
                        one.count, one.of, one.run);
  for (const ThinnedRun& one : answer.thinned)
    text += fmt::format("  of the {} readings of {} {} are used\n", one.of, one.run, one.count);
  for (const OtherBranch& one : answer.other_branch)
    text += fmt::format(
        "  from reading {} of {} on the chain is on the other post-critical branch, which imperfections "
        "choose; the model is started on the same one\n",
        one.reading, one.run);
  return text;
}

template <class Share, class Name>
std::string largest(const std::vector<Share>& shares, std::size_t count, Name name) {
  std::vector<Share> sorted = shares;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Share& a, const Share& b) { return a.share > b.share; });
  std::string text;
  for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i)
    if (i == 0 || sorted[i].share >= 0.01)
      text += fmt::format("{}{} {}", i > 0 ? ", " : "", name(sorted[i]), percent(sorted[i].share));
  return text;
}

std::string where(const Diagnosis& diagnosis) {
  const Where& places = diagnosis.where;
  std::string text = "Where?  Shares of the squared residual above noise\n";
  text += "  channels: " + largest(places.channels, 4, [](const auto& one) { return one.channel.label(); }) +
          "\n";
  text += "  runs:     " + largest(places.runs, 4, [](const auto& one) { return one.run; }) + "\n";
  if (!places.load_path.empty())
    text += "  path:     " +
            largest(places.load_path, 3,
                    [](const PathShare& one) {
                      return fmt::format("{} readings {}-{} ({})", one.run, one.from, one.to,
                                         regime_word(one.regime));
                    }) +
            "\n";
  if (!places.joints.empty())
    text += "  joints:   " +
            largest(places.joints, 4, [](const JointShare& one) { return std::to_string(one.joint); }) +
            " (" + joint_evidence_words(places.joint_evidence) + ")\n";
  return text;
}

/// "tau_c = 0.035 N m (95 %: 0.0347 to 0.0353)"; equal bounds mean that none were found.
std::string parameter(const Estimate& one) {
  const std::string unit = one.unit == "ratio" ? "" : " " + one.unit;
  const std::string bounds = one.low < one.high ? fmt::format("95 %: {:.4g} to {:.4g}", one.low, one.high)
                                                : std::string("no bounds found");
  return fmt::format("{} = {:.4g}{} ({}{})", one.name, one.value, unit, bounds,
                     one.at_bound ? "; at its bound" : "");
}

std::string parameters(const Diagnosis& diagnosis) {
  std::string text;
  for (const EstimatedEffect& effect : estimated_effects(diagnosis)) {
    text += fmt::format("  {}: {}\n", effect.at.name(), effect.at.in_words());
    for (const Estimate& one : effect.values) text += "    " + parameter(one) + "\n";
  }
  return text;
}

/// Names, or a count where there are many.
std::string not_excited(const Diagnosis& diagnosis) {
  constexpr std::size_t few = 6;
  const std::vector<EffectAt>& all = diagnosis.not_excited;
  if (all.empty()) return "";
  std::vector<std::string> names;
  for (const EffectAt& at : all) names.push_back(at.name());
  return "  not excited by these runs, so neither found nor excluded: " +
         (all.size() <= few ? joined(names, ", ", ", ")
                            : fmt::format("{} effects (--json: cause.not_excited)", all.size())) +
         "\n";
}

/// What is sure of single effects where the cause is not.
std::string parts(const Cause& cause) {
  std::string text;
  for (std::size_t i = 0; i < told_effects(cause); ++i)
    text += fmt::format("  {} is part of it with probability {}\n",
                        effect_in_words(cause, cause.effects[i].label),
                        probability_in_words(cause.effects[i].probability));
  return text;
}

/// What the leading cause leaves, and what stands beside it.
std::string beside(const Cause& cause) {
  std::string text;
  if (shows_tolerances(cause.ranking.front())) text += "  manufacturing tolerances show beside it\n";
  if (cause.discrepancy > 0)
    text += fmt::format(
        "  model discrepancy: {:.2g} {} at the joints, {} of the nominal residual beside the noise\n",
        cause.discrepancy_torque, cause.torque_unit, percent(cause.discrepancy));
  return text;
}

std::string missing(const Diagnosis& diagnosis) {
  if (!diagnosis.missing) return "";
  const Missing& missing = *diagnosis.missing;
  return fmt::format(
             "  variance of {} explained by {}: {}; by its direction of motion too: {}; by time too: {}\n",
             missing.what, missing.against, percent(missing.by_position), percent(missing.by_direction),
             percent(missing.by_time)) +
         picture(missing);
}

std::string leading(const RankedCause& best) {
  return fmt::format("{} (probability {}, chi-square per value {:.3g})\n", best.cause.name(),
                     probability_in_words(best.probability), best.chi2_per_value);
}

std::string verdict_in_words(const Cause& cause) {
  if (cause.verdict == CauseVerdict::partial) return cause.rest->share < 0.5 ? "Mostly" : "In part";
  if (cause.too_few_readings) return "Too few readings to tell";
  return cause.verdict == CauseVerdict::identified ? "Identified" : "Ambiguous";
}

std::string unexplained(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  std::string text = fmt::format("What?  Unknown: a cause outside the catalogue has probability {}\n",
                                 probability_in_words(cause.unknown));
  text += missing(diagnosis);
  if (!cause.ranking.empty())
    text += (diagnosis.fails_to_predict ? "  fails to predict held-out readings: "
                                        : "  best partial explanation: ") +
            leading(cause.ranking.front()) + beside(cause);
  return text + parts(cause);
}

std::string explained(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  std::string text = fmt::format("What?  {}: ", verdict_in_words(cause));
  text += leading(cause.ranking.front()) + parameters(diagnosis) + beside(cause);
  for (std::size_t i = 1; i < cause.named; ++i)
    text += fmt::format("  or {} (probability {})\n", cause.ranking[i].cause.name(),
                        probability_in_words(cause.ranking[i].probability));
  text += fmt::format("  {}a cause outside the catalogue {}\n", cause.or_unknown ? "or " : "",
                      cause.or_unknown ? fmt::format("(probability {})", probability_in_words(cause.unknown))
                                       : "has probability " + probability_in_words(cause.unknown));
  if (cause.rest)
    text += fmt::format("  it leaves {} of the residual, noise alone {}: {}\n", percent(cause.rest->share),
                        percent(cause.rest->noise_floor), cause.rest->why);
  if (cause.too_few_readings) text += "  too few readings to tell it from a cause outside the catalogue\n";
  return text + parts(cause);
}

std::string what(const Diagnosis& diagnosis) {
  return (diagnosis.cause.is_explained() ? explained(diagnosis) : unexplained(diagnosis)) +
         (diagnosis.law ? law_as_text(*diagnosis.law) : "") + not_excited(diagnosis);
}

std::string outliers(const Shrink& shrink) {
  if (shrink.outliers == 0) return "";
  return fmt::format("  {} outlier{} of the held-out values excluded; with {} {:.3g}\n", shrink.outliers,
                     shrink.outliers == 1 ? "" : "s", shrink.outliers == 1 ? "it" : "them",
                     shrink.ratio_with_outliers);
}

/// "4 runs, in turn", "18 blocks of readings, in turn".
std::string heldout(const Shrink& shrink) {
  const bool blocks = std::any_of(shrink.heldout.begin(), shrink.heldout.end(), [](const std::string& name) {
    return name.find('[') != std::string::npos;
  });
  const std::size_t count = shrink.heldout.size();
  return fmt::format("{} {}{}{}", count, blocks ? "block" : "run", count == 1 ? "" : "s",
                     count == 1 ? "" : ", in turn");
}

std::string how_far(const Diagnosis& diagnosis) {
  if (!diagnosis.shrink) return "How far?  Not tested: too few readings to hold some out of the fit\n";
  const Shrink& shrink = *diagnosis.shrink;
  if (!shrink.tested())
    return fmt::format(
        "How far?  Not tested: noise is {} of the residual in the held-out readings ({}), too little of the "
        "gap is left\n",
        percent(shrink.noise_floor_ratio), heldout(shrink));
  return fmt::format(
      "How far?  On held-out readings ({}), {} leaves {:.3g} of the residual (95 %: {:.3g} to {:.3g}; noise "
      "floor {:.3g})\n"
      "  rms before: {}\n"
      "  rms after:  {}\n{}",
      heldout(shrink), tested_model(diagnosis), shrink.ratio, shrink.ratio_low, shrink.ratio_high,
      shrink.noise_floor_ratio, by_channel(shrink.rms_before), by_channel(shrink.rms_after),
      outliers(shrink));
}

std::string odds(double log_odds) {
  return log_odds > 14 ? "over a million to one" : fmt::format("{:.3g} to one", std::exp(log_odds));
}

std::string what_next(const Diagnosis& diagnosis) {
  if (diagnosis.proposals.empty()) return "";
  std::string text =
      "What next?  The runs that best distinguish the explanations, with the expected odds for the true "
      "one\n";
  for (const Proposal& one : diagnosis.proposals)
    text += fmt::format("  {}: {}\n", one.description, odds(one.log_odds));
  if (const double so_far = diagnosis.proposals.front().log_odds_so_far; so_far > told_apart)
    text += fmt::format("  (for the runs so far the same forecast gives {})\n", odds(so_far));
  return text;
}

/// The values of the best explanation, where they are few.
std::string few_values(const Diagnosis& diagnosis) {
  constexpr std::size_t few = 4;
  std::size_t count = 0;
  std::string text;
  const std::vector<EstimatedEffect> effects = estimated_effects(diagnosis);
  for (const EstimatedEffect& effect : effects)
    for (const Estimate& one : effect.values) {
      ++count;
      text += "  " + (effects.size() > 1 ? effect.at.name() + ": " : "") + parameter(one) + "\n";
    }
  return count <= few ? text : "";
}

std::string answer(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  if (!diagnosis.gap.present)
    return fmt::format("No gap: {} fits the readings to within noise of {} times the declared one\n",
                       model(diagnosis), noise_scales(diagnosis.noise));
  if (diagnosis.fails_to_predict)
    return fmt::format("Unknown: the most probable cause, {}, fails to predict held-out readings\n",
                       in_words(cause.ranking.front().cause));
  if (!cause.is_explained())
    return fmt::format("Unknown: the cause is outside the catalogue with probability {}\n",
                       probability_in_words(cause.unknown));
  std::string text = verdict_in_words(cause) + ": " + in_words(cause.ranking.front().cause);
  if (cause.rest)
    text += fmt::format(" (part of it with {}); {}", probability_in_words(cause.ranking.front().probability),
                        cause.rest->why);
  const std::size_t others = cause.named - 1 + (cause.or_unknown ? 1 : 0);
  if (others == 1) text += ", or the alternative below";
  if (others > 1) text += fmt::format(", or one of {} alternatives below", others);
  if (outside_is_likelier(cause)) text += ", a cause outside the catalogue the most probable of all";
  return text + "\n" + few_values(diagnosis);
}

/// The names of the joints that the explanations have.
std::string names_of_joints(const Diagnosis& diagnosis) {
  std::set<std::size_t> named;
  for (std::size_t i = 0; i < diagnosis.cause.named; ++i)
    for (const EffectAt& at : diagnosis.cause.ranking[i].cause.effects)
      if (at.joint > 0 && at.joint <= diagnosis.joints.size()) named.insert(at.joint);
  std::vector<std::string> words;
  for (const std::size_t joint : named)
    words.push_back(fmt::format("joint {} is {}", joint, diagnosis.joints[joint - 1]));
  return words.empty() ? "" : "  " + joined(words, ", ", ", ") + "\n";
}

/// The answer in a few lines, with what it rests on.
std::string headline(const Diagnosis& diagnosis) {
  std::string text = answer(diagnosis) + names_of_joints(diagnosis);
  if (diagnosis.calibration)
    text += fmt::format("  calibration removes {}{}\n", tolerances_in_words(*diagnosis.calibration),
                        diagnosis.gap.present ? " beside it" : "");
  if (diagnosis.assumed_density > 0)
    text += fmt::format("  the model has no masses: compliances are told for links of {:g} kg/m\n",
                        diagnosis.assumed_density);
  if (const auto& shrink = diagnosis.shrink; shrink && shrink->tested() && shrink->ratio < 1)
    text += fmt::format("  {} leaves {} of the held-out residual; noise alone {}\n", tested_model(diagnosis),
                        precise_percent(shrink->ratio), precise_percent(shrink->noise_floor_ratio));
  if (const std::string outliers = outliers_in_words(diagnosis.gap.outliers); !outliers.empty())
    text += "  " + outliers + "\n";
  return text;
}

}  // namespace

std::string values_as_text(const Diagnosis& diagnosis) {
  return few_values(diagnosis);
}

std::string questions_as_text(const Diagnosis& diagnosis) {
  const std::string gap_or_none =
      gap(diagnosis) + (diagnosis.calibration ? "\n" + calibration_as_text(*diagnosis.calibration) : "");
  if (!diagnosis.gap.present) return gap_or_none;
  return gap_or_none + "\n" + where(diagnosis) + "\n" + what(diagnosis) + "\n" + how_far(diagnosis) +
         (diagnosis.proposals.empty() ? "" : "\n" + what_next(diagnosis));
}

std::string as_text(const Diagnosis& diagnosis) {
  return diagnosis.experiment + "\n\n" + headline(diagnosis) + "\n" + questions_as_text(diagnosis);
}

}  // namespace plumbline::diagnose
