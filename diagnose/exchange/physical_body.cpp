#include "diagnose/exchange/physical_body.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <numbers>
#include <plumbline/base/error.hpp>

namespace plumbline::exchange {

void require_mass(double mass, const std::string& place) {
  if (mass < 0) throw Error(place + ": mass", fmt::format("{:.6g}", mass), "kilograms, zero or positive");
}

std::string impossible_inertia(const Eigen::Matrix3d& inertia) {
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  // Files have three digits or so, and tensors of slender bodies lie on the edge.
  const double rounding = 5e-3 * moments.cwiseAbs().maxCoeff();
  if (moments[0] < -rounding) return fmt::format("a principal moment of {:.3g} kg m^2", moments[0]);
  if (moments[0] + moments[1] >= moments[2] - rounding) return "";
  return fmt::format("a principal moment of {:.3g} kg m^2, larger than {:.3g} and {:.3g} together",
                     moments[2], moments[0], moments[1]);
}

void require_radians(const Eigen::Vector3d& angles, const std::string& place) {
  constexpr double most = 4 * std::numbers::pi;
  const double largest = angles.cwiseAbs().maxCoeff();
  if (largest > most)
    throw Error(place, fmt::format("an angle of {:.6g}", largest),
                fmt::format("radians: {:.6g}, if these are degrees", largest * std::numbers::pi / 180));
}

}  // namespace plumbline::exchange
