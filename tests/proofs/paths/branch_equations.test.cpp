#include "proofs/paths/branch_equations.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "proofs/exact/as_double.hpp"
#include "proofs/exact/inertia.hpp"
#include "proofs/paths/interval_equations.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Any chain under any loading, all of it in sixty-fourths.
struct AnyEquations {
  Chain<Interval> chain;
  Loading<Interval> loading;
  std::mt19937& random;

  AnyEquations(std::mt19937& random_, Control control)
      : chain(numbers(random_, 16, 128), numbers(random_, 16, 128), numbers(random_, -64, 64)),
        loading{control, {number(random_, -64, 64), number(random_, -64, 64)}, {}},
        random(random_) {
    loading.direction = {number(random_, -64, 64), number(random_, -64, 64)};
  }

  /// So many numbers, as they are in all types.
  [[nodiscard]] Vector<double> point(Eigen::Index size) const {
    Vector<double> u(size);
    for (double& x : u) x = as_double(number(random, -64, 64));
    return u;
  }

 private:
  static Interval number(std::mt19937& from, int low, int high) {
    return Interval(Rational(std::uniform_int_distribution<int>(low, high)(from), 64));
  }
  static std::vector<Interval> numbers(std::mt19937& from, int low, int high) {
    std::vector<Interval> values;
    for (int i = 0; i < 4; ++i) values.push_back(number(from, low, high));
    return values;
  }
};

Vector<Interval> in_intervals(const Vector<double>& x) {
  return x.unaryExpr([](double one) { return Interval::from_double(one); });
}

/// That an enclosure holds what a finer one does, and is no wider than some dozen roundings of numbers below
/// a hundred.
void check_holds(const Span& wide, const Interval& fine) {
  CHECK(wide.low <= as_double(fine));
  CHECK(as_double(fine) <= wide.high);
  CHECK(wide.width() < 1e-12);
}

}  // namespace

TEST_CASE("the equations of a branch and their derivatives are those in intervals of sixty-four digits") {
  std::mt19937 random(31);
  for (const Control control : {Control::end_point, Control::force}) {
    const bool held = control == Control::end_point;
    for (int trial = 0; trial < 10; ++trial) {
      const AnyEquations any(random, control);
      BranchEquations equations(any.chain, any.loading);
      const Eigen::Index size = held ? 7 : 5, m = size - 1;
      REQUIRE(equations.unknowns() == size);
      const Vector<double> u = any.point(size), v = any.point(size), w = any.point(size),
                           normal = any.point(size);
      const Vector<Span> box = u.cast<Span>();
      CHECK(equations.load(box).middle() == u(m));
      const IntervalEquations fine(any.chain, any.loading);
      const LocalEquations at = fine.at(in_intervals(u), IntervalVector::Constant(m, Interval(0)));
      const Vector<Span> value = equations.value(box);
      const Matrix<Span> derivative = equations.derivative(box, normal.cast<Span>());
      REQUIRE(value.size() == size);
      for (Eigen::Index i = 0; i < m; ++i) {
        CAPTURE(i);
        check_holds(value(i), at.value(i));
        for (Eigen::Index j = 0; j < size; ++j) {
          CAPTURE(j);
          check_holds(derivative(i, j), at.derivative(i, j));
        }
      }
      // the last row is that of a plane through the point
      CHECK(value(m).low == 0);
      CHECK(value(m).high == 0);
      for (Eigen::Index j = 0; j < size; ++j) CHECK(derivative(m, j).middle() == normal(j));
      // psi . E'' v w for each psi that takes one equation
      const Vector<Span> second = equations.second(box, v.cast<Span>(), w.cast<Span>());
      for (Eigen::Index i = 0; i < m; ++i) {
        CAPTURE(i);
        IntervalVector psi = IntervalVector::Constant(m, Interval(0));
        psi(i) = Interval(1);
        const Matrix<Interval> bend = fine.at(in_intervals(u), psi).bend;
        Interval sum(0);
        for (Eigen::Index j = 0; j < size; ++j) {
          for (Eigen::Index k = 0; k < size; ++k)
            sum = sum + bend(j, k) * Interval::from_double(v(j)) * Interval::from_double(w(k));
        }
        check_holds(second(i), sum);
      }
      CHECK(second(m).magnitude() == 0);
      // a difference of second derivatives over 2 h is off by h^2 of the fifth, and by 1e-13 over h
      constexpr double h = 1e-4;
      const Vector<double> ahead = u + h * v, behind = u - h * v;
      const Vector<Span> vs = v.cast<Span>(), a = equations.second(ahead.cast<Span>(), vs, vs),
                         b = equations.second(behind.cast<Span>(), vs, vs), third = equations.third(box, vs);
      for (Eigen::Index i = 0; i < size; ++i) {
        CAPTURE(i);
        CHECK(std::abs((a(i).middle() - b(i).middle()) / (2 * h) - third(i).middle()) < 1e-6);
        CHECK(third(i).width() < 1e-12);
      }
    }
  }
}

