#include "verify/judging/comparison.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

#include "verify/judging/sign.hpp"
#include "verify/report/report.hpp"

using namespace plumbline;
using namespace plumbline::proofs;
using namespace plumbline::verify;

TEST_CASE("printed decimals: rounded right, a little off, wrong") {
  const Interval third = Interval(Rational(1, 3));
  CHECK(judge_decimals({"0.3333"}, {third}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_decimals({"0.3334"}, {third}, {"x"}, "").verdict == Verdict::imprecise);
  CHECK(judge_decimals({"0.34"}, {third}, {"x"}, "").verdict == Verdict::refuted);
  CHECK(judge_decimals({"-0.3333"}, {third}, {"x"}, "").verdict == Verdict::refuted);
  // wider than the rounding: no verdict
  CHECK_THROWS_AS(
      judge_decimals({"0.3333"}, {Interval(Interval::End("0.3"), Interval::End("0.4"))}, {"x"}, ""), Error);
}

TEST_CASE("a printed fraction may mean that all behind the slash is the denominator") {
  const Formulas f({"a", "b", "c"});
  const auto value = f.parse("a/(b*c)");
  CHECK(judge_formulas(f, {"a/(b*c)"}, {value}, {"x"}, "").verdict == Verdict::confirmed);
  CHECK(judge_formulas(f, {"a/b*c"}, {value}, {"x"}, "").verdict == Verdict::convention);
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

TEST_CASE("the table fits 80 columns") {
  const Claim claim{"an-id-that-is-far-too-long-for-its-column",
                    "4.2, (1)",
                    std::string(200, 'x'),
                    {""},
                    [](const Printed&, int) {
                      return Judgement{Verdict::refuted,
                                       std::string(60, 'y') + " " + std::string(60, 'z'),
                                       {{EvidenceKind::theorem, ""}},
                                       ""};
                    }};
  std::istringstream lines(as_table(judge({claim}, 10), false));
  for (std::string line; std::getline(lines, line);) {
    std::size_t columns = 0;
    for (const char c : line) columns += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
    CHECK_MESSAGE(columns <= 80, line);
  }
}
