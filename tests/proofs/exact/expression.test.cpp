#include "proofs/exact/expression.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("identities in sines, cosines and symbols are decided both ways") {
  const Formulas f({"a", "b", "L"});
  CHECK(identical(f.parse("sin(a+b)"), f.parse("sin(a)*cos(b)+cos(a)*sin(b)")));
  CHECK_FALSE(identical(f.parse("sin(a+b)"), f.parse("sin(a)*cos(b)-cos(a)*sin(b)")));
  CHECK(identical(f.parse("sin(3*a)"), f.parse("3*sin(a)-4*sin(a)^3")));
  CHECK(identical(f.parse("cos(-2*a)*L/L"), f.parse("1-2*sin(a)^2")));
  CHECK_FALSE(identical(f.parse("a*sin(a)"), f.parse("sin(a)")));
  CHECK(identical(f.parse("(L^2-a^2)/(L-a)"), f.parse("L+a")));
}

TEST_CASE("proportional means by a number") {
  const Formulas f({"a", "L"});
  CHECK(proportional(f.parse("2*L*sin(a)"), f.parse("-L*sin(a)")));
  CHECK_FALSE(proportional(f.parse("L^2*sin(a)"), f.parse("L*sin(a)")));
}

TEST_CASE("series and limits around zero") {
  const Formulas f({"x", "k"});
  const auto x = f.symbol("x");
  CHECK(limit_at_zero(f.parse("k*x/sin(x)"), x).is_equal(f.symbol("k")));
  CHECK(series_coefficient(f.parse("x/sin(x)"), x, 2).is_equal(GiNaC::numeric(1, 6)));
  CHECK(leading_order(f.parse("2*sin(x)-sin(2*x)"), x) == 3);
  CHECK(leading_order(f.parse("sin(x)-sin(x)"), x, 9) == 9);
  CHECK_THROWS_AS(limit_at_zero(f.parse("1/x"), x), Error);
}

TEST_CASE("a formula has one text, which can be read again") {
  const Formulas f({"L", "k", "x"});
  for (const char* formula : {"2*k/L", "k*x-L", "-1/x", "1/x^2", "k*sin(L-x)^2/L/(L+x)", "3/2*k/sqrt(x)",
                              "x^(2/3)-x/2-1", "-k*(L-1)", "(-2)^x", "2*(k+x)*(L+x)", "sqrt(2)/2"}) {
    CAPTURE(formula);
    CHECK(f.parse(text(f.parse(formula))).is_equal(f.parse(formula)));
  }
  CHECK(text(f.parse("k*x-L")) == "k*x-L");
  CHECK(text(f.parse("k/(x+L)*2*sin(x-L)^2")) == "2*k*sin(x-L)^2/(L+x)");
  CHECK(text(f.parse("-k/x^2-1/L")) == "-1/L-k/x^2");
  // of numbers in front, negative ones, fractions and roots
  CHECK(text(f.parse("-3*k")) == "-3*k");
  CHECK(text(f.parse("-k")) == "-k");
  CHECK(text(f.parse("-2*k/3-L/2")) == "-1/2*L-2/3*k");
  CHECK(text(f.parse("x-3*k")) == "x-3*k");
  CHECK(text(f.parse("1/(2*k)")) == "1/2/k");
  CHECK(text(f.parse("k^(-2)")) == "1/k^2");
  CHECK(text(f.parse("k^(1/2)*3")) == "3*sqrt(k)");
}

TEST_CASE("a formula has the same text in whatever order its symbols came to be") {
  // GiNaC orders terms by the age of symbols and by addresses, and turns sums round by their first term.
  std::vector<std::string> names{"F", "L", "k", "x"};
  const std::vector<std::pair<std::string, std::string>> formulas{
      {"F*(k*x-L)", "-(L-k*x)*F"},
      {"-F*(k*x-L)", "(L-k*x)*F"},
      {"2*F*(L*sin(2*x)-2*L*sin(x))", "-2*(2*L*sin(x)-L*sin(2*x))*F"},
      {"F*(x-L)^3*(k-x)^2", "-(L-x)^3*(k-x)^2*F"},
      {"F*(x-L)^3*(x-k)^2", "-(L-x)^3*(k-x)^2*F"},
      {"1/(x-L)^3", "-1/(L-x)^3"},
      {"F/(x-L)", "-F/(L-x)"},
      {"(x-L)^2", "(L-x)^2"},
      {"sqrt(x-L)*F", "F*sqrt(x-L)"}};
  do {
    const Formulas f(names);
    for (const auto& [formula, expected] : formulas) {
      CHECK(text(f.parse(formula)) == expected);
      CHECK(f.parse(expected).expand().is_equal(f.parse(formula).expand()));
    }
  } while (std::next_permutation(names.begin(), names.end()));
}

TEST_CASE("what cannot be read or decided is refused") {
  const Formulas f({"x"});
  CHECK_THROWS_AS(f.parse("x+y"), Error);
  CHECK_THROWS_AS(f.parse("x+*"), Error);
  CHECK_THROWS_AS(f.symbol("y"), Error);
  CHECK_THROWS_AS(identical(f.parse("exp(x)"), f.parse("x")), Error);
}
