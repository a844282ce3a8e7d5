#pragma once
/// \file
/// The nominal model of an arm in space: its mechanics, and the names and limits that its model file gives.

#include <array>
#include <plumbline/arm/serial_arm.hpp>
#include <string>
#include <vector>

namespace plumbline::diagnose {

/// Lists are by link, from the base on; link i is moved by joint i.
struct NominalArm {
  SerialArm<double> arm;
  std::string base, tip;                        ///< names of the links or frames at its ends
  std::vector<std::string> joint, link;         ///< names
  std::vector<std::array<double, 2>> limits{};  ///< of joint coordinates, rad or m; infinite without
};

}  // namespace plumbline::diagnose
