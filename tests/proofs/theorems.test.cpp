// The theorems of proofs/theorems.md on the linearised chain, in exact arithmetic. A statement about the
// order of critical forces is one about count_below at every force.

#include <doctest/doctest.h>

#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/exact_chain.hpp"
#include "tests/proofs/random_chain.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

using Exact = Chain<Rational>;

/// Forces above, among and below the critical forces of a chain.
std::vector<Rational> probes(const Exact& chain) {
  std::vector<Rational> forces;
  Rational force = sum_of_forces(chain) * Rational(101, 100);
  for (int i = 0; i < 90; ++i, force *= Rational(9, 10)) forces.push_back(force);
  return forces;
}

/// Whether, at every probe F, b has as many critical forces below F as a has, up to so many less or more.
bool counts_within(const Exact& a, const Exact& b, long less, long more) {
  for (const Rational& F : probes(a)) {
    const auto difference = static_cast<long>(count_below(b, F)) - static_cast<long>(count_below(a, F));
    if (difference < -less || difference > more) return false;
  }
  return true;
}

/// Whether F_m(b) >= F_m(a) for every m, as far as the probes can tell.
bool none_lower(const Exact& a, const Exact& b) {
  return counts_within(a, b, static_cast<long>(a.size()), 0);
}

Exact with_length(const Exact& chain, std::size_t i, const Rational& length) {
  auto lengths = chain.length();
  lengths[i] = length;
  return Exact(lengths, chain.stiffness());
}

Exact with_stiffness(const Exact& chain, std::size_t i, const Rational& k) {
  auto stiffness = chain.stiffness();
  stiffness[i] = k;
  return Exact(chain.length(), stiffness);
}

/// Joint i frozen: its link becomes one with the link before it, or with the base.
Exact frozen(const Exact& chain, std::size_t i) {
  auto lengths = chain.length();
  auto stiffness = chain.stiffness();
  if (i > 0) lengths[i - 1] += lengths[i];
  lengths.erase(lengths.begin() + static_cast<std::ptrdiff_t>(i));
  stiffness.erase(stiffness.begin() + static_cast<std::ptrdiff_t>(i));
  return Exact(lengths, stiffness);
}

Exact cut(const Exact& chain) {
  return Exact({chain.length().begin(), chain.length().end() - 1},
               {chain.stiffness().begin(), chain.stiffness().end() - 1});
}

Exact reversed(const Exact& chain) {
  return Exact({chain.length().rbegin(), chain.length().rend()}, [&] {
    std::vector<Rational> k(chain.stiffness().rbegin(), chain.stiffness().rend());
    std::rotate(k.begin(), k.end() - 1, k.end());  // k_1 stays at the base
    return k;
  }());
}

/// The force of the only mode of two links.
Rational two_links(const Rational& L1, const Rational& L2, const Rational& k1, const Rational& k2) {
  return sum_of_forces(Exact({L1, L2}, {k1, k2}));
}

/// The joint angles of (S) at F next to a critical force, closed by s_n = 0.
std::vector<Rational> joint_angles(const Exact& chain, const Rational& F) {
  const auto z = distance_to_end(chain);
  std::vector<Rational> q{1 / z[0]};
  Rational s = 1;
  Rational g = chain.stiffness()[0] / (z[0] * z[0]);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    g -= F * s * chain.length()[i - 1] / (z[i - 1] * z[i]);
    q.push_back(i + 1 < chain.size() ? Rational(z[i] * g / chain.stiffness()[i]) : Rational(-s / z[i]));
    s += z[i] * q.back();
  }
  return q;
}

/// The product of the stiffnesses of all joints but two.
Rational stiffness_but(const Exact& chain, std::size_t i, std::size_t j) {
  Rational product = 1;
  for (std::size_t l = 0; l < chain.size(); ++l)
    if (l != i && l != j) product *= chain.stiffness()[l];
  return product;
}

std::size_t sign_changes(const std::vector<Rational>& values) {
  std::size_t changes = 0;
  int last = 0;
  for (const Rational& x : values) {
    changes += x.sign() * last < 0 ? 1 : 0;
    last = x.sign() != 0 ? x.sign() : last;
  }
  return changes;
}

/// Bounds of critical force m = 1, 2, …, 2^-250 of the sum of all apart: forces over nine decades of random
/// data are then known to 40 digits or more, enough for the sign of a joint angle that is tiny beside the
/// others.
std::pair<Rational, Rational> bounds_of(const Exact& chain, std::size_t m) {
  Rational low = 0, high = sum_of_forces(chain) * 2;
  for (int step = 0; step < 250; ++step) {
    const Rational middle = (low + high) / 2;
    (count_below(chain, middle) < m ? low : high) = middle;
  }
  return {low, high};
}

}  // namespace

