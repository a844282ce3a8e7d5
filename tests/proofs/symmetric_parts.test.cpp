#include "proofs/symmetric_parts.hpp"

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
