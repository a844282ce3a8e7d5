#include "proofs/certificates/equilibria_certificate.hpp"

#include <random>

#include "proofs/exact/decimal.hpp"
#include "tests/proofs/certificates/stand_alone.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using nlohmann::json;

namespace {

json certified(const CensusTask& task) {
  return equilibria_certificate(task, take_census(task), 40);
}

/// Hundredths from low to high.
class Hundredths {
 public:
  explicit Hundredths(std::uint64_t seed) : random_(seed) {}
  Rational operator()(int low, int high) {
    return {std::uniform_int_distribution<int>(low, high)(random_), 100};
  }
  std::vector<Rational> list(std::size_t count, int low, int high) {
    std::vector<Rational> values;
    while (values.size() < count) values.push_back((*this)(low, high));
    return values;
  }

 private:
  std::mt19937_64 random_;
};

CensusTask random_task(std::uint64_t seed) {
  Hundredths draw(seed);
  const std::size_t n = 2 + seed % 3;
  std::vector<Rational> length = draw.list(n, 50, 150), stiffness = draw.list(n, 50, 200);
  if (seed % 4 == 0) stiffness[seed / 4 % n] = 0;
  const Chain<Rational> chain(length, stiffness, draw.list(n, -150, 150));
  Rational reach(0);
  for (const Rational& l : length) reach += l;
  if (seed % 3 == 0) return {"random", chain, false, Given::force, {draw(-120, -10), draw(-30, 30)}};
  return {"random", chain, false, Given::end_point, {reach * draw(35, 75), reach * draw(-30, 30)}};
}

}  // namespace

TEST_CASE("the stand-alone checker confirms censuses of random chains, passive joints anywhere") {
  std::vector<json> certificates;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const CensusTask task = random_task(seed);
    const Census census = take_census(task);
    REQUIRE(census.complete());
    certificates.push_back(equilibria_certificate(task, census, 40));
    CHECK(certificates.back()["equilibria"].size() == census.equilibria.size());
    CHECK(certificates.back()["digits"] == 40);
  }
  CHECK(check_alone("check_equilibria.py", equilibria_certificates, certificates) == 0);
}

TEST_CASE("certificates in units of any size, and of windows of more turns") {
  const Rational large = Rational(mp::pow(mp::mpz_int(10), 150)), small = 1 / large;
  const Chain<Rational> unit({1, 1, 1}, {1, Rational(1, 2), 1}, {Rational(1, 10), 0, Rational(1, 5)});
  const Chain<Rational> huge({large, large, large}, {small, small / 2, small}, unit.rest());
  const Point<Rational> place{Rational(3, 2), Rational(1, 10)};
  const CensusTask task{"unit", unit, false, Given::end_point, place, 0};
  const CensusTask scaled{"huge", huge, false, Given::end_point, {place.x * large, place.y * large}, 0};
  const CensusTask pushed{"pushed", unit, false, Given::deflection, {Rational(2, 5), 0}, 0};
  const CensusTask wound{
      "wound", Chain<Rational>({1, 1}, {1, 1}), false, Given::end_point, {1, Rational(1, 3)}, 1};
  const CensusTask graded{"graded",  Chain<Rational>({1, Rational(1, 1000)}, {1000, Rational(1, 10)}),
                          false,     Given::force,
                          {-500, 3}, 0};
  std::vector<json> certificates;
  for (const CensusTask& one : {task, scaled, pushed, wound, graded}) certificates.push_back(certified(one));
  CHECK(certificates[0]["equilibria"].size() == certificates[1]["equilibria"].size());
  CHECK(check_alone("check_equilibria.py", equilibria_certificates, certificates) == 0);
}

TEST_CASE("a certificate has no more digits than its enclosures, of angles, forces and energies") {
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const CensusTask task = random_task(seed);
    const Census census = take_census(task);
    REQUIRE(census.complete());
    const json certificate = equilibria_certificate(task, census, 90);
    const int digits = certificate["digits"];
    CHECK(digits < 64);  // those of an interval
    const auto largest = [](const std::vector<Rational>& x) { return *std::max_element(x.begin(), x.end()); };
    const Rational length = largest(task.chain.length()), stiffness = largest(task.chain.stiffness());
    const Rational last = Rational(1) / Rational(mp::pow(mp::mpz_int(10), static_cast<unsigned>(digits)));
    const auto holds = [&](const Interval& x, const Rational& scale) {
      return Interval::End(4) * x.width() <= Interval(scale * last).upper();
    };
    for (const CertifiedEquilibrium& one : census.equilibria) {
      for (const Interval& q : one.q) CHECK(holds(q, 1));
      CHECK(holds(one.fx, stiffness / length));
      CHECK(holds(one.fy, stiffness / length));
      CHECK(holds(one.energy, stiffness));
    }
  }
}

TEST_CASE("there is no certificate of what a census leaves open") {
  // at the critical force (3 - sqrt 5) / 2 to fifty digits the straight shape is degenerate
  const auto critical = *parse_decimal("-0.38196601125010515179541316563436188227969082019424");
  const CensusTask task{"critical", Chain<Rational>({1, 1}, {1, 1}), false, Given::force, {critical, 0}, 0};
  CHECK_THROWS_AS(certified(task), Error);
  const CensusTask stable{"stable", Chain<Rational>({1, 1}, {1, 1}), false, Given::force, {1, 0}, 0};
  Census census = take_census(stable);
  REQUIRE(census.complete());
  census.equilibria[0].negative_directions.reset();
  CHECK_THROWS_AS(equilibria_certificate(stable, census, 20), Error);
}
