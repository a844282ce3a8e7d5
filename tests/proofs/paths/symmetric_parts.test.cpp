#include "proofs/paths/symmetric_parts.hpp"

#include <doctest/doctest.h>

#include <plumbline/loaded/nominal_model.hpp>
#include <random>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// The equations at u, angles and then the force where the end point is held, to fifty digits.
Vector<Mpfr50> equations(const NominalModel<Mpfr50>& model, const Loading<Mpfr50>& loading,
                         const Mpfr50& load, const Vector<Mpfr50>& u) {
  const auto n = static_cast<Eigen::Index>(model.chain().size());
  const bool held = loading.control == Control::end_point;
  const Point<Mpfr50> ray = loading.at(load);
  Expansion<Mpfr50, 1> at;
  model.expand(u.head(n), held ? Point<Mpfr50>{u(n), u(n + 1)} : ray, at);
  Vector<Mpfr50> E(u.size());
  E.head(n) = at.residual;
  if (held) E(n) = at.end_point.x - ray.x, E(n + 1) = at.end_point.y - ray.y;
  return E;
}

bool holds(const Span& span, const Mpfr50& value) {
  // differences over 1e-18 are off by 1e-18 of the third derivative, and rounded at 1e-32
  const Mpfr50 slack("1e-15");
  return span.low <= value + slack && value - slack <= span.high;
}

}  // namespace

TEST_CASE("even and odd parts, and their derivatives, are those of the equations, held and under a force") {
  std::mt19937 random(9);
  std::uniform_int_distribution<int> sixtyfourth(-64, 64), positive(16, 128);
  const auto some = [&] { return Rational(sixtyfourth(random), 64); };
  for (int trial = 0; trial < 40; ++trial) {
    const bool held = trial % 2 == 0;
    std::vector<Rational> length, stiffness, rest;
    for (int i = 0; i < 4; ++i) {
      length.emplace_back(positive(random), 64);
      stiffness.emplace_back(positive(random), 64);
      rest.push_back(some());
    }
    const Chain<Rational> chain(length, stiffness, rest);
    const Loading<Rational> loading{
        held ? Control::end_point : Control::force, {some(), some()}, {Rational(-3, 5), Rational(4, 5)}};
    const auto as = [&]<class Real>(const Real&) {
      const auto point = [](const Point<Rational>& p) { return Point<Real>{Real(p.x), Real(p.y)}; };
      return Loading<Real>{loading.control, point(loading.start), point(loading.direction)};
    };
    const SymmetricParts parts(from_rational<Interval>(chain), as(Interval()), {true, true});
    const NominalModel<Mpfr50> model(from_rational<Mpfr50>(chain));
    const Loading<Mpfr50> exactly = as(Mpfr50());
    const Eigen::Index size = parts.size();
    Vector<Mpfr50> m(size), v(size);
    for (Eigen::Index i = 0; i < size; ++i) m(i) = Mpfr50(some()), v(i) = Mpfr50(some());
    const Mpfr50 load(some()), a(Rational(positive(random), 512));
    const auto even = [&](const auto& mean, const auto& way, const Mpfr50& at) {
      return Vector<Mpfr50>(
          (equations(model, exactly, at, mean + a * way) + equations(model, exactly, at, mean - a * way)) /
          Mpfr50(2));
    };
    const auto odd = [&](const auto& mean, const auto& way, const Mpfr50& at) {
      return Vector<Mpfr50>(
          (equations(model, exactly, at, mean + a * way) - equations(model, exactly, at, mean - a * way)) /
          (2 * a));
    };
    const auto spans = [](const Vector<Mpfr50>& u) {
      return Vector<Span>(u.unaryExpr([](const Mpfr50& x) { return Span(static_cast<double>(x)); }));
    };
    const Parts found =
        parts.at(spans(m), Span(static_cast<double>(load)), spans(v), Span(static_cast<double>(a)));
    const Vector<Mpfr50> E = even(m, v, load), O = odd(m, v, load);
    for (Eigen::Index i = 0; i < size; ++i) {
      CHECK(holds(found.even(i), E(i)));
      CHECK(holds(found.odd(i), O(i)));
    }
    const Mpfr50 h("1e-18");
    for (Eigen::Index j = 0; j < size; ++j) {
      const Vector<Mpfr50> step = h * Vector<Mpfr50>::Unit(size, j);
      const auto rate = [&](const auto& part, bool mean) {
        return Vector<Mpfr50>((part(mean ? m + step : m, mean ? v : v + step, load) -
                               part(mean ? m - step : m, mean ? v : v - step, load)) /
                              (2 * h));
      };
      const Vector<Mpfr50> em = rate(even, true), om = rate(odd, true), ev = rate(even, false),
                           ov = rate(odd, false);
      for (Eigen::Index i = 0; i < size; ++i) {
        CAPTURE(i);
        CAPTURE(j);
        CHECK(holds(found.even_by_mean(i, j), em(i)));
        CHECK(holds(found.odd_by_mean(i, j), om(i)));
        CHECK(holds(found.even_by_bend(i, j), ev(i)));
        CHECK(holds(found.odd_by_bend(i, j), ov(i)));
      }
    }
    const Vector<Mpfr50> el = (even(m, v, load + h) - even(m, v, load - h)) / (2 * h),
                         ol = (odd(m, v, load + h) - odd(m, v, load - h)) / (2 * h);
    for (Eigen::Index i = 0; i < size; ++i) {
      CHECK(holds(found.even_by_load(i), el(i)));
      CHECK(holds(found.odd_by_load(i), ol(i)));
    }
  }
}

