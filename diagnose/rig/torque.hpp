#pragma once
/// \file
/// The torque of a joint and its derivative.

#include <vector>

#include "diagnose/bench/free_law.hpp"

namespace plumbline::diagnose {

/// A torque, its derivative by the joint angle, and its energy: stored, or absorbed since the last reading
/// where the torque depends on history.
struct Torque {
  double value = 0, slope = 0, energy = 0;

  Torque& operator+=(const Torque& other) {
    value += other.value;
    slope += other.slope;
    energy += other.energy;
    return *this;
  }
};

/// A piecewise linear torque, extrapolated linearly beyond its knots.
class TorqueTable {
 public:
  /// \pre at least one knot; deflections rise
  explicit TorqueTable(const std::vector<FreeLaw::Knot>& knots);

  [[nodiscard]] Torque at(double deflection) const;
  /// Integral of the torque times a factor that changes linearly over the deflection.
  [[nodiscard]] double work(double from, double to, double share_from, double share_to) const;

 private:
  std::vector<FreeLaw::Knot> knots_;
  std::vector<double> energy_;  ///< at each knot, from the first
};

}  // namespace plumbline::diagnose
