#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "diagnose/beliefs.hpp"
#include "diagnose/report/law.hpp"
#include "diagnose/report/noise_text.hpp"
#include "diagnose/report/report.hpp"
#include "diagnose/report/sketch.hpp"
#include "diagnose/report/view.hpp"
#include "support/page/markup.hpp"

namespace plumbline::diagnose {
namespace {

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Of a ratio, with three figures.
std::string precise_percent(double ratio) {
  return fmt::format("{:.3g} %", 100 * ratio);
}

std::string by_channel(const std::map<Channel, double>& values) {
  std::string text;
  for (const auto& [channel, value] : values)
    text += fmt::format("{}{} {:.3g} {}", text.empty() ? "" : ", ", channel.label(), value, channel.unit());
  return text;
}

std::string gap(const Diagnosis& diagnosis) {
  const GapAnswer& answer = diagnosis.gap;
  std::string text =
      fmt::format("Is there a gap?  {} ({}): the nominal model misses {} rms, chi-square per value {:.3g}\n",
                  answer.present ? "Yes" : "No", page::p_value(answer.test.p_value), by_channel(answer.rms),
                  answer.chi2_per_value);
  text += noise_as_text(diagnosis);
  if (!answer.taken_for_weights.empty())
    text += fmt::format("  all forces of {} point straight down without noise: assumed to be weights\n",
                        fmt::join(answer.taken_for_weights, ", "));
  for (const OtherBranch& one : answer.other_branch)
    text += fmt::format(
        "  from reading {} of {} on the chain is on the other post-critical branch, which imperfections "
        "choose; "
        "the model is started on the same one\n",
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
  text += "  path:     " +
          largest(places.load_path, 3,
                  [](const PathShare& one) {
                    return fmt::format("{} readings {}-{} ({})", one.run, one.from, one.to,
                                       regime_word(one.regime));
                  }) +
          "\n";
  text += "  joints:   " +
          largest(places.joints, 4, [](const JointShare& one) { return std::to_string(one.joint); }) + " (" +
          joint_evidence_words(places.joint_evidence) + ")\n";
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
  const Candidate& candidate = diagnosis.cause.ranking[diagnosis.cause.best].hypothesis.fit.candidate;
  for (std::size_t e = 0; e < candidate.effects.size(); ++e) {
    const EffectAt& at = candidate.effects[e];
    text += fmt::format("  {}: {}\n", at.name(), at.in_words());
    for (const Estimate& one : diagnosis.estimates[e]) text += "    " + parameter(one) + "\n";
  }
  return text;
}

/// Names, or a count where there are many.
std::string listed(const std::vector<std::string>& names, const char* what, const char* key) {
  constexpr std::size_t few = 6;
  return names.size() <= few ? fmt::format("{}", fmt::join(names, ", "))
                             : fmt::format("{} {} (--json: {})", names.size(), what, key);
}

std::string not_excited(const Diagnosis& diagnosis) {
  if (diagnosis.not_excited.empty()) return "";
  std::vector<std::string> names;
  for (const EffectAt& at : diagnosis.not_excited) names.push_back(at.name());
  return "  not excited by these runs, so neither found nor excluded: " +
         listed(names, "effects", "cause.not_excited") + "\n";
}

std::string unexplained(const Diagnosis& diagnosis) {
  std::string text = "What?  Unknown: no one or two effects of the catalogue explain the gap\n";
  if (diagnosis.missing) {
    const Missing& missing = *diagnosis.missing;
    text += fmt::format(
        "  variance of {} explained by {}: {}; by its direction of motion too: {}; by time too: {}\n",
        missing.what, missing.against, percent(missing.by_position), percent(missing.by_direction),
        percent(missing.by_time));
    text += picture(missing);
  }
  if (!diagnosis.cause.ranking.empty()) {
    const Ranked& partial = diagnosis.cause.ranking[diagnosis.cause.best];
    text += fmt::format("  best partial explanation: {} (chi-square per degree of freedom {:.3g})\n",
                        partial.hypothesis.fit.candidate.name(), partial.chi2_per_dof);
  }
  if (diagnosis.law) text += law_as_text(*diagnosis.law);
  return text + not_excited(diagnosis);
}

/// The most probable alternatives, one a line, and the number of the others.
std::string alternatives(const Cause& cause) {
  constexpr std::size_t lines = 6;
  std::vector<std::size_t> places = cause.equivalent;
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return cause.ranking[a].probability > cause.ranking[b].probability;
  });
  const std::size_t shown = places.size() <= lines + 1 ? places.size() : lines;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += "  or " + cause.ranking[places[i]].hypothesis.fit.candidate.name() + "\n";
  if (shown < places.size())
    text += fmt::format("  or one of {} less probable explanations (--json: cause.equivalent)\n",
                        places.size() - shown);
  return text;
}

std::string what(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  if (cause.verdict == CauseVerdict::unknown) return unexplained(diagnosis);
  const Ranked& best = cause.ranking[cause.best];
  std::string text =
      fmt::format("What?  {}: {} (probability {:.3f}, chi-square per degree of freedom {:.3g})\n",
                  cause.verdict == CauseVerdict::identified ? "Identified" : "Ambiguous",
                  best.hypothesis.fit.candidate.name(), best.probability, best.chi2_per_dof);
  text += parameters(diagnosis);
  if (cause.remainder > 0)
    text += fmt::format("  model discrepancy: {} of the gap remains on held-out readings\n",
                        percent(cause.remainder));
  text += alternatives(cause);
  text += fmt::format("  a cause outside the catalogue: probability {:.2g}\n", cause.unknown);
  if (cause.reservation != Reservation::none)
    text += "  caveat: " + reservation_words(cause.reservation) + "\n";
  if (diagnosis.law) text += law_as_text(*diagnosis.law);
  return text + not_excited(diagnosis);
}

/// The model whose residual reduction was measured.
std::string corrected_model(const Diagnosis& diagnosis) {
  if (diagnosis.offers_law()) return "the torque law";
  return diagnosis.cause.verdict == CauseVerdict::unknown ? "the best partial explanation" : "this cause";
}

std::string outliers(const Shrink& shrink) {
  if (shrink.left_out == 0) return "";
  return fmt::format("  {} outlier{} of the held-out values excluded; with {} {:.3g}\n", shrink.left_out,
                     shrink.left_out == 1 ? "" : "s", shrink.left_out == 1 ? "it" : "them",
                     shrink.ratio_with_left_out);
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
  if (diagnosis.nothing_predicts)
    return "How far?  No explanation predicts held-out readings better than the nominal model\n";
  if (!diagnosis.shrink) return "How far?  Not tested: too few readings to hold some out of the fit\n";
  const Shrink& shrink = *diagnosis.shrink;
  if (!shrink.tested())
    return fmt::format(
        "How far?  Not tested: noise is {} of the residual in the held-out readings ({}), too little of the "
        "gap is "
        "left\n",
        percent(shrink.noise_floor_ratio), heldout(shrink));
  return fmt::format(
      "How far?  On held-out readings ({}), {} leaves {:.3g} of the residual (95 %: {:.3g} to {:.3g}; noise "
      "floor "
      "{:.3g}){}\n"
      "  rms before: {}\n"
      "  rms after:  {}\n{}",
      heldout(shrink), corrected_model(diagnosis), shrink.ratio, shrink.ratio_low, shrink.ratio_high,
      shrink.noise_floor_ratio,
      shrink.chosen_blind ? ""
                          : "\n  optimistic: without these readings another explanation would be selected",
      by_channel(shrink.rms_before), by_channel(shrink.rms_after), outliers(shrink));
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
  if (const double so_far = diagnosis.proposals.front().log_odds_so_far; so_far > beliefs::told_apart)
    text += fmt::format("  (for the runs so far the same forecast gives {})\n", odds(so_far));
  return text;
}

/// The values of the best explanation, where they are few.
std::string few_values(const Diagnosis& diagnosis, const Candidate& best) {
  constexpr std::size_t few = 4;
  std::size_t count = 0;
  std::string text;
  for (std::size_t e = 0; e < diagnosis.estimates.size(); ++e)
    for (const Estimate& one : diagnosis.estimates[e]) {
      ++count;
      text += "  " + (best.effects.size() > 1 ? best.effects[e].name() + ": " : "") + parameter(one) + "\n";
    }
  return count <= few ? text : "";
}

/// The answer in a few lines.
std::string headline(const Diagnosis& diagnosis) {
  const Cause& cause = diagnosis.cause;
  if (!diagnosis.gap.present) return "No gap: the nominal model fits the readings to within their noise\n";
  std::string text = "Unknown: the catalogue has no explanation of the gap\n";
  if (cause.verdict != CauseVerdict::unknown) {
    const Candidate& best = cause.ranking[cause.best].hypothesis.fit.candidate;
    const std::size_t others = cause.equivalent.size() + (cause.reservation != Reservation::none ? 1 : 0);
    text = (cause.verdict == CauseVerdict::identified ? "Identified: " : "Ambiguous: ") + in_words(best);
    if (others > 0) text += fmt::format(", or one of {} alternative{} below", others, others > 1 ? "s" : "");
    text += "\n" + few_values(diagnosis, best);
  }
  if (const auto& shrink = diagnosis.shrink; shrink && shrink->tested() && shrink->ratio < 1)
    text += fmt::format("  {} leaves {} of the held-out residual; noise alone {}\n",
                        corrected_model(diagnosis), precise_percent(shrink->ratio),
                        precise_percent(shrink->noise_floor_ratio));
  return text;
}

}  // namespace

std::string as_text(const Diagnosis& diagnosis) {
  const std::string text = diagnosis.experiment + "\n\n" + headline(diagnosis) + "\n" + gap(diagnosis);
  if (!diagnosis.gap.present) return text;
  return text + "\n" + where(diagnosis) + "\n" + what(diagnosis) + "\n" + how_far(diagnosis) +
         (diagnosis.proposals.empty() ? "" : "\n" + what_next(diagnosis));
}

}  // namespace plumbline::diagnose