TEST_CASE("the equations of a symmetric shape are symmetric, and a bend adds antisymmetric ones") {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> sixtyfourth(-64, 64);
  const Rational a(1, 3);
  struct Symmetric {
    std::vector<Rational> length, stiffness, rest;
    Control control;
    Symmetry symmetry;
    Eigen::Index means;  ///< so many angles and forces are free in a symmetric shape
  };
  const std::vector<Symmetric> all{
      {{1, 2, 3}, {4, 5, 6}, {0, 0, 0}, Control::force, {false, true}, 0},
      {{1, 2, 3}, {4, 5, 6}, {0, 0, 0}, Control::end_point, {false, true}, 1},
      {{1, 2, 1}, {0, 3, 3}, {0, a, -a}, Control::end_point, {true, false}, 4},
      {{1, 2, 2, 1}, {0, 3, 4, 3}, {0, a, 0, -a}, Control::end_point, {true, false}, 4},
      {{1, 2, 1}, {0, 3, 3}, {0, 0, 0}, Control::end_point, {true, true}, 2},
      {{1, 2, 2, 1}, {0, 3, 4, 3}, {0, 0, 0, 0}, Control::end_point, {true, true}, 3}};
  for (const Symmetric& one : all) {
    const auto chain = from_rational<Interval>(Chain<Rational>(one.length, one.stiffness, one.rest));
    const SymmetricParts parts(chain, {one.control, {Interval(5), Interval(0)}, {Interval(-1), Interval(0)}},
                               one.symmetry);
    const Eigen::MatrixXd &B = parts.mean(), &N = parts.bend_basis();
    CHECK(B.cols() == one.means);
    REQUIRE(B.cols() + N.cols() == parts.size());
    if (one.means > 0) CHECK((B.transpose() * N).isZero(0));
    const auto some = [&](const Eigen::MatrixXd& basis) {
      Vector<double> u = Vector<double>::Zero(parts.size());
      for (Eigen::Index j = 0; j < basis.cols(); ++j) u += sixtyfourth(random) / 64.0 * basis.col(j);
      return Vector<Span>(u.cast<Span>());
    };
    // no amplitude: the parts are the equations at the mean, and their derivative along the bend
    const Parts p = parts.at(some(B), Span(0.5), some(N), Span(0));
    const auto none_of = [&](const Eigen::MatrixXd& basis, const Vector<Span>& part) {
      for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        Span share(0);
        for (Eigen::Index i = 0; i < part.size(); ++i) share += basis(i, j) * part(i);
        // numbers below a hundred, some twenty roundings of them
        CHECK(share.contains(0));
        CHECK(share.width() < 1e-12);
      }
    };
    none_of(N, p.even);
    none_of(B, p.odd);
  }
}

TEST_CASE("the parts of a bent link are as wide as the square of its bend over two, and no wider") {
  // cos y lies between 1 - y^2 / 2 and 1, sin y / y between 1 - y^2 / 6 and 1: so much the parts may leave
  // open of a link that is bent by y, of which cosines take a share of the force across and sines along the
  // link
  const Chain<Interval> chain({Interval(1)}, {Interval(1)});
  const SymmetricParts parts(chain, {Control::force, {Interval(0), Interval(0)}, {Interval(1), Interval(0)}},
                             {false, true});
  for (const double y : {1.0 / 4, 1.0 / 64, 1.0 / 1024}) {
    const Parts p =
        parts.at(Vector<Span>::Constant(1, Span(1)), Span(1), Vector<Span>::Constant(1, Span(1)), Span(y));
    // a few roundings of numbers near one
    const double rounding = 1e-14, across = std::sin(1.0), along = std::cos(1.0);
    CHECK(p.even(0).width() < y * y / 2 * across + rounding);
    CHECK(p.odd(0).width() < y * y / 6 * along + rounding);
    CHECK(p.even(0).contains(1 + std::cos(y) * across));
    CHECK(p.odd(0).contains(1 + std::sin(y) / y * along));
  }
}
