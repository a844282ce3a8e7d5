/// \file
/// What a torque law looks like: laws that are drawn as an effect of the catalogue says, and those that none
/// draws.
#include "diagnose/discrepancy/resemblance.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnose/rig/effect.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

using Classes = std::vector<std::vector<std::string>>;

/// The law that carries, with a spring of this stiffness, this torque over a stroke of 0.4 rad.
JointTorqueLaw drawing(double stiffness, const std::function<double(double)>& torque) {
  JointTorqueLaw law{{1}, {-0.4, 0.4, 10}, Eigen::VectorXd::Zero(law_terms_count), stiffness};
  for (Eigen::Index k = 0; k < finest_knots; ++k) {
    const double d = knot_place(law.span, k);
    law.coefficients(k) = torque(d) - stiffness * d;
  }
  return law;
}

Classes seen_in(const JointTorqueLaw& law, Eigen::Index knots = 17) {
  return picture_of(law, knots).resembles;
}

/// The torque law of each effect: beside d in rad a share of its range, 0 weak and 1 strong, and where the
/// spring is at ease.
struct Drawn {
  const char* id;
  std::function<double(double d, double share)> torque;
};

const std::vector<Drawn> kinds{
    {"nonlinear_spring", [](double d, double share) { return 10 * d * (1 + (5 + 20 * share) * d * d); }},
    {"asymmetric_spring",
     [](double d, double share) { return 10 * d * (1 + (d > 0 ? 1 : -1) * (0.2 + 0.6 * share)); }},
    {"piecewise_spring",
     [](double d, double share) {
       const double over = std::abs(d) - (0.15 + 0.15 * share);
       return 10 * d - (over > 0 ? std::copysign(6 * over, d) : 0);
     }},
    {"joint_stop",
     [](double d, double share) {
       const double over = std::abs(d) - (0.15 + 0.15 * share);
       return 10 * d + (over > 0 ? std::copysign(60 * over, d) : 0);
     }},
    {"joint_stop",
     [](double d, double share) { return 10 * d + 60 * std::max(0.0, d - 0.15 - 0.15 * share); }},
    {"backlash", [](double d, double share) {
       return std::copysign(10 * std::max(0.0, std::abs(d) - 0.05 - 0.2 * share), d);
     }}};

}  // namespace

TEST_CASE("a law that an effect draws, off zero and with whatever stiffness, looks like that effect first") {
  check_property("the kind is named", [] {
    const Drawn& kind = kinds[*rc::gen::inRange<std::size_t>(0, kinds.size())];
    const auto percent = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
    const double share = percent(0, 101), stiffer = percent(50, 200), rest = percent(-2, 3);
    const Classes found =
        seen_in(drawing(10, [&](double d) { return stiffer * kind.torque(d - rest, share); }));
    RC_TAG(kind.id);
    RC_ASSERT(found.size() == 1);
    RC_ASSERT(std::find(found[0].begin(), found[0].end(), kind.id) != found[0].end());
    for (const std::string& id : found[0])
      RC_ASSERT(
          std::any_of(catalogue().begin(), catalogue().end(), [&](const Effect& e) { return e.id == id; }));
  });
}

TEST_CASE("a straight law looks like a stiffness or like nothing, and what no spring draws like nothing") {
  const auto straight = [](double k) { return [k](double d) { return k * d; }; };
  CHECK(seen_in(drawing(10, straight(10))).empty());
  CHECK(seen_in(drawing(10, straight(10.4))).empty());
  CHECK(seen_in(drawing(10, straight(8))) == Classes{{"joint_stiffness"}});
  CHECK(seen_in(drawing(10, [](double d) { return 10 * d + 2 * std::sin(25 * d); })).empty());
  CHECK(seen_in(drawing(10, [](double d) {
          return 10 * d + 20 * d * std::exp(-std::pow(d / 0.08, 2));
        })).empty());
  // Three knots show no shape, one piece nothing.
  CHECK(seen_in(drawing(10, [](double d) { return 10 * d * (d > 0 ? 2 : 1); }), 3) ==
        Classes{{"joint_stiffness"}});
}

TEST_CASE("loops and what relaxes look like what has such a memory, beside the shape of the spring") {
  const auto hard = [](double d) { return 10 * d * (1 + 20 * d * d); };
  JointTorqueLaw law = drawing(10, hard);
  CHECK(seen_in(law) == Classes{{"nonlinear_spring"}});
  const double largest = hard(0.4);
  law.coefficients(finest_knots) = 0.04 * largest;  // slips after 0.02 of the stroke; a narrow loop
  CHECK(seen_in(law).size() == 1);
  law.coefficients(finest_knots) = 0.06 * largest;
  CHECK(seen_in(law) == Classes{{"nonlinear_spring"}, {"joint_friction", "hysteresis"}});
  law.coefficients(finest_knots + 3) = 0.1 * largest;  // after 0.2 of it
  CHECK(seen_in(law) == Classes{{"nonlinear_spring"}, {"hysteresis"}});
  law = drawing(10, hard);
  law.coefficients(finest_knots + slip_places + 1) = 0.2 * largest;  // widens
  CHECK(seen_in(law) == Classes{{"nonlinear_spring"}, {"load_friction"}});
  law = drawing(10, hard);
  law.coefficients(plain_terms + 4) = -0.2 * largest;  // a profile, which slips after a tenth
  CHECK(seen_in(law) == Classes{{"nonlinear_spring"}, {"hysteresis"}});
  law = drawing(10, [](double d) { return 10 * d; });
  law.coefficients(finest_knots + slider_terms) = 1;
  CHECK(seen_in(law) == Classes{{"viscoelasticity", "relaxation_spectrum"}});
  law.coefficients(finest_knots + slider_terms + 1) = 1;
  law.coefficients(finest_knots + slider_terms + 2) = 1;
  CHECK(seen_in(law) == Classes{{"relaxation_spectrum", "viscoelasticity"}});
}
