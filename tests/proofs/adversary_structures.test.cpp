/// Ends, supports, loads and chains in space, made to provoke a false certificate, each certified output
/// checked against another route.
///
/// PLUMBLINE_ADVERSARY=100000 asks for so many cases, PLUMBLINE_ADVERSARY_SEED for others than those from 1
/// on.
#include <doctest/doctest.h>

#include <cstdlib>
#include <plumbline/space/bent_equilibrium.hpp>
#include <random>

#include "proofs/census/structure_census.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/as_double.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/straight_space.hpp"
#include "statement/stated.hpp"
#include "tests/proofs/certificates/stand_alone.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

std::size_t asked_for(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::stoul(text) : otherwise;
}

class StructureAdversary {
 public:
  explicit StructureAdversary(std::size_t seed) : random_(static_cast<unsigned>(seed)) {}

  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  bool one_in(int cases) { return whole(1, cases) == 1; }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// Next to nothing, ordinary, or huge.
  Rational size() {
    const int power = one_in(6) ? whole(-40, 40) : 0;
    return shifted(Rational(whole(10, 400), 100), power);
  }
  Restraint<Rational> restraint(bool may_be_held) {
    const int kind = whole(0, may_be_held ? 3 : 2);
    if (kind == 3) return Restraint<Rational>::held();
    return kind == 2 ? Restraint<Rational>::sprung(size()) : Restraint<Rational>();
  }

  /// Straight, with any ends, supports and loads along it.
  Structure<Rational> straight() {
    const auto n = static_cast<std::size_t>(whole(1, 6));
    std::vector<Rational> length, stiffness;
    for (std::size_t i = 0; i < n; ++i) length.push_back(size()), stiffness.push_back(size());
    const bool passive = n > 1 && one_in(3);
    if (passive) stiffness[0] = 0;
    Structure<Rational> structure{Chain<Rational>(length, stiffness)};
    if (passive && one_in(2)) structure.base.turn = Restraint<Rational>::held();
    if (one_in(4)) structure.base.across = restraint(false);
    structure.end_point.across = restraint(true);
    structure.end_point.turn = restraint(true);
    for (std::size_t i = 1; i < n; ++i)
      structure.across.push_back(one_in(3) ? restraint(true) : Restraint<Rational>());
    for (int loads = whole(1, 3); loads > 0; --loads)
      structure.loads.push_back({static_cast<std::size_t>(whole(1, static_cast<int>(n))),
                                 {(one_in(4) ? 1 : -1) * size(), 0},
                                 !one_in(4),
                                 LoadKind::dead});
    return structure;
  }

  /// Symmetric about its middle, where it is held: every factor is there twice, or nearly.
  Structure<Rational> twice(int place) {
    const auto half = static_cast<std::size_t>(whole(2, 3));
    std::vector<Rational> length, stiffness;
    for (std::size_t i = 0; i < half; ++i) length.push_back(size()), stiffness.push_back(size());
    stiffness[0] = 0;
    for (std::size_t i = 0; i < half; ++i) length.push_back(length[half - 1 - i]);
    stiffness.push_back(0);
    for (std::size_t i = 1; i < half; ++i) stiffness.push_back(stiffness[half - i]);
    if (place > 0) stiffness[1] += shifted(stiffness[1], -place);
    Structure<Rational> structure{Chain<Rational>(length, stiffness)};
    structure.across.assign(2 * half - 1, {});
    structure.across[half - 1] = Restraint<Rational>::held();
    structure.add_compression();
    return structure;
  }

  /// A bent chain of two or three links under loads that turn it a lot.
  Structure<Rational> bent() {
    const auto n = static_cast<std::size_t>(whole(1, 3));
    const auto ordinary = [&] { return Rational(whole(40, 200), 100); };
    std::vector<Rational> length, stiffness, rest;
    for (std::size_t i = 0; i < n; ++i) {
      length.push_back(ordinary()), stiffness.push_back(ordinary());
      rest.emplace_back(one_in(3) ? 0 : whole(-100, 100), 100);
    }
    Structure<Rational> structure{Chain<Rational>(length, stiffness, rest)};
    if (n > 1 && one_in(2)) {
      structure.end_point.across =
          one_in(2) ? Restraint<Rational>::held() : Restraint<Rational>::sprung(ordinary());
    } else {
      structure.end_point = {};
    }
    if (one_in(3)) structure.end_point.turn = Restraint<Rational>::sprung(ordinary());
    structure.loads.push_back(
        {n, {-ordinary(), one_in(2) ? Rational(0) : Rational(whole(-50, 50), 100)}, true, LoadKind::dead});
    if (one_in(3)) {
      for (std::size_t link = 1; link <= n; ++link)
        structure.add_weight(link, {0, -ordinary() / 4}, !one_in(2));
    }
    if (one_in(4)) structure.moment = Rational(whole(-50, 50), 100);
    return structure;
  }

 private:
  std::mt19937 random_;
};

