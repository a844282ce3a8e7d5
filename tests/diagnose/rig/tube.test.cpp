/// A link that yields by its own weight: against the closed forms of beams (Euler and Bernoulli).
#include "diagnose/rig/tube.hpp"

#include <plumbline/arm/arm_equilibrium.hpp>

#include "diagnose/rig/arm_rig.hpp"
#include "tests/close_to.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using Eigen::Vector3d;

namespace {

constexpr double EI = 1e7, strain = 1e-8;  // so stiff that squares of turns, 1e-6, are far below the turns
constexpr double second_order = 1e-5;      // of what is checked

Vector3d some_vector() {
  return {random_hundredths(-1, 1), random_hundredths(-1, 1), random_hundredths(-1, 1)};
}

/// A rigid joint and its link.
ArmRig one_link(const Vector3d& end, double mass, const Vector3d& centre, const Vector3d& gravity) {
  ArmRig rig;
  rig.arm.gravity = gravity;
  rig.arm.links.resize(1);
  rig.arm.links[0].mass = mass;
  rig.arm.links[0].centre = centre;
  rig.arm.tip.translation() = end;
  return rig;
}

/// Translation and turn of the tip by the weight of the arm.
struct Sag {
  Vector3d shift, turn;
};

Sag sag_of(const ArmRig& rig, const std::vector<double>& command, double flexibility = 0) {
  const Vector<double> q =
      Eigen::Map<const Vector<double>>(command.data(), static_cast<Eigen::Index>(command.size()));
  const SerialArm<double> arm = rig.at(1, command, flexibility);
  const OnLink<double> tip{arm.size() - 1, arm.tip};
  const Pose<double> at = ArmPosture<double>(arm, equilibrium<double>(arm, q, {})).of(tip),
                     free = ArmPosture<double>(arm, commanded(arm, q)).of(tip);
  return {at.translation() - free.translation(),
          rotation_vector<double>(at.linear() * free.linear().transpose())};
}

void check_close(const Vector3d& found, const Vector3d& expected, double size) {
  RC_ASSERT((found - expected).norm() <= second_order * size);
}

}  // namespace

TEST_CASE(
    "an even link in any direction sags by W L^3 / 8 EI, turns by W L^2 / 6 EI, stretches by W L / 2 EA") {
  check_property("cantilever", [] {
    const Vector3d end = some_vector() + Vector3d(1.5, 0, 0), gravity = 10 * some_vector();
    const double L = end.norm(), mass = random_hundredths(1, 5);
    const Vector3d along = end / L, weight = mass * gravity, across = weight - weight.dot(along) * along;
    ArmRig rig = one_link(end, mass, end / 2, gravity);
    rig.bend(0, 1 / EI);
    rig.stretch(0, strain);
    const Sag sag = sag_of(rig, {0});
    const double size = weight.norm() * (L * L * L / (8 * EI) + L * strain);
    check_close(sag.shift, L * L * L / (8 * EI) * across + L / 2 * strain * weight.dot(along) * along, size);
    check_close(sag.turn, L * L / (6 * EI) * along.cross(across), size / L);
  });
}

TEST_CASE("a payload at the end of an even link adds its own W L^3 / 3 EI and W L^2 / 2 EI") {
  const double L = 0.8, m = 3, payload = 5, g = 10;
  ArmRig rig = one_link({L, 0, 0}, m, {L / 2, 0, 0}, {0, 0, -g});
  add_mass(rig.arm.links[0], payload, {L, 0, 0});
  rig.bend(0, 1 / EI);
  const Sag sag = sag_of(rig, {0});
  CHECK(sag.shift.z() == close_to(-g * L * L * L / EI * (m / 8 + payload / 3)).epsilon(second_order));
  CHECK(sag.turn.y() == close_to(g * L * L / EI * (m / 6 + payload / 2)).epsilon(second_order));
}

