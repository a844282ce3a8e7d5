#include "diagnose/discrepancy/offered_law.hpp"

#include <mutex>

#include "diagnose/decision/rotation.hpp"

namespace plumbline::diagnose {

std::optional<OfferedLaw> offer_law(const Study& study, const NoiseModel& noise, const Base& base) {
  std::optional<TorqueLaw> law = fit_torque_law(study, noise, base(study));
  if (!law) return std::nullopt;
  double least = left_with(study, noise, *law);
  std::mutex choosing;  // parts are held out at the same time
  // A fit to all readings may end in a worse minimum than one to most of them.
  const auto keep_better = [&](const TorqueLaw& blind) {
    const double left = left_with(study, noise, blind);
    const std::scoped_lock lock(choosing);
    if (left < least) least = left, law = blind;
  };
  const auto left_blind = [&](const Study& seen, const HeldOut& part) -> std::optional<std::vector<double>> {
    const std::optional<TorqueLaw> blind = fit_torque_law(seen, noise, base(seen));
    if (!blind) return study.nominal_residual();
    keep_better(*blind);
    if (!covers(study, *blind, part)) return std::nullopt;
    const Prediction predicted = predict_with_law(study, *blind);
    return predicted.reached ? std::optional(study.residual(predicted)) : std::nullopt;
  };
  const std::optional<Rotated> blind = rotated(study, noise, left_blind);
  law = refitted(study, noise, *law);
  OfferedLaw offered{*law, {}, std::nullopt, law_traces(study, *law)};
  for (const JointTorqueLaw& one : law->laws) offered.pictures.push_back(picture_of(one, law->shape.knots));
  if (blind) {
    offered.shrink = blind->shrink;
    offered.shrink->chosen_blind = true;
  }
  return offered;
}

}  // namespace plumbline::diagnose