TEST_CASE("Closed form: the corollary on the sum of the forces") {
  check_property("sum of the forces", [] {
    const auto chain = random_chain(Passive::any_one, 2, 8);
    const auto& L = chain.length();
    const auto& k = chain.stiffness();
    Rational sum = k[0] * (1 / L[0] - 1 / distance_to_end(chain)[0]);
    for (std::size_t i = 1; i < chain.size(); ++i) sum += k[i] * (1 / L[i - 1] + 1 / L[i]);
    RC_ASSERT(sum_of_forces(chain) == sum);
    RC_ASSERT(sum_of_forces(with_length(chain, 0, L[0] * 2)) != sum);
  });
}

TEST_CASE("Closed form: the corollaries on the product of the forces and the sum of their inverses") {
  check_property("product and sum of inverses", [] {
    const auto chain = random_chain(Passive::any_one, 2, 8);
    const auto z = distance_to_end(chain);
    Rational E1 = 0, E2 = 0, En = z[0];
    for (std::size_t i = 0; i < z.size(); ++i) {
      E1 += z[i] * z[i] * stiffness_but(chain, i, i);
      for (std::size_t j = i + 1; j < z.size(); ++j)
        E2 += z[i] * z[j] * (z[i] - z[j]) * stiffness_but(chain, i, j);
      En *= chain.length()[i];
    }
    RC_ASSERT(product_of_forces(chain) == E1 / En);
    RC_ASSERT(sum_of_inverse_forces(chain) == E2 / E1);
  });
}

TEST_CASE("Spring and mass: both forms on V in the coordinates s") {
  check_property("energy and shortening of a fixed-fixed string of beads", [] {
    const auto chain = random_chain(Passive::any_one, 2, 8);
    const std::size_t n = chain.size();
    const auto z = distance_to_end(chain);
    auto s = random_fractions(n);
    s[n - 1] = 0;
    std::vector<Rational> q;
    Rational springs = 0, masses = 0, wrong_masses = 0, energy = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational step = i == 0 ? s[0] : Rational(s[i] - s[i - 1]);
      q.push_back(step / z[i]);
      energy += chain.stiffness()[i] * q[i] * q[i];
      springs += chain.stiffness()[i] / (z[i] * z[i]) * step * step;
      if (i + 1 < n) masses += (1 / z[i + 1] - 1 / z[i]) * s[i] * s[i];
      if (i + 1 < n) wrong_masses += s[i] * s[i] / z[i + 1];
    }
    RC_ASSERT(springs == energy);
    RC_ASSERT(masses == 2 * small_deflection(chain, q).x);
    RC_ASSERT(wrong_masses != masses);
    RC_ASSERT(small_deflection(chain, q).y == 0);
  });
}

TEST_CASE("Recursion: sign changes count the roots of D below F, at any joint passive") {
  check_property("count_below against Sturm's theorem", [] {
    const auto chain = random_chain(Passive::any_one, 2, 6);
    const Polynomial D = bordered_determinant(chain);
    RC_PRE(distinct_positive_roots(D) == chain.size() - 1);
    for (const Rational& F : probes(chain)) {
      std::vector<Rational> shifted;  // D(x + F)
      for (std::size_t x = 0; x < D.size(); ++x) shifted.push_back(evaluate(D, F + x));
      RC_ASSERT(count_below(chain, F) == distinct_negative_roots(interpolate(shifted)));
    }
  });
}

TEST_CASE("Recursion: a critical force is not below itself, in either family, nor in both") {
  const Exact split({1, 1, 1}, {6, 0, 1});  // 4 below joint 2, 2 above it
  CHECK(count_below(split, Rational(2)) == 0);
  CHECK(count_below(split, Rational(201, 100)) == 1);
  CHECK(count_below(split, Rational(4)) == 1);
  CHECK(count_below(split, Rational(401, 100)) == 2);
  const Exact tied({1, 1, 1}, {3, 0, 1});  // both 2
  CHECK(count_below(tied, Rational(2)) == 0);
  CHECK(count_below(tied, Rational(201, 100)) == 2);
}

TEST_CASE("Simple modes") {
  for (const Passive passive : {Passive::none, Passive::base, Passive::last}) {
    check_property("n - 1 distinct critical forces", [passive] {
      const auto chain = random_chain(passive, 2, 7);
      RC_ASSERT(distinct_critical_forces(chain) == chain.size() - 1);
    });
  }
  CHECK(distinct_critical_forces(Exact({1, 1, 1}, {3, 0, 1})) == 1);
}

