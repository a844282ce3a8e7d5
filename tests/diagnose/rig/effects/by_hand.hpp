#pragma once
/// \file
/// Sizes of a bench for values that are computed by hand.

#include <doctest/doctest.h>

#include <vector>

#include "diagnose/rig/characteristic_scales.hpp"

namespace plumbline::diagnose::test {

/// Sizes that differ from each other, of three links of which the first joint is passive, with three runs.
inline CharacteristicScales sizes_by_hand() {
  CharacteristicScales size;
  size.joint_stiffness = {0, 3, 5};
  size.link_length = size.reach = {0.2, 0.5, 0.6};
  size.link_mass = {0, 0, 0};
  size.rigid = size.slides = std::vector<bool>(3, false);
  size.moves = std::vector<bool>(3, true);
  size.least_command = {-0.4, -0.2, 0.1};
  size.largest_command = {0.4, 0.8, 0.6};
  size.stiffness = 4;
  size.mass = 2;
  size.torque = 1.2;
  size.length = 1.3;
  size.link = 1.3 / 3;
  size.force = 7;
  size.deflection = 0.3;
  size.duration = 90;
  size.sampling_interval = 2.5;
  size.runs = 3;
  size.largest_reading = 11;
  size.applied = {{1, 10}};
  size.covariates = {0};
  return size;
}

/// Largest deflections and the torque that goes with them.
inline Excitation excitation_by_hand() {
  return {{0.11, 0.23, 0.31}, 0.31, 1.7};
}

inline void check_values(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i] == doctest::Approx(expected[i]).epsilon(1e-12).scale(1e-9));
  }
}

}  // namespace plumbline::diagnose::test
