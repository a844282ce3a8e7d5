#pragma once
/// \file
/// A nominal chain out of a model's file, ours or a simulator's; an arm out of a simulator's.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/bench/read_arm.hpp"
#include "diagnose/exchange/format.hpp"
#include "diagnose/exchange/planar_chain.hpp"
#include "diagnose/exchange/spatial_arm.hpp"

namespace plumbline::exchange {

/// \param kept  the joints of a simulator's model that make the chain, the others held; empty: all
/// \throws Error, one line: for an ending of no format, a file that is none of its format, and what is no
///         planar serial chain of hinges
PlanarChain read_model(const std::filesystem::path& file, const std::vector<std::string>& kept = {});

/// \throws Error, one line: as read_model() does for a file, and as spatial_arm() does for what is no arm
SpatialArm read_arm(const std::filesystem::path& file, const ArmEnds& ends = {});

/// Reads the arms that experiments name, and gives these the effects that the model contains.
class ArmReader {
 public:
  [[nodiscard]] diagnose::ReadArm read();
  [[nodiscard]] diagnose::Experiment with_effects(diagnose::Experiment experiment) const;

 private:
  std::vector<diagnose::NominalEffect> effects_;
};

}  // namespace plumbline::exchange