TEST_CASE("a link in pieces, with a motor at its end, sags as it does in one") {
  const double L = 0.9, m = 4, motor = 2, g = 10;
  const auto of_pieces = [&](std::size_t count) {
    ArmRig rig;
    rig.arm.gravity = {0, -g, 0};
    const double piece = L / static_cast<double>(count);
    rig.arm.links.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      rig.arm.links[i].mass = m / static_cast<double>(count);
      rig.arm.links[i].centre = {piece / 2, 0, 0};
      if (i > 0) rig.arm.links[i].frame.translation() = Vector3d(piece, 0, 0);
    }
    rig.arm.tip.translation() = Vector3d(piece, 0, 0);
    add_mass(rig.arm.links.back(), motor, {piece, 0, 0});
    for (std::size_t i = 0; i < count; ++i) rig.bend(i, 1 / EI), rig.stretch(i, strain);
    return sag_of(rig, std::vector<double>(count, 0.0));
  };
  const Sag whole = of_pieces(1);
  CHECK(whole.shift.y() == close_to(-g * L * L * L / EI * (m / 8 + motor / 3)).epsilon(second_order));
  for (const std::size_t count : {2, 5, 12}) {
    const Sag pieces = of_pieces(count);
    CHECK(pieces.shift.y() == close_to(whole.shift.y()).epsilon(second_order));
    CHECK(pieces.turn.z() == close_to(whole.turn.z()).epsilon(second_order));
  }
}

TEST_CASE("parted masses keep mass and centre, wherever that is") {
  check_property("parted", [] {
    ArmLink<double> link;
    link.mass = random_hundredths(0, 9);
    link.centre = 2 * some_vector();
    const Vector3d from = some_vector(), to = from + some_vector() + Vector3d(0, 0, 1.5);
    ArmLink<double> parted = link;
    part_mass(parted, from, to);
    RC_ASSERT(parted.mass >= 0);
    RC_ASSERT(parted.far_mass >= 0);
    // rounding of numbers up to ten
    RC_ASSERT(std::abs(parted.mass + parted.far_mass - link.mass) < 1e-14);
    const Vector3d sum = parted.mass * parted.centre + parted.far_mass * parted.far_centre;
    RC_ASSERT((sum - link.mass * link.centre).norm() < 1e-13);
  });
}

TEST_CASE("an even link whose mass lies beside it twists by half its moment") {
  const double L = 0.7, m = 4, g = 10, beside = 0.05;
  ArmRig rig = one_link({L, 0, 0}, m, {L / 2, beside, 0}, {0, 0, -g});
  rig.bend(0, 1 / EI);
  // the moment of each part, all along: m g b s from the root on; GJ = EI / 1.3
  CHECK(sag_of(rig, {0}).turn.x() == close_to(-1.3 * m * g * beside * L / (2 * EI)).epsilon(second_order));
}

TEST_CASE("what has slid out sags by its own length: evenly, or with all its mass beyond it") {
  const double out = 0.6, m = 4, g = 10;
  for (const double centre : {-out / 2, 0.0, 0.2}) {
    ArmRig rig = one_link({0.3, 0, 0}, m, {centre, 0, 0}, {0, 0, -g});
    rig.arm.links[0].kind = JointKind::prismatic;
    rig.arm.links[0].axis = {1, 0, 0};
    const double turn = centre < 0 ? out * out / 6 : out * out / 2 + out * centre;
    const double shift = centre < 0 ? out * out * out / 8 : out * out * out / 3 + out * out / 2 * centre;
    const Sag sag = sag_of(rig, {out}, 1 / EI);
    CHECK(sag.turn.y() == close_to(m * g / EI * turn).epsilon(second_order));
    CHECK(sag.shift.z() == close_to(-m * g / EI * (shift + 0.3 * turn)).epsilon(second_order));
  }
}

TEST_CASE("a rigid arm is as it was") {
  ArmRig rig = one_link({1, 0, 0}, 3, {0.4, 0.1, 0}, {0, 0, -10});
  CHECK(rig.at(1, {0.3}, 0) == rig.arm);
}
