#include "diagnose/report/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

const Fit* best_explanation(const Cause& cause) {
  if (cause.ranking.empty()) return nullptr;
  return &cause.ranking[cause.best].hypothesis.fit;
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

Explained::Explained(const Study& studied, const Diagnosis& diagnosed)
    : study(studied),
      experiment(studied.experiment()),
      measurements(studied.measurements()),
      nominal(studied.nominal()),
      diagnosis(diagnosed),
      corrected(nominal),
      before(studied.nominal_residual()),
      after(before),
      best(best_explanation(diagnosed.cause)),
      model("nominal model") {
  if (diagnosed.offers_law()) {
    model = "torque law";
    corrected = predict_with_law(study, diagnosed.law->law);
    after = measurements.residual(experiment, corrected);
    return;
  }
  if (best == nullptr) return;
  const bool corrects = !diagnosed.shrink || diagnosed.shrink->ratio < 1;
  model = diagnosed.cause.verdict == CauseVerdict::unknown ? "best partial explanation"
          : corrects                                       ? "corrected model"
                                                           : "best explanation";
  corrected = predict(study, best->candidate, best->parameters);
  after = measurements.residual(experiment, corrected);
}

HeldOut heldout_of(const Explained& explained) {
  if (!explained.diagnosis.shrink) return {};
  HeldOut held = named(explained.experiment, explained.diagnosis.shrink->heldout);
  const bool all = std::all_of(held.reading.begin(), held.reading.end(), [](const std::vector<bool>& run) {
    return std::all_of(run.begin(), run.end(), [](bool one) { return one; });
  });
  return all ? HeldOut{} : held;
}

Command command_of(const Run& run) {
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
                  words_for(direction) + ", " + std::string(run.imposed()[0].unit());
  return command;
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
