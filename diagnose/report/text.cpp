#include <fmt/format.h>

#include <algorithm>

#include "diagnose/beliefs.hpp"
#include "diagnose/report/law.hpp"
#include "diagnose/report/report.hpp"
#include "diagnose/report/sketch.hpp"
#include "support/page/markup.hpp"

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

std::string by_channel(const std::map<Channel, double>& values) {
  std::string text;
  for (const auto& [channel, value] : values)
    text += fmt::format("{}{} {:.3g} {}", text.empty() ? "" : ", ", channel.label(), value, channel.unit());
  return text;
}

/// "0.12", or by sensor where these differ: "0.85 (force), 0.02 (angle)".
std::string correlations(const NoiseModel& noise, const std::map<Channel, double>& measured) {
  std::map<Sensor, std::string> by_sensor;
  for (const auto& [channel, rms] : measured)
    by_sensor[channel.sensor()] = fmt::format("{:.2f}", noise.correlation_of(channel));
  const std::string& first = by_sensor.begin()->second;
  if (std::all_of(by_sensor.begin(), by_sensor.end(), [&](const auto& one) { return one.second == first; }))
    return first;
  std::string text;
  for (const auto& [sensor, value] : by_sensor)
    text += (text.empty() ? "" : ", ") + value + " (" + label(sensor) + ")";
  return text;
}

/// "3.0", "0.033".
std::string times(double scale) {
  return scale < 1 ? fmt::format("{:.2g}", scale) : fmt::format("{:.1f}", scale);
}

/// How the noise compares with the declared; said in words where it is another.
std::string scatter(const NoiseModel& noise, const std::map<Channel, double>& measured) {
  std::string text = "  noise over declared:", words;
  for (const Name name : {Name::x, Name::y, Name::Fx, Name::Fy, Name::q}) {
    const auto carries = [&](const auto& one) { return one.first.name == name; };
    if (std::none_of(measured.begin(), measured.end(), carries)) continue;
    const double scale = noise.of({name});
    text +=
        " " + label(name) + (scale < 0.1 ? fmt::format(" {:.2g},", scale) : fmt::format(" {:.2f},", scale));
    if (scale > 1.5 || scale < 1 / 1.5)
      words +=
          fmt::format("  the readings of {} scatter {} times what was declared\n", label(name), times(scale));
  }
  text.back() = ';';
  return text + " neighbours correlate by " + correlations(noise, measured) + "\n" + words;
}

/// Channels of a run that hum together in one line.
std::string hum_in_words(const std::vector<HummingChannel>& hum) {
  std::string text;
  for (auto first = hum.begin(); first != hum.end();) {
    const auto end = std::find_if(first, hum.end(), [&](const HummingChannel& one) {
      return one.run != first->run || std::abs(one.period - first->period) > 0.05 * first->period;
    });
    std::vector<std::string> channels;
    double loudest = 0;
    for (auto one = first; one != end; ++one)
      channels.push_back(one->channel.label()), loudest = std::max(loudest, one->rms);
    text +=
        fmt::format("  {} of {} {} every {:.2g} readings, {}{:.1f} declared sigmas rms: taken for noise\n",
                    fmt::join(channels, ", "), first->run, channels.size() > 1 ? "hum" : "hums",
                    first->period, channels.size() > 1 ? "up to " : "", loudest);
    first = end;
  }
  return text;
}

std::string gap(const Diagnosis& diagnosis) {
  const GapAnswer& answer = diagnosis.gap;
  const NoiseModel& noise = diagnosis.noise;
  std::string text =
      fmt::format("Is there a gap?  {} ({}; chi-square per value {:.3g}; rms {})\n",
                  answer.present ? "Yes" : "No, the nominal model explains the readings to the noise",
                  page::p_value(answer.test.p_value), answer.chi2_per_value, by_channel(answer.rms));
  text += scatter(noise, answer.rms);
  if (diagnosis.may_hide_ripple())
    text +=
        "  so much that a ripple of the device finer than the readings may hide in it: measure in smaller "
        "steps\n";
  for (const auto& [name, share] : answer.proportional)
    text += fmt::format("  the readings of {} scatter by a further {:.2g} % of themselves\n", label(name),
                        100 * share);
  for (const auto& [channel, times] : answer.uneven)
    text += fmt::format("  the readings of {} scatter {:.1f} times as much as those of the other joints\n",
                        channel.label(), times);
  for (const RougherRun& one : answer.rougher)
    text += fmt::format("  {} readings of {} scatter {:.1f} times as much as those of the other runs\n",
                        label(one.sensor), one.run, one.times);
  for (const RougherStretch& one : answer.rougher_stretches)
    text += fmt::format("  {} readings {}-{} of {} scatter {:.1f} times as much as elsewhere\n",
                        label(one.sensor), one.from, one.to, one.run, one.times);
  if (!answer.taken_for_weights.empty())
    text += fmt::format("  the forces of {} point straight down and have no noise: taken for weights\n",
                        fmt::join(answer.taken_for_weights, ", "));
  for (const OtherBranch& one : answer.other_branch)
    text += fmt::format(
        "  from reading {} of {} on the chain is where its imperfections sent it, half a degree of a rest "
        "angle deciding: so is the model\n",
        one.reading, one.run);
  return text + hum_in_words(answer.hum);
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
  std::string text = "Where?  shares of the squared residual beyond noise\n";
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
          largest(places.joints, 4, [](const JointShare& one) { return std::to_string(one.joint); }) + " " +
          joint_evidence_words(places.joint_evidence) + "\n";
  return text;
}