/// The same structure in other units of length and stiffness, its factors those of the first times `force`.
Structure<Rational> in_units(Structure<Rational> structure, int length, int stiffness) {
  const auto scaled = [](std::vector<Rational> values, int by) {
    for (Rational& x : values) x = shifted(x, by);
    return values;
  };
  structure.chain = Chain<Rational>(scaled(structure.chain.length(), length),
                                    scaled(structure.chain.stiffness(), stiffness), structure.chain.rest());
  const auto spring = [](Restraint<Rational>& restraint, int by) {
    restraint.stiffness = shifted(restraint.stiffness, by);
  };
  for (Support<Rational>* end : {&structure.base, &structure.end_point}) {
    spring(end->along, stiffness - 2 * length);
    spring(end->across, stiffness - 2 * length);
    spring(end->turn, stiffness);
  }
  for (Restraint<Rational>& across : structure.across) spring(across, stiffness - 2 * length);
  for (Load<Rational>& load : structure.loads) {
    load.force = {shifted(load.force.x, stiffness - length), shifted(load.force.y, stiffness - length)};
  }
  structure.moment = shifted(structure.moment, stiffness);
  return structure;
}

/// Read from the other end: what held the end point holds the base.
Structure<Rational> reversed(const Structure<Rational>& from) {
  const std::size_t n = from.chain.size();
  std::vector<Rational> length(from.chain.length().rbegin(), from.chain.length().rend()),
      stiffness{from.end_point.turn.stiffness};
  for (std::size_t i = n - 1; i > 0; --i) stiffness.push_back(from.chain.stiffness()[i]);
  Structure<Rational> to{Chain<Rational>(length, stiffness)};
  to.base = from.end_point;
  if (!to.base.turn.is_held()) to.base.turn = {};
  to.end_point = from.base;
  if (!from.base.turn.is_held()) to.end_point.turn = Restraint<Rational>::sprung(from.chain.stiffness()[0]);
  to.across.assign(from.across.rbegin(), from.across.rend());
  Rational reaction[2] = {0, 0};  // at the base, which now loads the end point
  for (const Load<Rational>& load : from.loads) {
    reaction[load.multiplied ? 1 : 0] += load.force.x;
    if (load.node < n) to.loads.push_back({n - load.node, {-load.force.x, 0}, load.multiplied, load.kind});
  }
  for (const bool multiplied : {false, true})
    to.loads.push_back({n, {reaction[multiplied ? 1 : 0], 0}, multiplied, LoadKind::dead});
  std::swap(to.base.along, to.end_point.along);
  return to;
}

std::vector<std::string> decimals(const StraightStructure& straight, int digits) {
  std::vector<std::string> all;
  for (const CriticalMode& mode : straight.in_decimals(99, digits, false)) all.push_back(mode.force);
  return all;
}

/// \returns whether it has critical factors
bool attack_straight(const Structure<Rational>& structure, StructureAdversary& adversary,
                     std::vector<nlohmann::json>& certificates) {
  std::optional<StraightStructure> straight;
  try {
    straight.emplace(structure);
  } catch (const Error&) {
    const int length = adversary.whole(-30, 30);
    CHECK_THROWS_AS(StraightStructure(in_units(structure, length, 0)), Error);
    return false;
  }
  const auto here = decimals(*straight, 15), finer = decimals(*straight, 50);
  REQUIRE(here.size() == finer.size());
  CHECK(here.size() == straight->modes());
  for (std::size_t m = 0; m < here.size(); ++m) {
    CHECK(to_decimal(*parse_decimal(finer[m]), 15) == here[m]);
    CHECK((m == 0 || *parse_decimal(finer[m - 1]) <= *parse_decimal(finer[m])));
  }
  CHECK(decimals(StraightStructure(in_units(structure, adversary.whole(-80, 80), adversary.whole(-80, 80))),
                 15) == here);
  CHECK(decimals(StraightStructure(reversed(structure)), 15) == here);
  if (adversary.one_in(5))
    certificates.push_back(
        structure_certificate("adversary", statement::stated(structure), *straight, 99, 20));
  return true;
}

