#pragma once
/// \file
/// Whether a free torque law is offered where no known effect explains the gap, how far it goes, and what it
/// looks like.

#include <optional>

#include "diagnose/decision/shrink.hpp"
#include "diagnose/discrepancy/torque_law.hpp"

namespace plumbline::diagnose {

/// One law as a person would draw it.
struct LawPicture {
  std::vector<std::size_t> joints;   ///< from 1
  std::vector<FreeLaw::Knot> knots;  ///< over what was exercised; of spring and law together
  std::vector<FreeLaw::Slider> sliders;
  std::vector<FreeLaw::Arm> arms;
  std::string words;  ///< what it looks like
};

struct OfferedLaw {
  TorqueLaw law;
  std::vector<LawPicture> pictures;  ///< one a law
  std::optional<Shrink> shrink;      ///< nothing where no part can be held out to test it
  std::vector<LawTrace> traces;
};

/// The stiffness between neighbouring knots, N m/rad.
std::vector<double> stiffnesses(const std::vector<FreeLaw::Knot>& knots);

/// The picture of one law.
LawPicture picture_of(const JointTorqueLaw& law, Eigen::Index knots);

/// A law chosen and fitted to all readings, or to all but a part where that leaves less of all. Its shrink is
/// that of laws chosen and fitted without each part of the readings in its turn; a part without which none is
/// found keeps its residual, and one that bends the joints farther than the others is no test. Nothing where
/// no law is better than the nominal model.
std::optional<OfferedLaw> offer_law(const Study& study, const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
