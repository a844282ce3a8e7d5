#include "diagnose/rig/rig_solver.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/rig/nominal.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::vector<double> unloaded_shape{0.3, -0.5, 0.4};
const Layout three_rigid_links{3, false, false, 0};

/// A rig of three links without history in its unloaded posture, with the memory of its joints.
struct StandingChain {
  explicit StandingChain(const Rig& rig, std::vector<double> shape = unloaded_shape)
      : on(rig, shape), unloaded(std::move(shape)), memory(3), solver(three_rigid_links, 40) {
    posture.angle.resize(3);
    double theta = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      memory[i].angle = unloaded[i];
      posture.angle(static_cast<Eigen::Index>(i)) = theta += unloaded[i];
    }
    at = {Control::end_point, solver.end_point(on, {}, posture)};
  }

  [[nodiscard]] RigStep step() const { return {on, {}, memory}; }

  /// \returns whether it gets there
  bool go(const Imposed& to) {
    const Posture guess = posture;
    const bool arrived = solver.follow(step(), at, to, guess, posture);
    at = to;
    return arrived;
  }

  RunRig on;
  std::vector<double> unloaded;
  std::vector<JointMemory> memory;
  RigSolver<1> solver;
  Posture posture;
  Imposed at{Control::end_point, Vector2::Zero()};
};

StandingChain unloaded_chain() {
  return StandingChain(nominal_rig(three_links()));
}

/// By how much the torque of a spring and the moment about its joint of the force, which acts beside the end
/// point where the rig is such, differ.
double out_of_balance(const StandingChain& chain, std::size_t joint) {
  const Experiment bench = three_links();
  double x = 0, y = 0;
  for (std::size_t j = joint; j < 3; ++j) {
    const double theta = chain.posture.angle(static_cast<Eigen::Index>(j));
    x += bench.link_length[j] * std::cos(theta);
    y += bench.link_length[j] * std::sin(theta);
  }
  const double q = three_rigid_links.joint_angle(chain.posture.angle, joint);
  const double tip = chain.posture.angle(2), e = chain.on.rig.eccentricity;
  x -= e * std::sin(tip), y += e * std::cos(tip);
  return bench.joint_stiffness[joint] * (q - chain.unloaded[joint]) -
         (x * chain.posture.force.y - y * chain.posture.force.x);
}

// The last step of Newton's method turns by less than 1e-7 rad and leaves an error of its square, and of the
// force less than a share of 1e-7, squared as well: what is left is rounding, of some newtons and radians.
constexpr double left_by_newton = 1e-10;

/// One link on a spring that is at ease a little above the x axis: pressed against the base by more than k /
/// L it leans up or down, and a force across it throws it from one side to the other.
class LeaningLink {
 public:
  static constexpr double k = 2, L = 0.5, rest = 0.1, pressed = 1.35 * k / L, across = k / L;

  explicit LeaningLink(std::size_t readings) : solver_({1, false, false, 0}, readings) {
    posture.angle = Vector<double>::Constant(1, rest);
  }

  /// Goes on to a force across the link, under the one along it.
  bool push(double along, double aside) {
    const Imposed next{Control::force, {along, aside}};
    const Posture guess = posture;
    const bool arrived = solver_.follow({run_, {}, memory_}, at_, next, guess, posture);
    at_ = next;
    return arrived;
  }

  [[nodiscard]] double q() const { return posture.angle(0); }
  /// Torque that is out of balance, k (q - rest) - L (Fy cos q - Fx sin q), and its derivative by q.
  [[nodiscard]] double excess() const {
    return k * (q() - rest) - L * (at_.value.y() * std::cos(q()) - at_.value.x() * std::sin(q()));
  }
  [[nodiscard]] double stiffness() const {
    return k + L * (at_.value.y() * std::sin(q()) + at_.value.x() * std::cos(q()));
  }
  [[nodiscard]] bool snapped() const { return solver_.snapped(); }

  Posture posture;

 private:
  static Rig one_link() {
    Experiment experiment = three_links();
    experiment.link_length = {L};
    experiment.joint_stiffness = {k};
    experiment.link_mass = {0};
    return nominal_rig(experiment);
  }

  RunRig run_{one_link(), {rest}};
  std::vector<JointMemory> memory_{1};
  RigSolver<1> solver_;
  Imposed at_{Control::force, {0, 0}};
};

}  // namespace

TEST_CASE("a held end point is at its place, and every spring carries the moment of the force") {
  StandingChain chain = unloaded_chain();
  const Vector2 start = chain.at.value;
  for (const Vector2& by : {Vector2(-0.03, 0), Vector2(-0.06, 0.02), Vector2(-0.02, -0.04), Vector2(0, 0)}) {
    const Vector2 to = start + by;
    REQUIRE(chain.go({Control::end_point, to}));
    CHECK_FALSE(chain.solver.snapped());
    CHECK((chain.solver.end_point(chain.on, {}, chain.posture) - to).norm() < left_by_newton);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(out_of_balance(chain, i)) < left_by_newton);
  }
  // back where it came from it is unloaded again
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(three_rigid_links.joint_angle(chain.posture.angle, i) - unloaded_shape[i]) <
          left_by_newton);
  CHECK(std::hypot(chain.posture.force.x, chain.posture.force.y) < left_by_newton);
}

