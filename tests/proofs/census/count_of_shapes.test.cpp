// Theorem "Count of shapes" on three links: with the end point held, the shapes form closed curves of one
// parameter, and the equilibria are the extrema of the energy along them.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <plumbline/chain/strain_energy.hpp>

using namespace plumbline;

namespace {

/// Joint angles with link 1 at theta_1 and the other two from its end to (reach, 0), bent to one side; none
/// where they are too short.
std::vector<double> shape(const Chain<double>& chain, double reach, double theta1, int side) {
  const auto& L = chain.length();
  const double x = reach - L[0] * std::cos(theta1), y = -L[0] * std::sin(theta1);
  const double distance = std::hypot(x, y);
  const double bend = (distance * distance - L[1] * L[1] - L[2] * L[2]) / (2 * L[1] * L[2]);  // cosine of q_3
  if (std::abs(bend) > 1) return {};
  const double q3 = side * std::acos(bend);
  const double theta2 = std::atan2(y, x) - std::atan2(L[2] * std::sin(q3), L[1] + L[2] * bend);
  return {theta1, theta2 - theta1, q3};
}

/// The numbers of minima and of maxima of the energy along the closed curve of shapes near the straight
/// chain.
std::array<int, 2> extrema(const Chain<double>& chain, double shortening) {
  const double reach = chain.length()[0] + chain.length()[1] + chain.length()[2] - shortening;
  const int steps = 20000;
  // theta_1 runs forth with the elbow on one side and back with it on the other; the ends, where it is
  // straight, join
  double limit = 0;
  while (!shape(chain, reach, limit + 1e-6, 1).empty()) limit += 1e-6;
  std::vector<double> energy;
  for (const int side : {1, -1}) {
    for (int i = 0; i < steps; ++i) {
      const double at =
          side * limit * -std::cos(std::numbers::pi * (i + 0.5) / steps);  // dense where the curve turns
      energy.push_back(strain_energy(chain, shape(chain, reach, at, side)));
    }
  }
  std::array<int, 2> count{0, 0};
  int last = 0;
  for (std::size_t i = 0; i < energy.size() * 2; ++i) {  // the second round counts, with `last` known
    const double step = energy[(i + 1) % energy.size()] - energy[i % energy.size()];
    const int sign = step > 0 ? 1 : step < 0 ? -1 : last;
    if (i >= energy.size() && sign != last) ++count[sign > 0 ? 0 : 1];
    last = sign;
  }
  return count;
}

}  // namespace

TEST_CASE(
    "Count of shapes: 2 (n - 1) = 4 equilibria near the straight chain, half of them stable for n = 3") {
  for (const auto& chain : {Chain<double>({1, 1, 1}, {1, 1, 1}), Chain<double>({1, 1, 1}, {0, 1, 1}),
                            Chain<double>({1, 2, 1.5}, {3, 1, 2}), Chain<double>({2, 1, 1}, {1, 0.1, 0.1})}) {
    CHECK(extrema(chain, 1e-4) == std::array<int, 2>{2, 2});
  }
  // two modes under one force, and a shape far from the straight one, are not what the theorem is about
  CHECK(extrema(Chain<double>({1, 1, 1}, {3, 0, 1}), 1e-4) == std::array<int, 2>{4, 4});
  CHECK(extrema(Chain<double>({1, 1, 1}, {1, 1, 1}), 1.8) == std::array<int, 2>{4, 4});
}
