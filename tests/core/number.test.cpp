#include <plumbline/base/number.hpp>

#include <doctest/doctest.h>

#include <plumbline/base/interval.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/straight/algorithm1.hpp>
#include <plumbline/straight/critical_force.hpp>

using namespace plumbline;

namespace {

template <class Real>
concept HasEndPoint = requires(Chain<Real> chain, std::vector<Real> q) {
  end_point(chain, q);
};
template <class Real>
concept HasEigenvalues = requires(Chain<Real> chain) {
  algorithm1(chain);
};
template <class Real>
concept HasCount = requires(Chain<Real> chain, Real F) {
  count_below(chain, F);
};

// what a type cannot do does not compile
static_assert(HasEndPoint<double> && HasEndPoint<Mpfr50> && HasEndPoint<Interval>);
static_assert(!HasEndPoint<Rational>, "a sine is not rational");
static_assert(HasEigenvalues<double> && HasEigenvalues<Mpfr50>);
static_assert(!HasEigenvalues<Rational> && !HasEigenvalues<Interval>, "eigenvalues are rounded numbers");
static_assert(HasCount<double> && HasCount<Mpfr50> && HasCount<Rational>);
static_assert(!HasCount<Interval>, "a sign may be undecided");

}  // namespace

TEST_CASE("a fraction becomes the nearest double, not the truncated one") {
  const Rational just_above_half_ulp = Rational(1) + Rational(3, Integer(1) << 54);
  CHECK(from_rational<double>(just_above_half_ulp) == 1 + std::numeric_limits<double>::epsilon());
  CHECK(from_rational<double>(Rational(1, 10)) == 0.1);
  CHECK(from_rational<Rational>(Rational(1, 10)) == Rational(1, 10));
}

TEST_CASE("epsilon is the distance from 1 to the next number") {
  CHECK(Mpfr50(1) + epsilon<Mpfr50>() > 1);
  CHECK(Mpfr50(1) + epsilon<Mpfr50>() / 4 == 1);
  CHECK(Mpfr(1) + epsilon<Mpfr>() > 1);
  CHECK(Mpfr(1) + epsilon<Mpfr>() / 4 == 1);
}
