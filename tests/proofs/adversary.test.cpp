/// Cases made to provoke a false certificate, each certified output checked against another route.
///
/// PLUMBLINE_ADVERSARY=100000 asks for so many cases, PLUMBLINE_ADVERSARY_SEED for others than those from 1
/// on.
#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>
#include <set>

#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/exact/as_double.hpp"
#include "proofs/exact/critical_modes.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/span.hpp"
#include "tests/close_to.hpp"
#include "tests/proofs/certificates/stand_alone.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

std::size_t asked(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::stoul(text) : otherwise;
}

/// A chain under a load.
struct Case {
  std::vector<Rational> length, stiffness, rest;
  Control control = Control::end_point;
  Point<Rational> load{0, 0};

  [[nodiscard]] Chain<Rational> chain() const { return Chain<Rational>(length, stiffness, rest); }
  [[nodiscard]] Census census(const CensusLimits& limits) const {
    const auto enclosed = from_rational<Interval>(chain());
    const Point<Interval> at{Interval(load.x), Interval(load.y)};
    return control == Control::end_point ? census_at_end_point(enclosed, at, {}, limits)
                                         : census_under_force(enclosed, at, limits);
  }
};

class Adversary {
 public:
  explicit Adversary(std::size_t seed) : random_(static_cast<unsigned>(seed)) {}

  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  /// An ordinary chain, sometimes with a passive joint anywhere, at an ordinary load.
  Case ordinary(std::size_t n) {
    Case one;
    for (std::size_t i = 0; i < n; ++i) {
      one.length.emplace_back(whole(40, 200), 100);
      one.stiffness.emplace_back(whole(30, 300), 100);
      one.rest.emplace_back(whole(-150, 150), 100);
    }
    if (whole(0, 2) == 0 && n > 1)
      one.stiffness[static_cast<std::size_t>(whole(0, static_cast<int>(n) - 1))] = 0;
    if (whole(0, 1) == 0) {
      one.control = Control::force;
      one.load = {Rational(whole(-150, 80), 100), Rational(whole(-60, 60), 100)};
    } else {
      hold_near(one, Rational(whole(35, 85), 100), Rational(whole(-30, 30), 100));
    }
    return one;
  }

  void hold_near(Case& one, const Rational& share, const Rational& aside) {
    Rational reach = 0;
    for (const Rational& L : one.length) reach += L;
    one.control = Control::end_point;
    one.load = {reach * share, reach * share * aside};
  }

  /// The end point of a shape, to forty digits, with one joint exactly half a turn from its zero, or its
  /// rest.
  Case at_the_edge(std::size_t n) {
    Case one = ordinary(n);
    const auto chain = from_rational<Interval>(one.chain());
    std::vector<Interval> q;
    for (const Rational& rest : one.rest) q.emplace_back(rest + Rational(whole(-60, 60), 100));
    const auto edge = static_cast<std::size_t>(whole(0, static_cast<int>(n) - 1));
    const Interval pi = Interval::pi();
    q[edge] = whole(0, 1) == 0 ? pi : chain.rest()[edge] - pi;
    const Point<Interval> p = end_point(chain, q);
    one.control = Control::end_point;
    one.load = {rounded(p.x), rounded(p.y)};
    return one;
  }

  /// Rest angles (…, a, -a, …) or (…, a, a, …) and a load on the axis.
  Case symmetric(std::size_t n) {
    Case one = ordinary(n);
    const bool same = whole(0, 1) == 0;
    for (std::size_t i = 0; i < n; ++i) {
      one.length[i] = 1;
      one.stiffness[i] = i == 0 ? 0 : 1;
      one.rest[i] = i == 0 ? Rational(0) : one.rest[1] * (same || i % 2 == 1 ? 1 : -1);
    }
    if (whole(0, 2) == 0) one.rest.assign(n, 0);
    if (one.control == Control::force)
      one.load.y = 0;
    else
      hold_near(one, Rational(whole(45, 85), 100), 0);
    return one;
  }

  /// Two links with the critical force 1/2 for k = (3/2, 1), exactly there and beside it.
  Case critical() {
    Case one{{1, 1}, {Rational(3, 2), 1}, {0, 0}, Control::force, {0, 0}};
    const std::array<int, 5> beside{0, 30, 12, 6, 3};
    const int place = beside[static_cast<std::size_t>(whole(0, 4))];
    const Rational off = place == 0 ? Rational(0) : shifted(Rational(whole(0, 1) == 0 ? 1 : -1), -place);
    one.load.x = -(Rational(whole(0, 1) == 0 ? 1 : 6, 2) + off);
    return one;
  }