TEST_CASE("imposing a force, then its end point, gives the same equilibrium") {
  StandingChain loaded = unloaded_chain(), held = unloaded_chain();
  loaded.at = {Control::force, Vector2::Zero()};
  const Vector2 force(-2.5, 1);
  REQUIRE(loaded.go({Control::force, force}));
  CHECK(loaded.posture.force.x == force.x());
  CHECK(loaded.posture.force.y == force.y());
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(out_of_balance(loaded, i)) < left_by_newton);
  REQUIRE(held.go({Control::end_point, loaded.solver.end_point(loaded.on, {}, loaded.posture)}));
  // A millimetre of the end point is about 5 mrad, one over the length of a link, and some 0.1 N, k / L^2.
  CHECK((held.posture.angle - loaded.posture.angle).norm() < 10 * left_by_newton);
  CHECK((Vector2(held.posture.force.x, held.posture.force.y) - force).norm() < 1e3 * left_by_newton);
}

TEST_CASE("one large step ends where forty small ones do") {
  StandingChain leaps = unloaded_chain(), strides = unloaded_chain();
  const Vector2 start = leaps.at.value, by(-0.12, 0.05);
  REQUIRE(leaps.go({Control::end_point, start + by}));
  for (int i = 1; i <= 40; ++i) REQUIRE(strides.go({Control::end_point, start + i / 40.0 * by}));
  CHECK_FALSE(leaps.solver.snapped());
  CHECK((leaps.posture.angle - strides.posture.angle).norm() < 10 * left_by_newton);
}

TEST_CASE("a nearly straight chain is solved for any eccentricity of the force") {
  // A force on the outer side of the bend turns it back: the unloaded held chain is unstable, and moves to
  // the side to which the force pushes.
  for (const double e : {-0.08, -0.04, -0.02, -0.005, 0.005, 0.02, 0.04, 0.08}) {
    CAPTURE(e);
    Rig rig = nominal_rig(three_links());
    rig.eccentricity = e;
    StandingChain chain(rig, {0.06, -0.03, -0.04});
    const Vector2 start = chain.at.value;
    for (const double by : {0.0, -0.003, -0.01, -0.03}) {
      const Vector2 to = start + Vector2(by, 0);
      REQUIRE(chain.go({Control::end_point, to}));
      CHECK((chain.solver.end_point(chain.on, {}, chain.posture) - to).norm() < left_by_newton);
      // 1e2: in compression forces are tens of newtons.
      for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(out_of_balance(chain, i)) < 1e2 * left_by_newton);
      if (by < 0) CHECK(chain.posture.force.x < 0);
    }
  }
}

TEST_CASE("an end point out of reach is not reached") {
  StandingChain chain = unloaded_chain();
  CHECK_FALSE(chain.go({Control::end_point, Vector2(0.61, 0)}));  // of 0.6 m
}

TEST_CASE("an equal neighbouring rig has the same posture to the bit, a different one to second order") {
  StandingChain chain = unloaded_chain();
  const Imposed to{Control::end_point, chain.at.value + Vector2(-0.05, 0.02)};
  REQUIRE(chain.go(to));
  chain.solver.prepare(chain.step(), to, chain.posture);
  Posture beside;
  chain.solver.neighbour(chain.step(), to, chain.posture, beside);
  CHECK(beside.angle == chain.posture.angle);
  CHECK(beside.force.x == chain.posture.force.x);
  CHECK(beside.force.y == chain.posture.force.y);
  const auto error = [&](double share) {
    Rig stiffer = nominal_rig(three_links());
    stiffer.stiffness[1] *= 1 + share;
    StandingChain other(stiffer);
    REQUIRE(other.go(to));
    chain.solver.neighbour(other.step(), to, chain.posture, beside);
    return (beside.angle - other.posture.angle).norm();
  };
  // A chord step misses a s^2 + b s^3 at a share s: of a tenth of the share a hundredth, but for the cube, a
  // hundredth or so of the square here.
  const double large = error(0.01), small = error(0.001);
  CHECK(large > 1e3 * left_by_newton);
  CHECK(small < 0.011 * large);
  CHECK(small > 0.009 * large);
}

TEST_CASE("a link is followed to equilibrium, across a snap to the other stable branch") {
  LeaningLink link(3);
  REQUIRE(link.push(-LeaningLink::pressed, 0));
  CHECK_FALSE(link.snapped());
  CHECK(link.q() > LeaningLink::rest);
  // Newton's last step is below 1e-7 rad, and leaves its square times the torque's curvature, k.
  CHECK(std::abs(link.excess()) < 1e-13);
  REQUIRE(link.push(-LeaningLink::pressed, -LeaningLink::across));
  CHECK(link.snapped());
  CHECK(link.q() < 0);
  CHECK(std::abs(link.excess()) < 1e-13);
  CHECK(link.stiffness() > 0);
  REQUIRE(link.push(-LeaningLink::pressed, 0));
  CHECK_FALSE(link.snapped());
  CHECK(link.q() < 0);
  CHECK(std::abs(link.excess()) < 1e-13);
}

TEST_CASE("a link that snaps repeatedly is given up, later where there are more readings") {
  const auto throws = [](std::size_t readings) {
    LeaningLink link(readings);
    int count = 0;
    while (link.push(-LeaningLink::pressed, count % 2 == 0 ? -LeaningLink::across : LeaningLink::across))
      if (++count > 100'000) break;
    return count;
  };
  const int few = throws(2), more = throws(2000);
  CHECK(few > 2);
  CHECK(more > few);
  CHECK(more <= 100'000);
}
