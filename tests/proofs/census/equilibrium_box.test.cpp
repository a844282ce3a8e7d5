#include "proofs/census/equilibrium_box.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <random>

#include "proofs/exact/inertia.hpp"
#include "proofs/paths/branch_equations.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// A chain and a load made for an equilibrium: the rest angles are those that the moments ask for. Rounded at
/// 1e-15, as the angles and the force are.
struct Balanced {
  Control control;
  Chain<Interval> chain;
  Point<Interval> load;
  std::vector<double> unknown;  ///< the equilibrium: angles and, where the end point is held, the force
  EquilibriumBox system;

  Balanced(Control control_, const std::vector<double>& length, const std::vector<double>& stiffness,
           const std::vector<double>& theta, Point<double> force)
      : control(control_),
        chain(intervals(length), intervals(stiffness), intervals(rest(length, stiffness, theta, force))),
        load(loaded(control_, length, theta, force)),
        unknown(theta),
        system(chain, control_, load, control_ == Control::end_point ? unwound(chain) : Window{}) {
    if (control == Control::end_point) unknown.insert(unknown.end(), {force.x, force.y});
  }

  /// The equilibrium, each entry as far off as told.
  [[nodiscard]] Box near(double off) const {
    Box z;
    for (std::size_t j = 0; j < unknown.size(); ++j) z[j] = Span(unknown[j] - off, unknown[j] + off);
    return z;
  }
  /// Whether a box holds the equilibrium, and no entry of it is wider than this.
  [[nodiscard]] bool found_in(const Box& z, double width) const {
    for (std::size_t j = 0; j < unknown.size(); ++j) {
      CAPTURE(j);
      CHECK(z[j].low < unknown[j] + 1e-12);
      CHECK(z[j].high > unknown[j] - 1e-12);
      CHECK(z[j].width() < width);
      if (!(z[j].width() < width)) return false;
    }
    return true;
  }

 private:
  static std::vector<Interval> intervals(const std::vector<double>& values) {
    std::vector<Interval> result;
    for (const double x : values) result.push_back(Interval::from_double(x));
    return result;
  }
  static std::vector<double> rest(const std::vector<double>& length, const std::vector<double>& stiffness,
                                  const std::vector<double>& theta, Point<double> force) {
    std::vector<double> result(theta.size());
    double moment = 0;  // of the force about joint i
    for (std::size_t i = theta.size(); i-- > 0;) {
      moment += length[i] * (force.y * std::cos(theta[i]) - force.x * std::sin(theta[i]));
      const double q = i > 0 ? theta[i] - theta[i - 1] : theta[i];
      result[i] = stiffness[i] > 0 ? q - moment / stiffness[i] : 0;
    }
    return result;
  }
  static Point<Interval> loaded(Control control, const std::vector<double>& length,
                                const std::vector<double>& theta, Point<double> force) {
    Point<double> p{0, 0};
    for (std::size_t i = 0; i < theta.size(); ++i)
      p.x += length[i] * std::cos(theta[i]), p.y += length[i] * std::sin(theta[i]);
    const Point<double>& at = control == Control::end_point ? p : force;
    return {Interval::from_double(at.x), Interval::from_double(at.y)};
  }
};

const std::vector<double> box_lengths{1, 0.75, 1.25, 0.875}, box_stiffnesses{1.5, 1, 2, 0.75},
    box_angles{0.4, -0.6, 0.9, 0.1};

Balanced held(double base = 1.5) {
  return {Control::end_point, box_lengths, {base, 1, 2, 0.75}, box_angles, {-0.7, 0.3}};
}
/// On a passive base: the line of the force passes through it.
Balanced held_on_a_passive_base() {
  Point<double> p{0, 0};
  for (std::size_t i = 0; i < box_lengths.size(); ++i)
    p.x += box_lengths[i] * std::cos(box_angles[i]), p.y += box_lengths[i] * std::sin(box_angles[i]);
  return {Control::end_point, box_lengths, {0, 1, 2, 0.75}, box_angles, {-0.4 * p.x, -0.4 * p.y}};
}
Balanced pushed(double factor = 1) {
  return {Control::force, box_lengths, box_stiffnesses, box_angles, {-0.7 * factor, 0.3 * factor}};
}

