#pragma once
/// \file
/// Reads the table [arm] of experiment.toml: the nominal arm and its bench.

#include <filesystem>
#include <functional>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/bench/section.hpp"

namespace plumbline::diagnose {

/// Reads an arm from the file of a model, of any format.
/// \param base, tip  names of its ends; empty where experiment.toml names none
/// \throws Error, one line, where the file holds no arm between them
using ReadArm =
    std::function<NominalArm(const std::string& file, const std::string& base, const std::string& tip)>;

struct ReadArmBench {
  NominalArm arm;
  ArmBench bench;
  bool motor_side = false;  ///< the angles q are the motors': they are what is commanded
};

/// The arm by its joints, `[[arm.joint]]`, or from a file, `arm.model`; the points that are measured and
/// where the load acts, both at the tip where nothing is said.
/// \throws Error that names file, line and key
ReadArmBench read_arm(const Section& section, const ReadArm& read);

/// The chain of an arm's joints and links: distances along its links, stiffnesses, masses.
NominalChain chain_of(const NominalArm& arm);

}  // namespace plumbline::diagnose
