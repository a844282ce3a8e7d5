#pragma once
/// \file
/// What a lab would write down before it presses: the nominal chain, the bench, the runs. SI units, radians.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace plumbline::simulator {

using Pair = std::array<double, 2>;  ///< along x and y of the base frame

/// The chain that the lab believes in.
struct Nominal {
  std::vector<double> length, stiffness, mass;
  Pair gravity{0, 0};  ///< in-plane gravity that the nominal model includes, m/s^2
};

/// The command of the carriage for one reading.
struct Command {
  double t;
  Pair value;  ///< end point, or force on the end point
};

struct PlannedRun {
  std::string id;
  bool force_controlled = false;
  std::vector<double> rest;
  std::vector<Command> commands;
};

/// The bench's plane: of its three words only "vertical" comes with a direction.
enum class Plane { horizontal, vertical, unknown };

struct Plan {
  Nominal nominal;
  Plane plane = Plane::horizontal;
  Pair down{0, 0};  ///< unit vector of gravity, zero in a horizontal plane
  bool angles_measured = false, cross_force_measured = true;  ///< joint angles; Fy
  std::vector<PlannedRun> runs;

  [[nodiscard]] std::size_t size() const { return nominal.length.size(); }
  [[nodiscard]] double reach() const {
    double sum = 0;
    for (const double length : nominal.length) sum += length;
    return sum;
  }
  [[nodiscard]] double typical_stiffness() const {
    double sum = 0, elastic = 0;
    for (const double k : nominal.stiffness) sum += k, elastic += k > 0;
    return sum / elastic;
  }
};

}  // namespace plumbline::simulator
