#include "diagnose/report/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/bench/command_range.hpp"
#include "diagnose/bench/end_kind.hpp"

namespace plumbline::diagnose {
namespace {

const RankedCause* best_explanation(const Diagnosis& diagnosis) {
  if (!diagnosis.gap.present || diagnosis.cause.ranking.empty()) return nullptr;
  return &diagnosis.cause.ranking.front();
}

/// "+x", "−y", or "(0.80, −0.60)".
std::string words_for(const Vector2& direction) {
  if (direction.x() > 0.999) return "+x";
  if (direction.x() < -0.999) return "−x";
  if (direction.y() > 0.999) return "+y";
  if (direction.y() < -0.999) return "−y";
  const auto part = [](double value) {
    return fmt::format("{}{:.2f}", value < 0 ? "−" : "", std::abs(value));
  };
  return "(" + part(direction.x()) + ", " + part(direction.y()) + ")";
}

}  // namespace

std::vector<EstimatedEffect> estimated_effects(const Diagnosis& diagnosis) {
  std::vector<EstimatedEffect> effects;
  if (!diagnosis.cause.is_explained()) return effects;
  const RankedCause& lead = diagnosis.cause.ranking.front();
  const std::vector<EffectAt>& all = lead.hypothesis.candidate.effects;
  for (std::size_t e = 0; e < all.size(); ++e)
    if (lead.cause.has(all[e])) effects.push_back({all[e], diagnosis.estimates[e]});
  return effects;
}

bool shows_tolerances(const RankedCause& cause) {
  return cause.hypothesis.candidate.has_all_tolerances() && cause.cause != cause.hypothesis.candidate;
}

bool outside_is_likelier(const Cause& cause) {
  return cause.or_unknown && cause.unknown > cause.ranking.front().probability;
}

std::size_t told_effects(const Cause& cause) {
  constexpr std::size_t most = 3;
  constexpr double noticeable = 0.1;
  if (cause.verdict == CauseVerdict::identified) return 0;
  std::size_t count = 0;
  while (count < std::min(most, cause.effects.size()) && cause.effects[count].probability >= noticeable)
    ++count;
  return count;
}

std::string effect_in_words(const Cause& cause, const std::string& label) {
  for (const RankedCause& one : cause.ranking)
    for (const EffectAt& at : one.cause.effects)
      if (at.label() == label) return at.in_words();
  return label;
}

std::string tested_model(const Diagnosis& diagnosis) {
  if (diagnosis.offers_law()) return "the torque law";
  if (diagnosis.fails_to_predict) return "the most probable cause";
  return diagnosis.cause.is_explained() ? "this cause" : "the best partial explanation";
}

Explained::Explained(const Study& studied, const Diagnosis& diagnosed)
    : study(studied),
      experiment(studied.experiment()),
      measurements(studied.measurements()),
      nominal(studied.nominal()),
      diagnosis(diagnosed),
      corrected(nominal),
      before(studied.nominal_residual()),
      after(before),
      best(best_explanation(diagnosed)),
      model("nominal model") {
  if (diagnosed.offers_law()) {
    model = "torque law";
    corrected = predict_with_law(study, diagnosed.law->law);
    after = study.residual(corrected);
    return;
  }
  if (best == nullptr) return;
  const bool corrects = !diagnosed.shrink || diagnosed.shrink->ratio < 1;
  model = diagnosed.fails_to_predict        ? "most probable cause"
          : !diagnosed.cause.is_explained() ? "best partial explanation"
          : corrects                        ? "corrected model"
                                            : "best explanation";
  corrected = predict(study, best->hypothesis.candidate, best->hypothesis.parameters);
  after = study.residual(corrected);
}

HeldOut heldout_of(const Explained& explained) {
  if (!explained.diagnosis.shrink) return {};
  HeldOut held = named(explained.experiment, explained.diagnosis.shrink->heldout);
  const bool all = std::all_of(held.reading.begin(), held.reading.end(), [](const std::vector<bool>& run) {
    return std::all_of(run.begin(), run.end(), [](bool one) { return one; });
  });
  return all ? HeldOut{} : held;
}

namespace {

/// Of joints that are commanded: that of the joint which is sent farthest.
Command command_of_joints(const Run& run) {
  Command command{{}, "", 0};
  std::size_t joint = 0;
  double most = -1;
  for (std::size_t i = 0; i < run.readings.size(); ++i)
    for (std::size_t j = 0; j < run.rest.size(); ++j)
      if (const double way = std::abs(run.readings[i].rest[j] - run.rest[j]); way > most)
        most = way, joint = j, command.farthest = i;
  for (const Reading& reading : run.readings) command.along.push_back(reading.rest[joint] - run.rest[joint]);
  command.label = fmt::format("command of joint {} from its first, {}", joint + 1, unit(run.end().joint));
  return command;
}

/// A command that one value tells.
Command command_of_values(std::vector<double> along, std::string label) {
  const auto first = along.begin();
  const auto away = [&](double a, double b) { return std::abs(a - *first) < std::abs(b - *first); };
  const auto farthest = static_cast<std::size_t>(std::max_element(first, along.end(), away) - first);
  return {std::move(along), std::move(label), farthest};
}

Command command_of_joint_alone(const Run& run) {
  std::vector<double> along;
  for (const Reading& reading : run.readings) along.push_back(run.imposed_at(reading).x());
  return command_of_values(std::move(along), with_unit(run.imposed().front()));
}

/// The range of a load's values.
double range_of(const Run& run, const LoadChannel& load) {
  CommandRange range;
  for (const Reading& reading : run.readings) range.add(reading.covariates[load.covariate]);
  return range.high - range.low;
}

/// The load along the chain that moves the command most; nothing where the imposed channels move it more.
std::optional<LoadChannel> leading_load(const Run& run) {
  double most = 0;
  for (const Reading& reading : run.readings)
    most = std::max(most, (run.imposed_at(reading) - run.imposed_at(run.readings.front())).norm());
  std::optional<LoadChannel> leading;
  for (const LoadChannel& load : run.loads)
    if (const double way = range_of(run, load) * load.moves.norm(); way > most) most = way, leading = load;
  return leading;
}

Command command_of_load(const Run& run, const LoadChannel& load) {
  std::vector<double> along;
  for (const Reading& reading : run.readings) along.push_back(reading.covariates[load.covariate]);
  return command_of_values(std::move(along), load.name + ", " + load.unit);
}

}  // namespace

Command command_of(const Run& run) {
  if (run.commands_joints()) return command_of_joints(run);
  if (const std::optional<LoadChannel> load = leading_load(run)) return command_of_load(run, *load);
  if (run.imposed().size() == 1) return command_of_joint_alone(run);
  std::vector<Vector2> way;
  Command command{{}, "", 0};
  Vector2 start(0, 0), farthest(0, 0);
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const Vector2 point = run.command(run.readings[i]);
    if (i == 0) start = point;
    way.push_back(point - start);
    if (way.back().norm() > farthest.norm()) farthest = way.back(), command.farthest = i;
  }
  const Vector2 direction = farthest.norm() > 0 ? Vector2(farthest.normalized()) : Vector2(1, 0);
  for (const Vector2& point : way) command.along.push_back(point.dot(direction));
  command.label = (run.holds_end_point() ? "end point moved along " : "force added along ") +
                  words_for(direction) + ", " + std::string(run.imposed().front().unit());
  return command;
}

std::string probability_in_words(double value) {
  if (value > 0.999) return "> 0.999";
  return value < 0.001 ? "< 0.001" : fmt::format("{:.3f}", value);
}

std::string joined(const std::vector<std::string>& parts, const std::string& between,
                   const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? last : between) + parts[i];
  return text;
}

std::string in_words(const Candidate& candidate) {
  std::vector<std::string> parts;
  for (const EffectAt& at : candidate.effects) parts.push_back(at.in_words());
  return joined(parts, ", ", " and ");
}

std::string with_unit(const Channel& channel) {
  return channel.label() + ", " + std::string(channel.unit());
}

}  // namespace plumbline::diagnose