TEST_CASE("Nodes: mode m has m sign changes, unless an interior joint is passive") {
  for (const Passive passive : {Passive::none, Passive::base, Passive::last}) {
    check_property("sign changes of the joint angles", [passive] {
      const auto chain = random_chain(passive, 2, 6);
      const auto m = *rc::gen::inRange<std::size_t>(1, chain.size());
      const auto [low, high] = bounds_of(chain, m);
      RC_ASSERT(sign_changes(joint_angles(chain, low)) == m);
      RC_ASSERT(sign_changes(joint_angles(chain, high)) == m);
    });
  }
  // mode 2 of this chain, from the theorem's limits: F = 6, one change
  const Exact interior({1, 1, 1}, {6, 0, 3});
  CHECK(count_below(interior, Rational(6)) == 1);
  CHECK(evaluate(bordered_determinant(interior), 6) == 0);
  const std::vector<Rational> q{0, Rational(1, 2), -1};
  CHECK(small_deflection(interior, q).y == 0);
  CHECK(energy_factor(interior, q) == 6);
  CHECK(sign_changes(q) == 1);
}

TEST_CASE("Equal links") {
  const auto unit = [](std::size_t n, long base) {
    std::vector<Rational> k(n, Rational(1));
    k[0] = base;
    return Exact(std::vector<Rational>(n, Rational(1)), k);
  };
  // 4 sin^2(m pi / 12) is 1, 2, 3 for m = 2, 3, 4
  const Polynomial D = closed_form(unit(6, 0));
  for (const long F : {1, 2, 3}) CHECK(evaluate(D, F) == 0);
  CHECK(evaluate(D, Rational(5, 2)) != 0);
  // between m pi / n and (m + 1) pi / n: with n = 6, forces 1, 2 and 3 separate modes 1, 2 and 3 of the
  // elastic base
  for (const long F : {1, 2, 3}) CHECK(count_below(unit(6, 1), Rational(F)) == static_cast<std::size_t>(F));
  // n = 2: F = 5/2, cos phi = -1/4, and 2 (1 - cos) + 1 = 7/2 = 2 sin phi cot 2 phi
  CHECK(two_links(1, 1, 1, 1) == Rational(5, 2));
}

