#include "diagnose/exchange/arm_document.hpp"

#include <cmath>
#include <numbers>
#include <plumbline/base/error.hpp>

#include "diagnose/exchange/format.hpp"

namespace plumbline::exchange {

std::unique_ptr<ArmDocument> arm_document(const std::filesystem::path& file, const ArmEnds& ends) {
  switch (format_of(file)) {
    case Format::mjcf:
      return arm_in_mjcf(file, ends);
    case Format::urdf:
      return arm_in_urdf(file, ends);
    case Format::sdf:
      return arm_in_sdf(file, ends);
    case Format::toml:
      break;
  }
  throw Error(file.string(), "a file of ours", "a simulator's model: .xml (MJCF), .urdf or .sdf");
}

double moment_of_ball(double mass) {
  constexpr double water = 1000;  // kg/m^3
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * water));
  return 0.4 * mass * radius * radius;
}

}  // namespace plumbline::exchange