TEST_CASE(
    "how the tangent stiffness goes follows from three rates of force and way, held and under a force") {
  std::mt19937 random(32);
  for (const Control control : {Control::end_point, Control::force}) {
    const bool held = control == Control::end_point;
    for (int trial = 0; trial < 10; ++trial) {
      const AnyEquations any(random, control);
      BranchEquations equations(any.chain, any.loading);
      const Eigen::Index size = equations.unknowns();
      const Vector<double> u = any.point(size);
      const std::array<Vector<double>, 3> rate{any.point(size), any.point(size), any.point(size)};
      const Point<double> d{as_double(any.loading.direction.x), as_double(any.loading.direction.y)};
      std::array<double, 3> push, way;
      if (held) {
        for (std::size_t k = 0; k < 3; ++k) {
          push[k] = d.x * rate[k](4) + d.y * rate[k](5);
          way[k] = rate[k](6);
        }
      } else {
        // the way along u + a s + b s^2 / 2 + c s^3 / 6, by differences over 1e-12 in fifty digits
        const auto place = [&](const Mpfr50& s) {
          Mpfr50 sum(0);
          for (Eigen::Index i = 0; i < 4; ++i) {
            const Mpfr50 theta =
                u(i) + s * (rate[0](i) + s * (rate[1](i) / Mpfr50(2) + s * rate[2](i) / Mpfr50(6)));
            sum += as_double(any.chain.length()[static_cast<std::size_t>(i)]) *
                   (d.x * cos(theta) + d.y * sin(theta));
          }
          return sum;
        };
        const Mpfr50 h("1e-12"), p1 = place(h), m1 = place(-h), p2 = place(2 * h), m2 = place(-2 * h);
        way = {static_cast<double>((p1 - m1) / (2 * h)),
               static_cast<double>((p1 - 2 * place(0) + m1) / (h * h)),
               static_cast<double>((p2 - 2 * p1 + 2 * m1 - m2) / (2 * h * h * h))};
        for (std::size_t k = 0; k < 3; ++k) push[k] = rate[k](4);
      }
      const StiffnessChange change = equations.stiffness(
          u.cast<Span>(), {rate[0].cast<Span>(), rate[1].cast<Span>(), rate[2].cast<Span>()});
      // sums of a dozen terms below a hundred, and what a difference over 1e-12 leaves out
      const auto near = [](const Span& found, double expected) {
        CHECK(std::abs(found.middle() - expected) < 1e-12);
        CHECK(found.width() < 1e-11);
      };
      near(change.way, way[0]);
      near(change.value, push[0] * way[0]);
      near(change.slope, push[1] * way[0] - push[0] * way[1]);
      near(change.bend, push[2] * way[0] - push[0] * way[2]);
    }
  }
}

TEST_CASE("negative directions are those of the stiffness, less one for each coordinate that is held") {
  std::mt19937 random(33);
  for (const Control control : {Control::end_point, Control::force}) {
    const Eigen::Index borders = control == Control::end_point ? 2 : 0;
    int unstable = 0;
    for (int trial = 0; trial < 40; ++trial) {
      const AnyEquations any(random, control);
      BranchEquations equations(any.chain, any.loading);
      Vector<double> u = any.point(equations.unknowns());
      u.tail(3 - (borders == 0 ? 2 : 0)) *= 3;  // forces that do make it unstable
      const Vector<Span> box = u.cast<Span>();
      const Eigen::MatrixXd all = middle(equations.derivative(box, box));
      Eigen::MatrixXd K = all.topLeftCorner(4 + borders, 4 + borders);
      for (Eigen::Index a = 4; a < 4 + borders; ++a) K.col(a).head(4) = K.row(a).head(4).transpose();
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
      if (values.cwiseAbs().minCoeff() < 1e-6) continue;
      const auto negative = static_cast<std::size_t>((values.array() < 0).count() - borders);
      CHECK(equations.negative_directions(box) == negative);
      unstable += negative > 0 ? 1 : 0;
      // nothing is said of a box that holds a stiffness of either kind
      const Vector<Span> wide = u.unaryExpr([](double x) { return Span(x - 3, x + 3); });
      CHECK_FALSE(equations.negative_directions(wide));
    }
    CHECK(unstable > 5);
  }
}

TEST_CASE(
    "a point in double precision has the angles, then the force where the end point is held, then the load") {
  std::mt19937 random(34);
  BranchPoint<double> point{};
  point.theta = Vector<double>::LinSpaced(4, 1, 4);
  point.force = {5, 6};
  point.load = 7;
  for (const Control control : {Control::end_point, Control::force}) {
    const AnyEquations any(random, control);
    const Vector<Span> u = BranchEquations(any.chain, any.loading).at(point);
    const std::vector<double> expected = control == Control::end_point
                                             ? std::vector<double>{1, 2, 3, 4, 5, 6, 7}
                                             : std::vector<double>{1, 2, 3, 4, 7};
    REQUIRE(u.size() == static_cast<Eigen::Index>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CHECK(u(static_cast<Eigen::Index>(i)).low == expected[i]);
      CHECK(u(static_cast<Eigen::Index>(i)).high == expected[i]);
    }
  }
}
