#include "diagnose/answers/offered_law.hpp"

#include <cmath>

namespace plumbline::diagnose {

namespace {

/// A law with its blind test; no shrink where the readings held out bend the joints farther than those seen.
std::optional<OfferedLaw> tested_law(const Study& study, const HeldOut& heldout, const NoiseModel& noise,
                                     const std::vector<Instance>& bases) {
  if (heldout.empty()) return std::nullopt;
  const Study seen = study.of(without(study.experiment(), heldout));
  const std::optional<TorqueLaw> law = fit_torque_law(seen, noise, bases);
  if (!law) return std::nullopt;
  OfferedLaw offered{*law, {}, std::nullopt, law_traces(study, *law)};
  for (const JointTorqueLaw& one : law->laws) offered.pictures.push_back(picture_of(one, law->knots));
  const Prediction after = predict_with_law(study, *law);
  if (after.reached && covers(study, *law, heldout))
    offered.shrink =
        measure_shrink(study.measurements(), heldout, study.nominal_residual(), study.residual(after), noise);
  if (offered.shrink) offered.shrink->chosen_blind = true;
  return offered;
}

}  // namespace

std::optional<OfferedLaw> offer_law(const Study& study, const HeldOut& heldout, const NoiseModel& noise,
                                    const std::vector<Instance>& bases) {
  std::optional<OfferedLaw> offered = tested_law(study, heldout, noise, bases);
  if (offered && offered->shrink) return offered;
  // A run that bends the joints the other way is no test of a law. The bases have seen the blocks.
  std::optional<OfferedLaw> by_blocks = tested_law(study, choose_blocks(study.experiment()), noise, {});
  return by_blocks && by_blocks->shrink ? by_blocks : offered;
}

}  // namespace plumbline::diagnose
