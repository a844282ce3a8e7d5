#include "verify/judging/comparison.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "verify/judging/formula_value.hpp"
#include "verify/judging/matrix_formula.hpp"
#include "verify/judging/sign.hpp"
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

TEST_CASE("a printed zero among decimals is zero, and no number that rounds to it") {
  CHECK(judge_decimals({"0"}, {Interval(0)}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_decimals({"0"}, {Interval(Rational(1, 3))}, {"x"}, "").verdict == Verdict::refuted);
}

TEST_CASE("a claim read with favour has all behind a slash as its denominator, and says so") {
  const Formulas f({"a", "b", "c"});
  Claim claim;
  claim.printed = {"a/b*c"};
  claim.check = Check([&](const Printed& printed, int) {
    return judge_formulas(f, printed, {f.parse("a/(b*c)")}, {"x"}, "");
  });
  CHECK(judge_print(claim, claim.printed, 10).verdict == Verdict::refuted);
  claim.charitable = true;
  const Judgement favoured = judge_print(claim, claim.printed, 10);
  CHECK(favoured.verdict == Verdict::confirmed);
  // what is shown is what was judged
  CHECK(favoured.favoured == Printed{"a/(b*c)"});
  CHECK(judge_print(claim, {"a*b*c"}, 10).verdict == Verdict::refuted);
  CHECK(judge_print(claim, {"a/(b*c)"}, 10).favoured.empty());
  CHECK_THROWS_AS(judge_formulas(f, {"a", "b"}, {f.parse("a")}, {"x"}, ""), Error);
}

TEST_CASE("sides of equations are equal up to a factor that is not zero") {
  const Formulas f({"a", "b"});
  const auto computed = f.parse("a-2*b");
  CHECK(judge_equations(f, {"2*b-a"}, {computed}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_equations(f, {"3*a-6*b"}, {computed}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_equations(f, {"a+2*b"}, {computed}, {"x"}, "").verdict == Verdict::refuted);
  CHECK(judge_equations(f, {"0"}, {computed}, {"x"}, "").verdict == Verdict::refuted);
}

TEST_CASE("counts are equal in any order, with one and several, and without what there is none of") {
  CHECK(Counts("1 saddle, 2 minima") == Counts("2 minima, 1 saddles, 0 maxima"));
  CHECK(Counts("2 minima, 1 saddle").text() == "2 minima, 1 saddle");
  CHECK(Counts("1 minimum, 1 maximum") != Counts("1 minimum, 1 saddle"));
  CHECK(Counts("2 stable, 2 unstable").total() == 4);
  CHECK_THROWS_AS(Counts("two minima"), Error);
  CHECK_THROWS_AS(Counts("2 peaks"), Error);
}

TEST_CASE("rows of a table may stand in any order, and not be mixed") {
  const Printed rows{"U", "stable", "Z", "unstable"};
  CHECK(judge_rows({"Z", "unstable", "U", "stable"}, rows, 2, "", {}).verdict == Verdict::confirmed);
  CHECK(judge_rows({"Z", "stable", "U", "unstable"}, rows, 2, "", {}).verdict == Verdict::refuted);
  CHECK(judge_rows({"U", "stable"}, rows, 2, "", {}).verdict == Verdict::refuted);
}

TEST_CASE("values of formulas, decimals exactly") {
  CHECK(number("0.1").contains(Rational(1, 10)));
  CHECK(number("-pi/4").inside(hull(Interval(Rational(-7854, 10000)), Interval(Rational(-7853, 10000)))));
  const Formulas f({"a"});
  const Interval root = value_of(f.parse("sqrt(a)/a^2+sin(a)^2+cos(a)^2"), {{"a", Interval(4)}});
  CHECK(root.contains(Rational(9, 8)));
  CHECK(with_fractions("0.4*x+12.50") == "(2/5)*x+(25/2)");
  CHECK_THROWS_AS(value_of(f.parse("a")), Error);
  CHECK_THROWS_AS(number("x"), Error);
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
  CHECK(evaluated("pinv(J)^T", values) == evaluated("pinv(J^T)", values));
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
  CHECK(severity(claim, Verdict::refuted) == Severity::statement);
  CHECK(severity(claim, Verdict::convention) == Severity::convention);
  claim.subject = Subject::number;
  CHECK(severity(claim, Verdict::imprecise) == Severity::formula);
  claim.subject = Subject::formula;
  CHECK(severity(claim, Verdict::refuted) == Severity::formula);
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
  claim.check = Check([](const Printed&, int) {
    return Judgement{
        Verdict::refuted, std::string(60, 'y') + " " + std::string(60, 'z'), {{EvidenceKind::exact, ""}}, ""};
  });
  return claim;
}

}  // namespace

TEST_CASE("the table fits its terminal, and is whole where there is none") {
  const auto judged = judge({long_claim("an-id-that-is-far-too-long-for-its-column", "it")}, 10);
  std::istringstream lines(as_table(paper(), judged, {false, 80}));
  for (std::string line; std::getline(lines, line);) {
    std::size_t columns = 0;
    for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    CHECK_MESSAGE(columns <= 80, line);
  }
  CHECK(as_table(paper(), judged, {}).find(judged[0].claim.reading) != std::string::npos);
}