/// "tau_c = 0.035 N m (95 %: 0.0347 to 0.0353)"; bounds that no profile told apart are none.
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
    text += fmt::format("  {}, {}\n", at.name(), at.in_words());
    for (const Estimate& one : diagnosis.estimates[e]) text += "    " + parameter(one) + "\n";
  }
  return text;
}

std::string not_excited(const Diagnosis& diagnosis) {
  std::string idle;
  for (const EffectAt& at : diagnosis.not_excited) idle += (idle.empty() ? "" : ", ") + at.name();
  if (idle.empty()) return "";
  return "  neither excluded nor blamed, for the runs never exercise them: " + idle + "\n";
}

std::string unexplained(const Diagnosis& diagnosis) {
  std::string text = "What?  Unknown: no effect of the catalogue, alone or in twos, explains the gap\n";
  if (diagnosis.missing) {
    const Missing& missing = *diagnosis.missing;
    text += fmt::format("  what is missing, as a function of {}: {}; of direction too: {}; of time too: {}\n",
                        missing.against, percent(missing.by_position), percent(missing.by_direction),
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

/// What cannot be told apart from the best: the most probable a line each, the rest together.
std::string others_alike(const Cause& cause) {
  constexpr std::size_t lines = 6;
  const auto label = [&](std::size_t place) { return cause.ranking[place].hypothesis.fit.candidate.name(); };
  std::vector<std::size_t> places = cause.equivalent;
  std::stable_sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) {
    return cause.ranking[a].probability > cause.ranking[b].probability;
  });
  const std::size_t shown = places.size() <= lines + 1 ? places.size() : lines;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += "  cannot be told apart from " + label(places[i]) + "\n";
  if (shown == places.size()) return text;
  text += fmt::format("  nor from {} less probable ones: ", places.size() - shown);
  for (std::size_t i = shown; i < places.size(); ++i) text += (i > shown ? " | " : "") + label(places[i]);
  return text + "\n";
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
    text += fmt::format("  with a remainder: {} of the gap is left on the readings held out\n",
                        percent(cause.remainder));
  text += fmt::format("  outside the catalogue with probability {:.2g}\n", cause.unknown);
  text += others_alike(cause);
  if (cause.reservation != Reservation::none)
    text += "  or a cause outside the catalogue: " + reservation_words(cause.reservation) + "\n";
  if (diagnosis.law) text += law_as_text(*diagnosis.law);
  return text + not_excited(diagnosis);
}

/// What the shrink was measured with.
std::string what_shrinks(const Diagnosis& diagnosis) {
  if (diagnosis.offers_law()) return "the torque law";
  return diagnosis.cause.verdict == CauseVerdict::unknown ? "the best partial explanation" : "this cause";
}

std::string left_out(const Shrink& shrink) {
  if (shrink.left_out == 0) return "";
  return fmt::format(
      "  without {} of the values held out, which stand{} off {} neighbours; with {}: {:.3g}\n",
      shrink.left_out, shrink.left_out == 1 ? "s" : "", shrink.left_out == 1 ? "its" : "their",
      shrink.left_out == 1 ? "it" : "them", shrink.ratio_with_left_out);
}

std::string how_far(const Diagnosis& diagnosis) {
  if (diagnosis.nothing_predicts)
    return "How far?  Nothing that was tried leaves less on readings held out than the nominal model\n";
  if (!diagnosis.shrink)
    return "How far?  Not tested: without readings held out too few are left to fit it\n";
  const Shrink& shrink = *diagnosis.shrink;
  std::string held;
  for (const std::string& name : shrink.heldout) held += (held.empty() ? "" : ", ") + name;
  if (!shrink.tested())
    return fmt::format(
        "How far?  Not tested: the readings held out ({}) carry too little of the gap, noise alone is {} of "
        "them\n",
        held, percent(shrink.noise_floor_ratio));
  return fmt::format(
      "How far?  On held-out readings ({}), with {}{}, the residual {} {:.3g} of itself (95 %: {:.3g} to "
      "{:.3g}; "
      "noise floor {:.3g})\n  rms before: {}\n  rms after:  {}\n{}",
      held, what_shrinks(diagnosis), shrink.chosen_blind ? "" : ", which without them would not be chosen",
      shrink.ratio < 1 ? "shrinks to" : "does not shrink, it becomes", shrink.ratio, shrink.ratio_low,
      shrink.ratio_high, shrink.noise_floor_ratio, by_channel(shrink.rms_before),
      by_channel(shrink.rms_after), left_out(shrink));
}

std::string odds(double log_odds) {
  return log_odds > 14 ? "over a million to one" : fmt::format("{:.3g} to one", std::exp(log_odds));
}

std::string what_next(const Diagnosis& diagnosis) {
  if (diagnosis.proposals.empty()) return "";
  const double so_far = diagnosis.proposals.front().log_odds_so_far;
  std::string text = "What next?  Runs that would tell the candidates apart, best first";
  if (so_far > beliefs::told_apart)
    text += fmt::format("; of the runs that there are the same forecast was {}", odds(so_far));
  text += "\n";
  for (const Proposal& one : diagnosis.proposals)
    text += fmt::format("  {}: expected odds {}\n", one.description, odds(one.log_odds));
  return text;
}

}  // namespace

std::string as_text(const Diagnosis& diagnosis) {
  std::string text = diagnosis.experiment + "\n\n" + gap(diagnosis);
  if (!diagnosis.gap.present) return text;
  return text + "\n" + where(diagnosis) + "\n" + what(diagnosis) + "\n" + how_far(diagnosis) +
         (diagnosis.proposals.empty() ? "" : "\n" + what_next(diagnosis));
}

}  // namespace plumbline::diagnose
