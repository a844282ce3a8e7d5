#pragma once
/// \file
/// What a joint carries, and how that goes with its angle.

#include <vector>

#include "diagnose/bench/free_law.hpp"

namespace plumbline::diagnose {

/// A torque, its derivative with respect to the joint angle, and its integral: what the joint stores, or
/// takes in since the last reading where its torque depends on history.
struct Torque {
  double value = 0, slope = 0, energy = 0;

  Torque& operator+=(const Torque& other) {
    value += other.value;
    slope += other.slope;
    energy += other.energy;
    return *this;
  }
};

/// A torque that is straight between knots, and on beyond them.
class TorqueTable {
 public:
  /// \pre at least one knot; deflections rise
  explicit TorqueTable(const std::vector<FreeLaw::Knot>& knots);

  [[nodiscard]] Torque at(double deflection) const;
  /// Integral of a share of it over the deflection. The share goes straight from one value to another.
  [[nodiscard]] double work(double from, double to, double share_from, double share_to) const;

 private:
  std::vector<FreeLaw::Knot> knots_;
  std::vector<double> energy_;  ///< at each knot, from the first
};

}  // namespace plumbline::diagnose