  /// The same case in other units.
  static Case in_units(Case one, int length, int stiffness) {
    for (Rational& L : one.length) L = shifted(L, length);
    for (Rational& k : one.stiffness) k = shifted(k, stiffness);
    const int unit = one.control == Control::end_point ? length : stiffness - length;
    one.load = {shifted(one.load.x, unit), shifted(one.load.y, unit)};
    return one;
  }

  static Case mirrored(Case one) {
    for (Rational& angle : one.rest) angle = -angle;
    one.load.y = -one.load.y;
    return one;
  }

  /// Theorem "Reversal", for a passive base and a held end point.
  static Case reversed(Case one) {
    std::reverse(one.length.begin(), one.length.end());
    std::reverse(one.stiffness.begin() + 1, one.stiffness.end());
    std::reverse(one.rest.begin() + 1, one.rest.end());
    for (Rational& angle : one.rest) angle = -angle;
    return one;
  }

  std::mt19937& random() { return random_; }

 private:
  static Rational rounded(const Interval& x) { return *parse_decimal(x.middle().str(40)); }
  std::mt19937 random_;
};

/// Energies and indices, in units of the first chain.
using Signature = std::vector<std::pair<double, std::optional<std::size_t>>>;

Signature signature(const Census& census, int stiffness = 0) {
  Signature list;
  for (const auto& one : census.equilibria)
    list.emplace_back(as_double(one.energy * Interval(shifted(Rational(1), -stiffness))),
                      one.negative_directions);
  std::sort(list.begin(), list.end());
  return list;
}

bool agree(const Signature& a, const Signature& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i].first - b[i].first) > 1e-9 * (1 + std::abs(a[i].first))) return false;
  }
  const auto indices = [](const Signature& list) {
    std::multiset<std::size_t> found;
    for (const auto& one : list) found.insert(one.second.value_or(99));
    return found;
  };
  return indices(a) == indices(b);
}

/// Whether a shape that Newton's method found is listed, or in a place left undecided, or outside the window.
bool accounted(const Census& census, const Case& one, const std::vector<double>& q) {
  const auto near = [&](const auto& angles, double slack) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const bool turns = one.stiffness[i] == 0;
      double off = q[i] - as_double(angles[i]);
      if (turns) off = std::remainder(off, 2 * M_PI);
      if (std::abs(off) > slack + static_cast<double>(angles[i].width())) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < census.window.size(); ++i) {
    const Span range(census.window[i]);
    if (one.stiffness[i] != 0 && (q[i] < range.low + 1e-6 || q[i] > range.high - 1e-6)) return true;
  }
  for (const auto& listed : census.equilibria) {
    if (near(listed.q, 1e-5)) return true;
  }
  return std::any_of(census.undecided.begin(), census.undecided.end(),
                     [&](const auto& box) { return near(box, 1e-2); });
}

/// \return shapes that Newton's method found and the census has not
std::size_t missing(const Census& census, const Case& one, Adversary& adversary, int starts) {
  const auto chain = from_rational<double>(one.chain());
  const NominalModel<double> model(chain);
  EquilibriumSolver<NominalModel<double>> solver(model);
  const Point<double> at{static_cast<double>(one.load.x), static_cast<double>(one.load.y)};
  std::uniform_real_distribution<double> turn(-M_PI, M_PI);
  std::size_t lost = 0;
  for (int start = 0; start < starts; ++start) {
    std::vector<double> q = chain.rest();
    for (double& angle : q) angle += turn(adversary.random());
    try {
      const auto theta = absolute_angles(q);
      const auto found =
          one.control == Control::force ? solver.under_force(at, theta) : solver.at_end_point(at, theta);
      lost += accounted(census, one, joint_angles(found.theta)) ? 0 : 1;
    } catch (const Error&) {  // this start leads to no equilibrium
    }
  }
  return lost;
}

constexpr std::size_t certified_share =
    20;  ///< one complete census in so many is checked by the stand-alone program

struct Tally {
  std::size_t cases = 0, complete = 0, balanced = 0, refused = 0;
  std::vector<nlohmann::json> certificates;

  void certify(const Case& one, const Census& census) {
    const Given given = one.control == Control::force ? Given::force : Given::end_point;
    try {
      certificates.push_back(
          equilibria_certificate({"adversary", one.chain(), false, given, one.load}, census, 40));
    } catch (const Error&) {  // too near a fold for double precision: no certificate is no false one
    }
  }
};