/// The equations at a load, by other code: those of a branch without its unknown load.
struct BoxEquations {
  BranchEquations branch;
  Eigen::Index size;

  explicit BoxEquations(const Balanced& at)
      : branch(at.chain, {at.control, at.load, {1, 0}}), size(branch.unknowns() - 1) {}
  [[nodiscard]] Vector<Span> with_load(const Vector<Span>& z) const {
    Vector<Span> u(size + 1);
    u << z, Span(0);
    return u;
  }
  Vector<Span> value(const Vector<Span>& z) { return branch.value(with_load(z)).head(size); }
  Matrix<Span> derivative(const Vector<Span>& z) {
    const Vector<Span> plane = Vector<Span>::Constant(size + 1, Span(0));
    return branch.derivative(with_load(z), plane).topLeftCorner(size, size);
  }
};

Matrix<Span> applied(const Eigen::MatrixXd& Y, const Matrix<Span>& A) {
  Matrix<Span> result = Matrix<Span>::Constant(Y.rows(), A.cols(), Span(0));
  for (Eigen::Index i = 0; i < Y.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      for (Eigen::Index l = 0; l < Y.cols(); ++l) result(i, j) += Y(i, l) * A(l, j);
    }
  }
  return result;
}

/// By how much Krawczyk's operator shrinks a box around an equilibrium: the largest share of a radius that
/// its image has.
double krawczyk(const Balanced& at, double radius, double force_radius) {
  BoxEquations equations(at);
  Vector<Span> point(equations.size), box(equations.size);
  Vector<double> r(equations.size);
  for (Eigen::Index j = 0; j < equations.size; ++j) {
    const double x = at.unknown[static_cast<std::size_t>(j)];
    r(j) = j < static_cast<Eigen::Index>(at.chain.size()) ? radius : force_radius;
    point(j) = Span(x);
    box(j) = Span(x - r(j), x + r(j));
  }
  const Eigen::MatrixXd Y = middle(equations.derivative(point)).inverse();
  Matrix<Span> defect = -applied(Y, equations.derivative(box));
  for (Eigen::Index i = 0; i < equations.size; ++i) defect(i, i) += Span(1);
  const Vector<double> off = applied(Y, equations.value(point)).unaryExpr(magnitude_of);
  const Vector<double> image = defect.unaryExpr(magnitude_of) * r + off;
  return image.cwiseQuotient(r).maxCoeff();
}

