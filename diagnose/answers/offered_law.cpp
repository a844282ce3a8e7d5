#include "diagnose/answers/offered_law.hpp"

#include <mutex>

#include "diagnose/decision/cross_validation.hpp"

namespace plumbline::diagnose {

std::optional<OfferedLaw> offer_law(const Study& study, const NoiseEstimate& noise) {
  if (study.experiment().visits_poses()) return std::nullopt;  // a law remembers its way
  std::optional<TorqueLaw> law = fit_torque_law(study, noise);
  if (!law) return std::nullopt;
  double least = left_with(study, noise, *law);
  std::mutex choosing;  // parts are held out at the same time
  // A fit to all readings may end in a worse minimum than one to most of them.
  const auto keep_better = [&](const TorqueLaw& blind) {
    const double left = left_with(study, noise, blind);
    const std::scoped_lock lock(choosing);
    if (left < least) least = left, law = blind;
  };
  const auto left_unseen = [&](const Study& seen, const NoiseEstimate& noise_seen,
                               const HeldOut& part) -> std::optional<VectorXd> {
    const std::optional<TorqueLaw> blind = fit_torque_law(seen, noise_seen);
    if (!blind) return study.nominal_residual();
    keep_better(*blind);
    if (!covers(study, *blind, part.reading)) return std::nullopt;
    const Prediction predicted = predict_with_law(study, *blind);
    return predicted.reached ? std::optional(study.residual(predicted)) : std::nullopt;
  };
  const std::optional<Shrink> shrink = cross_validated(study, noise, left_unseen);
  law = refitted(study, noise, *law);
  OfferedLaw offered{*law, {}, shrink, law_traces(study, *law)};
  for (const JointTorqueLaw& one : law->laws) offered.pictures.push_back(picture_of(one, law->shape.knots));
  return offered;
}

}  // namespace plumbline::diagnose