TEST_CASE("Equal links: the elastic base's equation, and Euler's columns as the limit") {
  using std::cos, std::sin, std::tan;
  const double pi = std::acos(-1.0);
  const auto equation = [](double n, double phi) {
    return n * (1 - cos(phi)) + 1 - n * sin(phi) / tan(n * phi);
  };
  for (const std::size_t n : {3U, 10U, 1000U}) {
    CAPTURE(n);
    const auto links = static_cast<double>(n);
    double low = pi / links, high = 2 * pi / links;  // the equation rises through zero between them
    for (int step = 0; step < 60; ++step)
      (equation(links, (low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    const double F = 4 * sin(low / 2) * sin(low / 2);
    const Chain<double> chain(std::vector<double>(n, 1), std::vector<double>(n, 1));
    // bisection's phi and the sine are good to a few units of 1e-16 relative to phi; the recursion to about n
    // of them
    const double step = 1e-15 * (100 + links);
    CHECK(count_below(chain, F * (1 - step)) == 0);
    CHECK(count_below(chain, F * (1 + step)) == 1);
    // x cot x - 1 has the slope -x at the root x, and the left side is 1 + x^2 / 2n: x is lower by x / 2n, F
    // by 1 / n relatively, to first order; the next term is below 1 / n^2
    const double clamped = 4.493409457909064;  // tan x = x
    if (n == 1000)
      CHECK(std::abs(F * links * links / (clamped * clamped) - 1 + 1 / links) < 1 / links / links);
  }
}

TEST_CASE("Scaling") {
  check_property("k -> c k and L -> c L", [] {
    const auto chain = random_chain(Passive::any_one, 2, 7);
    const Rational c = random_fraction();
    RC_PRE(c != 1);
    auto lengths = chain.length();
    auto stiffness = chain.stiffness();
    for (Rational& L : lengths) L *= c;
    for (Rational& k : stiffness) k *= c;
    const Exact longer(lengths, chain.stiffness()), stiffer(chain.length(), stiffness);
    RC_ASSERT(sum_of_forces(longer) == sum_of_forces(chain) / c);
    RC_ASSERT(sum_of_forces(stiffer) == sum_of_forces(chain) * c);
    for (const Rational& F : probes(chain)) {
      RC_ASSERT(count_below(longer, Rational(F / c)) == count_below(chain, F));
      RC_ASSERT(count_below(stiffer, Rational(F * c)) == count_below(chain, F));
    }
  });
}

TEST_CASE("Reversal: a symmetry of the passive base, not of the elastic one") {
  check_property("forces of the reversed chain", [] {
    const auto chain = random_chain(Passive::base, 2, 8);
    RC_ASSERT(counts_within(chain, reversed(chain), 0, 0));
    RC_ASSERT(product_of_forces(chain) == product_of_forces(reversed(chain)));
    RC_ASSERT(sum_of_inverse_forces(chain) == sum_of_inverse_forces(reversed(chain)));
  });
  CHECK(two_links(1, 2, 1, 1) == Rational(13, 6));
  CHECK(two_links(2, 1, 1, 1) == Rational(5, 3));
}

TEST_CASE("Monotone in stiffness, and interlacing when one stiffness changes") {
  check_property("a stiffness raised", [] {
    const auto chain = random_chain(Passive::any_one, 2, 7);
    const auto i = *rc::gen::inRange<std::size_t>(0, chain.size());
    const Exact stiffer = with_stiffness(chain, i, chain.stiffness()[i] + random_fraction());
    RC_ASSERT(none_lower(chain, stiffer));
    RC_ASSERT(counts_within(chain, stiffer, 1, 0));
    RC_ASSERT(sum_of_forces(stiffer) > sum_of_forces(chain));
  });
  CHECK_FALSE(none_lower(Exact({1, 1}, {1, 1}), Exact({1, 1}, {1, Rational(1, 2)})));
}

TEST_CASE("Not monotone in length") {
  check_property("what a longer link never does", [] {
    const bool passive = *rc::gen::arbitrary<bool>();
    const auto chain = random_chain(passive ? Passive::base : Passive::any_one, 2, 7);
    const auto i = passive ? *rc::gen::inRange<std::size_t>(0, chain.size()) : 0;
    const Exact longer = with_length(chain, i, chain.length()[i] + random_fraction());
    RC_ASSERT(none_lower(longer, chain));
  });
  CHECK(two_links(1, 1, 8, 1) == 6);
  CHECK(two_links(1, 2, 8, 1) == Rational(41, 6));
  CHECK_FALSE(none_lower(Exact({1, 2}, {8, 1}), Exact({1, 1}, {8, 1})));
  check_property("the condition for two links", [] {
    const auto chain = random_chain(Passive::none, 2, 2);
    const auto& L = chain.length();
    const auto& k = chain.stiffness();
    const Rational before = sum_of_forces(chain);
    const Rational after = sum_of_forces(with_length(chain, 1, L[1] * (1 + Rational(1, 1000000000))));
    const Rational slope = 1 / L[0] + 1 / L[1];
    RC_ASSERT((after > before) == (k[0] / (L[0] * L[0]) > k[1] * slope * slope));
  });
}

TEST_CASE("Prismatic joints: a yielding link lowers the force of an elastic base where a shorter link does") {
  const Rational F(57, 10), kappa(171, 10);
  CHECK(two_links(1, 1 - F / kappa, 8, 1) == F);
  CHECK(two_links(1, 1, 8, 1) > F);
  // no lower force solves it: at a lower one the link is longer, and the rigid chain's force higher
  for (Rational lower = 0; lower < F; lower += Rational(1, 10))
    CHECK(two_links(1, 1 - lower / kappa, 8, 1) > lower);
}

TEST_CASE("Interlacing: a joint frozen") {
  check_property("F_m <= frozen F_m <= F_{m+1}", [] {
    const auto chain = random_chain(Passive::any_one, 3, 7);
    const Exact rigid = frozen(chain, *rc::gen::inRange<std::size_t>(0, chain.size()));
    RC_ASSERT(counts_within(chain, rigid, 1, 0));
  });
}

TEST_CASE("Interlacing: the last link cut off") {
  check_property("any base: shifted by one mode at most; passive base: interlaced", [] {
    const bool passive = *rc::gen::arbitrary<bool>();
    const auto chain = random_chain(passive ? Passive::base : Passive::any_one, 3, 7);
    RC_ASSERT(counts_within(chain, cut(chain), 1, passive ? 0 : 1));
  });
  const Exact stiff_end({1, 1, 1},
                        {8, 1, 1000});  // from the theorem's limits: near 41/6, without link 3 at 6
  CHECK(count_below(stiff_end, Rational(6)) == 0);
  CHECK(count_below(cut(stiff_end), Rational(61, 10)) == 1);
  CHECK_FALSE(counts_within(stiff_end, cut(stiff_end), 1, 0));
}