/// Whether one interval Newton step leads from a box into its inside; each unknown is cut before the next one
/// is looked at.
bool newton_keeps_inside(const Balanced& at, const Vector<Span>& box) {
  BoxEquations equations(at);
  Vector<Span> z = box, centre(equations.size);
  for (Eigen::Index j = 0; j < equations.size; ++j) centre(j) = Span(box(j).middle());
  const Matrix<Span> A = equations.derivative(box);
  const Eigen::MatrixXd Y = middle(A).inverse();
  const Matrix<Span> G = applied(Y, A);
  const Vector<Span> off = applied(Y, equations.value(centre));
  for (Eigen::Index i = 0; i < equations.size; ++i) {
    Span sum = off(i);
    for (Eigen::Index j = 0; j < equations.size; ++j) {
      if (j != i) sum += G(i, j) * (z(j) - centre(j));
    }
    if (G(i, i).contains(0)) return false;
    z(i) = intersection(z(i), centre(i) - sum / G(i, i));
    if (!(box(i).low < z(i).low && z(i).high < box(i).high)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("where the force and one end of the chain are known the moments tell all box_angles") {
  // from the base on, held or under a force so large that the ranges of the joints say little
  for (const Balanced& at : {held(), pushed(20)}) {
    Box z = at.system.everything();
    const Box near = at.near(1e-11);
    z[0] = near[0];
    for (std::size_t j = 4; j < at.unknown.size(); ++j) z[j] = near[j];
    REQUIRE(z[2].width() > 4);
    REQUIRE(at.system.narrow(z));
    // an error grows by less than a hundred from joint to joint: 1 + |F| L / k < 100
    CHECK(at.found_in(z, 1e-4));
  }
  // from the free end on: at a passive base nothing else is known of the moments
  const Balanced loose = held_on_a_passive_base();
  Box z = loose.system.everything();
  const Box near = loose.near(1e-11);
  for (const std::size_t j : {3U, 4U, 5U}) z[j] = near[j];
  REQUIRE(loose.system.narrow(z));
  CHECK(loose.found_in(z, 1e-4));
  // and a direction that the moments forbid leaves nothing
  for (const Balanced& at : {held(), pushed(20)}) {
    for (const double off : {-1e-3, 1e-3}) {
      Box wrong = at.near(1e-11);
      wrong[2] = wrong[2] + Span(off);
      CHECK_FALSE(at.system.narrow(wrong));
    }
  }
}

TEST_CASE("where the box_angles are known the moments tell the force, however large it may be") {
  for (const Balanced& at : {held(), held(0.75), held_on_a_passive_base()}) {
    for (const bool known_x : {false, true}) {
      for (const bool known_y : {false, true}) {
        Box z = at.near(1e-11);
        CAPTURE(known_x);
        CAPTURE(known_y);
        CAPTURE(at.chain.stiffness()[0].text(3));
        if (!known_x) z[4] = Span::everything();
        if (!known_y) z[5] = Span::everything();
        REQUIRE(at.system.narrow(z));
        CHECK(at.found_in(z, 1e-8));
      }
    }
  }
  // two box_angles and one part of the force tell the other part, and so the rest of the chain
  const Balanced at = held();
  for (const std::size_t open : {4U, 5U}) {
    Box z = at.system.everything();
    const Box near = at.near(1e-11);
    z[0] = near[0], z[1] = near[1];
    z[open == 4 ? 5 : 4] = near[open == 4 ? 5 : 4];
    z[open] = Span(-100, 100);
    REQUIRE(at.system.narrow(z));
    CHECK(at.found_in(z, 1e-4));
  }
}

TEST_CASE("a box is kept where Krawczyk's operator, by the equations of a branch, maps it well inside") {
  // pushed so hard that the rows of the matrix change places where it is inverted
  for (const Balanced& at : {held(), held_on_a_passive_base(), pushed(), pushed(4)}) {
    Midpoint centre{};
    std::copy(at.unknown.begin(), at.unknown.end(), centre.begin());
    for (const double force_share : {0.3, 1.0, 3.0}) {
      double low = 1e-6, high = 1;  // contracted at `low`, and not at `high`
      REQUIRE(krawczyk(at, low, force_share * low) < 0.95);
      REQUIRE(krawczyk(at, high, force_share * high) > 0.95);
      while (high > 1.001 * low) {
        const double radius = std::sqrt(low * high);
        (krawczyk(at, radius, force_share * radius) < 0.95 ? low : high) = radius;
      }
      CHECK(at.system.contracts(centre, 0.999 * low, 0.999 * force_share * low));
      CHECK_FALSE(at.system.contracts(centre, 1.001 * high, 1.001 * force_share * high));
    }
    // nor beside the equilibrium
    for (std::size_t j = 0; j < at.unknown.size(); ++j) {
      Midpoint beside = centre;
      beside[j] += 1e-3;
      CHECK_FALSE(at.system.contracts(beside, 1e-4, 1e-4));
    }
  }
}

TEST_CASE("the box of an equilibrium is the largest, of halved ones, that Newton's step keeps inside") {
  for (const Balanced& at : {held(), held(0.75), held_on_a_passive_base(), pushed(), pushed(4), pushed(20)}) {
    Midpoint root{};
    std::copy(at.unknown.begin(), at.unknown.end(), root.begin());
    const auto box = at.system.isolate(root);
    REQUIRE(box);
    Vector<Span> kept(static_cast<Eigen::Index>(at.unknown.size())), doubled = kept;
    for (std::size_t j = 0; j < at.unknown.size(); ++j) {
      const Span& z = (*box)[j];
      CHECK(z.contains(at.unknown[j]));
      CHECK(std::abs(z.middle() - at.unknown[j]) < 1e-9);
      const double radius = j < 4 ? 0.4 * std::pow(0.5, std::round(std::log2(0.4 / (z.width() / 2))))
                                  : at.system.force_of((*box)[0].width() / 2);
      CHECK(std::abs(z.width() / 2 - radius) < 1e-12);
      kept(static_cast<Eigen::Index>(j)) = z;
      doubled(static_cast<Eigen::Index>(j)) = Span(z.low - radius, z.high + radius);
    }
    CHECK(newton_keeps_inside(at, kept));
    CHECK_FALSE(newton_keeps_inside(at, doubled));
  }
}

TEST_CASE("what is left of a small box is less than the square of its width, and holds the equilibrium") {
  for (const Balanced& at : {held(), held_on_a_passive_base(), pushed()}) {
    for (const double off : {1e-2, 1e-4, 1e-6}) {
      Box z = at.near(off);
      REQUIRE(at.system.narrow(z));
      CHECK(at.found_in(z, 1e-12));  // 8 rounds
    }
  }
}

TEST_CASE(
    "a box is narrowed to the equilibrium in it in any unit of force, however wide the force is there") {
  for (const double unit : {0x1p-12, 1.0, 0x1p12}) {
    const Balanced at(Control::end_point, box_lengths, {1.5 * unit, unit, 2 * unit, 0.75 * unit}, box_angles,
                      {-0.7 * unit, 0.3 * unit});
    for (const double off : {0.01, 0.05, 0.2}) {
      CAPTURE(unit);
      CAPTURE(off);
      Box z = at.near(off);
      for (const std::size_t j : {4U, 5U}) z[j] = Span(at.unknown[j]) + unit * Span(-0.1, 0.1);
      REQUIRE(at.system.narrow(z));
      // a step squares what is left, up to a factor: 8 rounds lead to a few roundings of numbers near one
      for (std::size_t j = 0; j < 6; ++j) {
        const double scale = j < 4 ? 1 : unit;
        CAPTURE(j);
        CHECK(z[j].width() < 1e-12 * scale);
        CHECK(std::abs(z[j].middle() - at.unknown[j]) < 1e-12 * scale);
      }
    }
  }
}

TEST_CASE("Newton's method ends at the equilibrium beside which it starts") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> off(-0.1, 0.1);
  for (const Balanced& at : {held(), held_on_a_passive_base(), pushed()}) {
    for (int trial = 0; trial < 20; ++trial) {
      Box z = at.near(1e-3);
      for (std::size_t j = 0; j < at.unknown.size(); ++j) z[j] = z[j] + Span(off(random));
      const auto root = at.system.root_near(z);
      REQUIRE(root);
      for (std::size_t j = 0; j < at.unknown.size(); ++j) CHECK(std::abs((*root)[j] - at.unknown[j]) < 1e-12);
    }
  }
}

TEST_CASE("everything is what the ranges of the joints and the bound on the force leave") {
  // under a force each joint turns by the moment of the force about it at most, over its stiffness
  const Balanced forced = pushed();
  const Box all = forced.system.everything();
  double low = 0, high = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double reach = 0;
    for (std::size_t j = i; j < 4; ++j) reach += box_lengths[j];
    const double rest = static_cast<double>(forced.chain.rest()[i].middle()),
                 turn = reach * (0.7 + 0.3) / box_stiffnesses[i];
    low += rest - turn, high += rest + turn;
    CHECK(std::abs(all[i].low - low) < 1e-12);
    CHECK(std::abs(all[i].high - high) < 1e-12);
    CHECK(forced.system.range(i).contains(rest));
    CHECK(std::abs(forced.system.range(i).width() - 2 * turn) < 1e-12);
  }
  // held: half a turn around rest; and the links, were they all on one line, miss the end point by `gap` or
  // more, so that some of them turns by as much as moves the end of the chain so far
  for (const Balanced& at : {held(), held_on_a_passive_base()}) {
    const Window window = unwound(at.chain);
    double gap = 1e9,
           distance =
               std::hypot(static_cast<double>(at.load.x.middle()), static_cast<double>(at.load.y.middle())),
           bend = 0, moment = 0;
    for (int signs = 0; signs < 16; ++signs) {
      double sum = 0;
      for (std::size_t i = 0; i < 4; ++i) sum += ((signs >> i) & 1) != 0 ? box_lengths[i] : -box_lengths[i];
      gap = std::min(gap, std::abs(distance - std::abs(sum)));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      bend += 4 / box_lengths[i];
      const Interval rest = at.chain.rest()[i];
      for (const auto& end : {window[i].lower(), window[i].upper()}) {
        if (!at.chain.passive_joint(i))
          moment = std::max(moment, std::abs(static_cast<double>(
                                        (at.chain.stiffness()[i] * (Interval(end, end) - rest)).middle())));
      }
    }
    const double delta = (std::sqrt(1 + 4 * bend * gap) - 1) / (2 * bend), bound = 1.001 * moment / delta;
    const Box held_all = at.system.everything();
    for (const std::size_t j : {4U, 5U}) {
      CHECK(std::abs(held_all[j].high / bound - 1) < 1e-9);
      CHECK(std::abs(held_all[j].low / bound + 1) < 1e-9);
    }
    for (std::size_t i = 0; i < 4; ++i) CHECK(at.system.passive(i) == (at.chain.passive_joint(i)));
    // what the window leaves of the box_angles, one joint after another
    CHECK(at.system.widest(held_all) == 3);
    Box z = held_all;
    z[1] = Span(-100, 100);
    CHECK(at.system.widest(z) == 1);
  }
}

TEST_CASE("what a census cannot search is refused: too many links, loads too large, places out of reach") {
  const auto ones = [](std::size_t n) { return std::vector<Interval>(n, Interval(1)); };
  const auto forced = [&](std::size_t n, int force) {
    return EquilibriumBox(Chain<Interval>(ones(n), ones(n)), Control::force,
                          {Interval(-force), Interval(force)}, {});
  };
  CHECK(forced(16, 1).links() == 16);
  CHECK_THROWS_WITH_AS(forced(17, 1), "census: found 17 links, expected at most 16", Error);
  CHECK(forced(1, 49000).unknowns() == 1);  // z F / k, F the sum of the sizes of both parts
  CHECK_THROWS_WITH_AS(
      forced(1, 51000),
      "census: found joint 1 turned by more than 1e5 rad, expected a load that the springs can bear, and "
      "rest angles of a few turns",
      Error);
  CHECK_THROWS_AS(forced(2, 26000), Error);  // twice the distance at the base
  const auto held_at = [&](const std::vector<Interval>& length, const Rational& x) {
    const Chain<Interval> chain(length, ones(length.size()));
    return EquilibriumBox(chain, Control::end_point, {Interval(x), Interval(0)}, unwound(chain));
  };
  CHECK(held_at({1, 2}, Rational(3, 2)).unknowns() == 4);
  CHECK(held_at({1, 2}, Rational(3, 2)).held());
  CHECK_THROWS_WITH_AS(
      held_at({1, 2}, 4),
      "end point: found 1.33333 of the chain's reach from the base, expected between 0.333333 "
      "and 1 of it, both excluded",
      Error);
  for (const Rational& x : {Rational(3), Rational(1), Rational(1, 2)})
    CHECK_THROWS_AS(held_at({1, 2}, x), Error);
  // within reach, and still in one line: 1 + 1 - 2 + 4 = 4
  CHECK_THROWS_AS(held_at({1, 1, 2, 4}, 4), Error);
  CHECK(held_at({1, 1, 2, 4}, Rational(41, 10)).unknowns() == 6);
}

TEST_CASE("one link is narrowed, solved and isolated as many are") {
  // theta = 4 sin theta under a force of 4 k / L
  const EquilibriumBox one(Chain<Interval>({1}, {1}), Control::force, {Interval(-4), Interval(0)}, {});
  const double bent = 2.474576787369829;
  CHECK(one.everything()[0].high == close_to(4).epsilon(1e-14));
  CHECK(one.everything()[0].low == close_to(-4).epsilon(1e-14));
  for (const double theta : {0.0, bent, -bent}) {
    Box near;
    near[0] = Span(theta - 0.2, theta + 0.3);
    const auto root = one.root_near(near);
    REQUIRE(root);
    CHECK(std::abs((*root)[0] - theta) < 1e-14);
    const auto alone = one.isolate(*root);
    REQUIRE(alone);
    CHECK((*alone)[0].contains(theta));
    CHECK((*alone)[0].width() > 0.05);
    REQUIRE(one.narrow(near));
    CHECK(near[0].contains(theta));
    CHECK(near[0].width() < 0.1);
    CHECK(one.contracts(*root, 1e-3, 1e-3));
    CHECK_FALSE(one.contracts({theta + 0.01}, 1e-3, 1e-3));
  }
  Box none;
  none[0] = Span(0.5, 1.5);
  CHECK_FALSE(one.narrow(none));
}
