#include "proofs/certificates/certificate.hpp"

#include <nlohmann/json.hpp>
#include <random>

#include "proofs/exact/decimal.hpp"
#include "tests/proofs/certificates/stand_alone.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using nlohmann::json;

namespace {

/// A decimal of three digits, its exponent anywhere from -decades to decades.
Rational graded(std::mt19937_64& random, int decades) {
  const auto mantissa = std::to_string(100 + random() % 900);
  const auto exponent = static_cast<int>(random() % static_cast<unsigned>(2 * decades + 1)) - decades - 2;
  return *parse_decimal(mantissa + "e" + std::to_string(exponent));
}

Chain<Rational> graded_chain(std::mt19937_64& random, std::size_t n, int decades, std::size_t passive) {
  std::vector<Rational> length, stiffness;
  for (std::size_t i = 1; i <= n; ++i) {
    length.push_back(graded(random, decades));
    stiffness.push_back(i == passive ? Rational(0) : graded(random, decades));
  }
  return Chain<Rational>(length, stiffness);
}

}  // namespace

TEST_CASE("the stand-alone checker confirms chains graded over sixteen decades, with shapes and matrices") {
  std::mt19937_64 random(1);
  std::vector<json> certificates;
  for (std::size_t n = 2; n <= 9; ++n) {
    for (const int decades : {0, 8}) {
      const auto chain = graded_chain(random, n, decades, random() % (n + 1));
      certificates.push_back(certificate("graded", chain, certify(chain, n, n, 40)));
      if (n <= 6) certificates.back()["matrices"] = matrix_certificate(chain);
      CHECK(certificates.back()["forces"].size() == n - 1);
    }
  }
  CHECK(check_alone("check_certificates.py", critical_certificates, certificates) == 0);
}

TEST_CASE("two equal critical forces are proved equal") {
  // before the passive joint k_1 z_2 / (z_1 L_1) = 2, behind it k_3 (1 / L_2 + 1 / L_3) = 2
  const Chain<Rational> tied({1, 1, 1}, {3, 0, 1});
  json rational = certificate("tie", tied, certify(tied, 2, 2, 30));
  rational["matrices"] = matrix_certificate(tied);
  REQUIRE(rational["ties"].size() == 1);
  CHECK(rational["ties"][0]["factor"].size() == 2);
  CHECK(rational["forces"][0]["low"] == rational["forces"][1]["low"]);
  CHECK(check_alone("check_certificates.py", critical_certificates, {rational}) == 0);
  // a part in 10^40 apart: different, with equal digits; the shapes are told apart all the same
  const auto stiffness = *parse_decimal("3.0000000000000000000000000000000000000001");
  const Chain<Rational> near({1, 1, 1}, {stiffness, 0, 1});
  const json apart = certificate("near tie", near, certify(near, 2, 0, 30));
  CHECK(apart["forces"][0]["below_high"] == 2);
  CHECK(!apart.contains("ties"));
  const json shapes = certificate("near tie", near, certify(near, 2, 2, 30));
  CHECK(shapes["forces"][0]["below_high"] == 1);
  CHECK(shapes["forces"][0]["shape"]["last"] == 3);
  CHECK(check_alone("check_certificates.py", critical_certificates, {apart, shapes}) == 0);
}

TEST_CASE("a thousand links") {
  std::mt19937_64 random(2);
  const auto chain = graded_chain(random, 1000, 1, 0);
  CHECK(check_alone("check_certificates.py", critical_certificates,
                    {certificate("long", chain, certify(chain, 1, 1, 50))}) == 0);
}
