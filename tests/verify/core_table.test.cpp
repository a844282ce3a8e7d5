#include "verify/core/core_table.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/sampled/algorithm1_instances.hpp"

using namespace plumbline;
using namespace plumbline::verify;

namespace {

/// Two to six links, lengths and stiffnesses from 1 to 9, one base in four passive: chains that every number
/// type resolves.
Chain<Rational> arbitrary_chain() {
  const auto links = static_cast<std::size_t>(*rc::gen::inRange(2, 7));
  const auto numbers = [&](int least) {
    const auto list = *rc::gen::container<std::vector<int>>(links, rc::gen::inRange(1, 10));
    std::vector<Rational> rationals;
    for (const int one : list) rationals.emplace_back(one);
    if (least == 0 && *rc::gen::inRange(0, 4) == 0) rationals.front() = 0;
    return rationals;
  };
  return Chain<Rational>(numbers(1), numbers(0));
}

/// What a backward error of B^-1 A can make of a force of such a chain, relatively: the matrices are of order
/// seven, their condition below 1e5.
template <Floating Real>
Real allowance() {
  return Real(1e7) * epsilon<Real>();
}

template <Floating Real>
Rational fraction(const Real& x) {
  if constexpr (std::same_as<Real, double>)
    return Rational(x);
  else
    return proofs::exactly(x);
}

}  // namespace

TEST_CASE_TEMPLATE("on arbitrary chains Algorithm 1 finds every force, and the least energy factor the first",
                   Real, double, Mpfr50) {
  rc::check("in the number type", [] {
    using std::abs;
    const Chain<Rational> exact = arbitrary_chain();
    const auto chain = from_rational<Real>(exact);
    const auto modes = algorithm1(chain);
    Real least = modes.front().force;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const Rational low = fraction<Real>(modes[m].force * (Real(1) - allowance<Real>())),
                     high = fraction<Real>(modes[m].force * (Real(1) + allowance<Real>()));
      RC_ASSERT(count_below(exact, low) <= m);
      RC_ASSERT(count_below(exact, high) > m);
      const Real factor = energy_factor(chain, modes[m].q);
      RC_ASSERT(abs(factor / modes[m].force - Real(1)) < allowance<Real>());
      least = std::min(least, factor);
    }
    RC_ASSERT(abs(least / modes.front().force - Real(1)) < allowance<Real>());
  });
}

TEST_CASE_TEMPLATE("the coefficients of the characteristic polynomial are those of the forces", Real, double,
                   Mpfr50) {
  rc::check("in the number type", [] {
    using std::abs;
    const Chain<Rational> exact = arbitrary_chain();
    const proofs::Polynomial polynomial = proofs::characteristic_polynomial(exact);
    RC_ASSERT(proofs::multiplicity_of_zero(polynomial) == 2);
    RC_ASSERT(proofs::rank_of_BinvA(exact) == exact.size());
    Real sum(0);
    for (const Real& force : critical_forces(from_rational<Real>(exact), exact.size() - 1))
      sum += Real(1) / force;
    const auto coefficient = from_rational<Real>(polynomial[exact.size()]);
    RC_ASSERT(abs(sum / coefficient - Real(1)) < Real(1000) * epsilon<Real>());
  });
}

TEST_CASE_TEMPLATE("the forces of bent shapes go to the critical ones as the angle goes to zero", Real,
                   double, Mpfr50) {
  rc::check("quadratically", [] {
    using std::abs, std::sin;
    const Real k(*rc::gen::inRange(1, 100)), L(*rc::gen::inRange(1, 100));
    for (const double angle : {1e-2, 1e-4}) {
      const Real q(angle), force = Real(2) * k * q / (L * sin(q)), off = force / (Real(2) * k / L) - Real(1);
      // q / sin q = 1 + q^2/6 + 7 q^4/360 + …, and a few roundings
      RC_ASSERT(abs(off - q * q / Real(6)) < Real(0.02) * q * q * q * q + Real(16) * epsilon<Real>());
    }
  });
}

TEST_CASE("the table has the five items, holds, and names its worst chains") {
  const CoreTable table = core_table(12, 1);
  REQUIRE(table.lines.size() == 5);
  CHECK(holds(table));
  const std::string text = as_text(table);
  for (const CoreLine& line : table.lines) {
    INFO(line.what);
    CHECK(line.in_mp50.chains + line.in_mp50.refused == 12);
    CHECK(line.in_mp50.refused == 0);
    CHECK(text.find(line.what) != std::string::npos);
    CHECK(text.find("chain " + std::to_string(line.in_double.worst) + ": lengths = [") != std::string::npos);
  }
  // the same seed, the same chains
  CHECK(as_text(core_table(12, 1)) == text);
}