/// A planar chain in two planes at right angles, turned about the line, its axes of any length.
void attack_in_space(StructureAdversary& adversary) {
  const auto n = static_cast<std::size_t>(adversary.whole(2, 4));
  std::vector<Rational> length, weak, strong;
  std::vector<SpaceJoint<Rational>> joints;
  const bool turned = adversary.one_in(2);
  const Rational c = turned ? Rational(4, 5) : Rational(1), s = turned ? Rational(3, 5) : Rational(0);
  for (std::size_t i = 0; i < n; ++i) {
    length.push_back(adversary.size()), weak.push_back(adversary.size());
    strong.push_back(adversary.one_in(3) ? weak.back() : adversary.size());
    const int longer = adversary.whole(-3, 3);
    const Rational stretch = shifted(Rational(1), longer);
    joints.push_back({{{{0, -s * stretch, c * stretch}, weak.back()}, {{0, c, s}, strong.back()}}});
    if (adversary.one_in(3)) joints.back().axes.push_back({{1, 0, 0}, adversary.size()});  // twist
  }
  SpaceStructure<Rational> structure{SpaceChain<Rational>(length, joints)};
  structure.add_compression();
  std::vector<Rational> planar;
  for (const auto* stiffness : {&weak, &strong}) {
    for (const auto& mode : forces_in_decimals(Chain<Rational>(length, *stiffness), 99, 15))
      planar.push_back(*parse_decimal(mode.force));
  }
  std::sort(planar.begin(), planar.end());
  const auto modes = StraightSpace(structure).in_decimals(99, 15);
  REQUIRE(modes.size() == planar.size());
  for (std::size_t m = 0; m < modes.size(); ++m) CHECK(*parse_decimal(modes[m].force) == planar[m]);
}

/// Whether a shape that Newton's method found is listed, or in a place left undecided, or outside the window.
bool listed(const StructureCensus& census, const Structure<Rational>& structure, const std::vector<double>& q,
            double across) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (std::abs(q[i] - from_rational<double>(structure.chain.rest()[i])) > census.widest_turn - 1e-6)
      return true;
  }
  if (census.largest_force > 0 && std::abs(across) > census.largest_force) return true;
  const auto near = [&](const std::vector<Span>& angles, double slack) {
    for (std::size_t i = 0; i < q.size(); ++i) {
      if (q[i] < angles[i].low - slack || q[i] > angles[i].high + slack) return false;
    }
    return true;
  };
  return std::any_of(census.equilibria.begin(), census.equilibria.end(),
                     [&](const auto& one) { return near(one.q, 1e-5); }) ||
         std::any_of(census.undecided.begin(), census.undecided.end(),
                     [&](const auto& box) { return near(box, 1e-2); });
}

/// \returns whether the census is complete
bool attack_census(const Structure<Rational>& structure, StructureAdversary& adversary) {
  const Rational factor(adversary.whole(10, 300), 100);
  const StructureCensus census = take_census(structure, factor, 0);
  const auto model = bent_structure(from_rational<double>(structure));
  BentSolver<double> solver(model);
  for (int start = 0; start < 40; ++start) {
    Vector<double> x = model.rest();
    for (double& angle : x) angle += adversary.real(-3.2, 3.2);
    const auto found =
        solver.at_factor(x, from_rational<double>(factor), Vector<double>::Constant(model.held(), 0));
    if (!found) continue;
    CHECK(listed(census, structure, model.angles(found->x),
                 found->multiplier.size() > 0 ? found->multiplier(0) : 0));
  }
  const int length = adversary.whole(-60, 60), stiffness = adversary.whole(-60, 60);
  const StructureCensus other = take_census(in_units(structure, length, stiffness), factor, 0);
  if (!census.complete() || !other.complete()) return false;
  REQUIRE(census.equilibria.size() == other.equilibria.size());
  for (std::size_t e = 0; e < census.equilibria.size(); ++e) {
    CHECK(census.equilibria[e].negative_directions == other.equilibria[e].negative_directions);
    for (std::size_t i = 0; i < census.equilibria[e].q.size(); ++i)
      CHECK(std::abs(census.equilibria[e].q[i].middle() - other.equilibria[e].q[i].middle()) < 1e-9);
  }
  return true;
}

}  // namespace

TEST_CASE("the adversary finds no false factor, certificate or census of other ends and loads") {
  const std::size_t cases = asked_for("PLUMBLINE_ADVERSARY", 60),
                    seed = asked_for("PLUMBLINE_ADVERSARY_SEED", 1);
  std::vector<nlohmann::json> certificates;
  std::size_t straight = 0, with_factors = 0, censuses = 0, complete = 0;
  for (std::size_t i = 0; i < cases; ++i) {
    CAPTURE(seed + i);
    StructureAdversary adversary(seed + i);
    switch (i % 4) {
      case 0:
      case 1: {
        const bool tied = i % 8 == 1;
        const int places[] = {0, 20, 60};
        ++straight;
        with_factors +=
            attack_straight(tied ? adversary.twice(places[adversary.whole(0, 2)]) : adversary.straight(),
                            adversary, certificates)
                ? 1
                : 0;
        break;
      }
      case 2:
        attack_in_space(adversary);
        break;
      default:
        ++censuses;
        complete += attack_census(adversary.bent(), adversary) ? 1 : 0;
    }
  }
  MESSAGE(cases, " cases from seed ", seed, ": ", with_factors, " of ", straight,
          " structures have factors, ", complete, " of ", censuses, " censuses complete; ",
          certificates.size(), " certificates");
  CHECK(check_alone("check_structures.py", structure_certificates, certificates) == 0);
  CHECK(with_factors * 3 > straight);
  CHECK(complete * 2 > censuses);
}
