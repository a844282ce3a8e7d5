#pragma once
/// \file
/// Whether a free torque law is offered where no known effect explains the gap, how far it goes, and what it
/// looks like.

#include "diagnose/answers/torque_law.hpp"

namespace plumbline::diagnose {

/// One law as a person would draw it.
struct LawPicture {
  std::vector<std::size_t> joints;   ///< from 1
  std::vector<FreeLaw::Knot> knots;  ///< over what was exercised; of spring and law together
  std::vector<FreeLaw::Slider> sliders;
  std::vector<FreeLaw::Arm> arms;
  std::string words;  ///< what it resembles
};

struct OfferedLaw {
  TorqueLaw law;
  std::vector<LawPicture> pictures;  ///< one a law
  std::optional<Shrink> shrink;  ///< nothing where the readings held out bend a joint farther than those seen
  std::vector<LawTrace> traces;
};

/// The picture of one law.
LawPicture picture_of(const JointTorqueLaw& law, Eigen::Index knots);

/// A law chosen and fitted without the readings held out, measured on them; where those bend the joints
/// farther than the others, without two blocks of every run. Nothing where none is better than `bases`, the
/// explanations that were fitted to the readings seen, and the nominal model.
std::optional<OfferedLaw> offer_law(const Study& study, const HeldOut& heldout, const NoiseModel& noise,
                                    const std::vector<Instance>& bases);

}  // namespace plumbline::diagnose
