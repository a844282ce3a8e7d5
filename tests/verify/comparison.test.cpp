#include "verify/judging/comparison.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "verify/judging/matrix_formula.hpp"
#include "verify/judging/sign.hpp"
#include "verify/report/errata.hpp"
#include "verify/report/report.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::verify;

TEST_CASE("printed decimals: rounded right, a little off, wrong") {
  const Interval third = Interval(Rational(1, 3));
  CHECK(judge_decimals({"0.3333"}, {third}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_decimals({"0.3334"}, {third}, {"x"}, "").verdict == Verdict::imprecise);
  CHECK(judge_decimals({"0.35"}, {third}, {"x"}, "").verdict == Verdict::refuted);
  CHECK(judge_decimals({"-0.3333"}, {third}, {"x"}, "").verdict == Verdict::refuted);
  // wider than the rounding: no verdict
  CHECK_THROWS_AS(
      judge_decimals({"0.3333"}, {Interval(Interval::End("0.3"), Interval::End("0.4"))}, {"x"}, ""), Error);
}

TEST_CASE("a printed fraction may mean that all behind the slash is the denominator") {
  const Formulas f({"a", "b", "c"});
  const auto value = f.parse("a/(b*c)");
  CHECK(judge_formulas(f, {"a/(b*c)"}, {value}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_formulas(f, {"a/b*c"}, {value}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_formulas(f, {"a*b*c"}, {value}, {"x"}, "").verdict == Verdict::refuted);
  CHECK_THROWS_AS(judge_formulas(f, {"a", "b"}, {value}, {"x"}, ""), Error);
}

TEST_CASE("certain signs and isolated zeros") {
  const auto f = [](const Interval& x) { return sqr(x) - Interval(2); };
  const auto df = [](const Interval& x) { return Interval(2) * x; };
  CHECK(certain_sign(f, Interval(2), Interval(3)) == 1);
  CHECK(certain_sign(f, Interval(0), Interval(1)) == -1);
  CHECK_FALSE(certain_sign(f, Interval(1), Interval(2)));
  const auto zeros = isolate_zeros(f, df, Interval(-3), Interval(5));
  REQUIRE(zeros.size() == 2);
  CHECK(certainly_negative(zeros[0]));
  CHECK(certainly_positive(zeros[1]));
  // a double zero cannot be told from none or two
  const auto square = [](const Interval& x) { return sqr(x); };
  CHECK_THROWS_AS(isolate_zeros(square, df, Interval(-1), Interval(2)), Error);
}

TEST_CASE("matrix formulas: values, and none where sizes do not fit or an inverse is missing") {
  Matrix<Rational> J(2, 3);
  J << 1, 2, 3, -1, 4, 2;
  const NamedMatrices values{{"J", J}, {"F", Matrix<Rational>::Constant(1, 1, 2)}};
  CHECK(evaluated("inv(J*J^T)*J", values) == evaluated("pinv(J^T)", values));
  CHECK(evaluated("-(J-2*J)", values) == J);
  CHECK(evaluated("J*F", values) == evaluated("J+J", values));
  CHECK_FALSE(evaluated("J*J", values));
  CHECK_FALSE(evaluated("J+J^T", values));
  CHECK_FALSE(evaluated("inv(J^T*J)", values));
  CHECK_THROWS_AS(evaluated("J*", values), Error);
  CHECK_THROWS_AS(evaluated("J*K", values), Error);
}

TEST_CASE("what a correction changes") {
  Claim claim;
  CHECK_FALSE(severity(claim, Verdict::confirmed));
  CHECK(severity(claim, Verdict::refuted) == Severity::result);
  CHECK(severity(claim, Verdict::imprecise) == Severity::wording);
  CHECK(severity(claim, Verdict::convention) == Severity::convention);
  claim.subject = Subject::number;
  CHECK(severity(claim, Verdict::imprecise) == Severity::number);
  claim.subject = Subject::name;
  CHECK(severity(claim, Verdict::refuted) == Severity::wording);
}

namespace {

Claim long_claim(const std::string& id, const std::string& cause) {
  Claim claim;
  claim.id = id;
  claim.where = "4.2, (1)";
  claim.quote = std::string(100, 'q');
  claim.reading = std::string(200, 'x');
  claim.printed = {"0"};
  claim.cause = cause;
  claim.check = [](const Printed&, int) {
    return Judgement{
        Verdict::refuted, std::string(60, 'y') + " " + std::string(60, 'z'), {{EvidenceKind::exact, ""}}, ""};
  };
  return claim;
}

}  // namespace

TEST_CASE("the table fits its terminal, and is whole where there is none") {
  const auto judged = judge({long_claim("an-id-that-is-far-too-long-for-its-column", "it")}, 10);
  std::istringstream lines(as_table(judged, {false, 80}));
  for (std::string line; std::getline(lines, line);) {
    std::size_t columns = 0;
    for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    CHECK_MESSAGE(columns <= 80, line);
  }
  CHECK(as_table(judged, {}).find(judged[0].claim.reading) != std::string::npos);
}

TEST_CASE("claims of one cause are one erratum, as grave as the gravest") {
  std::vector<Claim> claims{long_claim("a", "one"), long_claim("b", "one"), long_claim("c", "other")};
  claims[0].subject = Subject::name;
  claims[2].subject = Subject::name;
  const std::vector<Erratum> found = errata(judge(claims, 10));
  REQUIRE(found.size() == 2);
  CHECK(found[0].claims.size() == 2);
  CHECK(found[0].severity == Severity::result);
  CHECK(found[1].severity == Severity::wording);
}