void attack(const Case& one, Adversary& adversary, Tally& tally) {
  CensusLimits limits;
  limits.boxes = 300000;
  ++tally.cases;
  std::optional<Census> census;
  try {
    census = one.census(limits);
  } catch (const Error& error) {
    const std::string why = error.what();
    CHECK_MESSAGE(why.find("even less odd") == std::string::npos, why);
    ++tally.refused;
    return;
  }
  tally.complete += census->complete() ? 1 : 0;
  tally.balanced += census->balanced ? 1 : 0;
  CHECK(missing(*census, one, adversary, 40) == 0);
  if (!census->complete()) return;
  const int length = adversary.whole(-140, 140), stiffness = adversary.whole(-140, 140);
  const Signature here = signature(*census);
  limits.boxes = 1200000;
  // what another rounding leaves undecided is no contradiction
  const auto same = [&](const Census& other, int unit) {
    return !other.complete() || agree(here, signature(other, unit));
  };
  CHECK(same(Adversary::in_units(one, length, stiffness).census(limits), stiffness));
  CHECK(same(Adversary::mirrored(one).census(limits), 0));
  const bool all_elastic_behind =
      std::all_of(one.stiffness.begin() + 1, one.stiffness.end(), [](const Rational& k) { return k != 0; });
  if (one.control == Control::end_point && one.stiffness[0] == 0 && all_elastic_behind)
    CHECK(same(Adversary::reversed(one).census(limits), 0));
  if (tally.complete % certified_share == 0) tally.certify(one, *census);
}

/// A straight chain with two parts whose lowest forces agree to some digits, or exactly.
void attack_ties(Adversary& adversary) {
  const std::array<int, 6> places{0, 15, 30, 45, 46, 60};
  const int place = places[static_cast<std::size_t>(adversary.whole(0, 5))];
  const Rational off = place == 0 ? Rational(0) : shifted(Rational(adversary.whole(-9, 9)), -place);
  const int unit = adversary.whole(-280, 280);
  const std::vector<Rational> length{1, 1, 1}, stiffness{3 + off, 0, 1};
  const auto modes = modes_in_decimals(Chain<Rational>(length, stiffness), 2, 15);
  const auto scaled = modes_in_decimals(
      Chain<Rational>(length, {shifted(stiffness[0], unit), 0, shifted(Rational(1), unit)}), 2, 15);
  const auto finer = modes_in_decimals(Chain<Rational>(length, stiffness), 2, 50);
  CAPTURE(place);
  CAPTURE(unit);
  REQUIRE(modes.size() == 2);
  for (std::size_t m = 0; m < 2; ++m) {
    CHECK(modes[m].force == modes[m].energy_factor);
    CHECK(*parse_decimal(scaled[m].force) == shifted(*parse_decimal(modes[m].force), unit));
    CHECK(to_decimal(*parse_decimal(finer[m].force), 15) == modes[m].force);
    double square = 0, work = 0, theta = 0, largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double q = modes[m].q[i];
      largest = std::max(largest, std::abs(q));
      theta += q;
      work += static_cast<double>(stiffness[i]) * q * q;
      square += theta * theta;
    }
    CHECK(largest == 1);
    CHECK(work / square == close_to(2).epsilon(1e-12));
  }
  // the parts: joints 1 and 2 have (2/3)(3 + off), joints 2 and 3 have 2
  CHECK((modes[0].q[0] == 0) != (modes[1].q[0] == 0));
  if (off != 0) CHECK((modes[0].q[0] == 0) == (off > 0));
}

}  // namespace

TEST_CASE("the adversary finds no false certificate") {
  const std::size_t cases = asked("PLUMBLINE_ADVERSARY", 40), seed = asked("PLUMBLINE_ADVERSARY_SEED", 1);
  Tally tally;
  for (std::size_t i = 0; i < cases; ++i) {
    CAPTURE(seed + i);
    Adversary adversary(seed + i);
    const auto n = static_cast<std::size_t>(adversary.whole(2, 4));
    switch (i % 5) {
      case 0:
        attack(adversary.ordinary(n), adversary, tally);
        break;
      case 1:
        attack(adversary.at_the_edge(std::min<std::size_t>(n, 3)), adversary, tally);
        break;
      case 2:
        attack(adversary.symmetric(n), adversary, tally);
        break;
      case 3:
        attack(adversary.critical(), adversary, tally);
        break;
      default:
        attack_ties(adversary);
    }
  }
  MESSAGE(cases, " cases from seed ", seed, ": ", tally.cases, " censuses, ", tally.complete, " complete, ",
          tally.balanced, " balanced, ", tally.refused, " refused; ", tally.certificates.size(),
          " certificates");
  CHECK(check_alone("check_equilibria.py", equilibria_certificates, tally.certificates) == 0);
  CHECK(tally.complete * 2 > tally.cases);
}
