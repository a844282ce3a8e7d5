#include "support/page/formula.hpp"

#include <doctest/doctest.h>

using plumbline::page::as_mathml;

namespace {

std::string set(const std::string& formula) {
  return as_mathml(formula).value_or("none");
}

}  // namespace

TEST_CASE("formulas are set as they are typed") {
  CHECK(set("q1") == "<math><msub><mi>q</mi><mn>1</mn></msub></math>");
  CHECK(set("alpha") == "<math><mi>α</mi></math>");
  CHECK(set("-k") == "<math><mo>−</mo><mrow><mi>k</mi></mrow></math>");
  CHECK(set("2/L").find("<mfrac>") != std::string::npos);
  // brackets stay where they are needed, and go from what a fraction holds together
  CHECK(set("(a+b)*c").find("(</mo>") != std::string::npos);
  CHECK(set("(a+b)/(c+d)").find("(</mo>") == std::string::npos);
  CHECK(set("a/(c+d)^2").find("(</mo>") != std::string::npos);
  // and are as tall as what they hold
  CHECK(set("sin(a+b)").find("<mo stretchy=\"false\">(</mo>") != std::string::npos);
  CHECK(set("2*(a/b+c)").find("<mo>(</mo>") != std::string::npos);
  CHECK(set("inv(J)") ==
        "<math><msup><mrow><mi>J</mi></mrow><mrow><mo>−</mo><mn>1</mn></mrow></msup></math>");
  CHECK(set("sin(phi)").find("<mi>sin</mi>") != std::string::npos);
}

TEST_CASE("what is no formula is none") {
  for (const char* text : {"", "minimum", "2 stable, 2 unstable", "a+", "(a", "f(x)", "-+-+", "1.2.x"})
    CHECK_MESSAGE(!as_mathml(text), text);
}
