#include "verify/judging/notation.hpp"

#include <doctest/doctest.h>

using plumbline::verify::formula_in_print;
using plumbline::verify::in_notation;

TEST_CASE("formulas of the checks in the notation of print") {
  CHECK(in_notation("(J^T)^+ = (J J^T)^-1 J") == "(Jᵀ)⁺ = (J Jᵀ)⁻¹ J");
  CHECK(in_notation("F_x = -1/lambda_i > 0, as delta_x -> 0") == "F_x = −1/λ_i > 0, as δ_x → 0");
  CHECK(in_notation("alpha1+q1 = 2^10*L_12, x^n, x^Tom") == "α₁+q1 = 2¹⁰·L₁₂, x^n, x^Tom");
  CHECK(in_notation("(x0-Delta-L*cos(phi))*Fy-(L) in [-1, n-1]") == "(x0−Δ−L·cos(φ))·Fy−(L) in [−1, n−1]");
  CHECK(in_notation("Z⁻ before, U⁺ after; q_4 != 0; n - 1") == "Z⁻ before, U⁺ after; q₄ ≠ 0; n − 1");
}

TEST_CASE("what is no formula stays as it is") {
  for (const char* const text : {"two-link chains, eq-37 and fig-9-begin", "1e-6 L", "+-+- and -+-+",
                                 "a picture, phial", "U- and Z-shapes, the Z-chain and the U-chain", ""})
    CHECK(in_notation(text) == text);
}

TEST_CASE("a formula of the checks as a line of print") {
  CHECK(formula_in_print("k1*q1") == "k₁q₁");
  CHECK(formula_in_print("sin(2*phi)-2*sin(phi)") == "sin 2φ − 2 sin φ");
  CHECK(formula_in_print("L*(cos(2*phi)+2*cos(phi))*Fy") == "L(cos 2φ + 2 cos φ)F_y");
  CHECK(formula_in_print("n") == "n");
}
