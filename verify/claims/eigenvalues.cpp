/// \file
/// Section 4.2, the eigenvalue problem: equations (34), (35), the sentences around them, and Algorithm 1.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <map>
#include <plumbline/chain/strain_energy.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/symbolic_chain.hpp"
#include "verify/chains/post_buckling.hpp"
#include "verify/chains/straight_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

Judgement invertible(const Printed& printed, int) {
  bool nonzero = true;
  for (std::size_t n = fewest; n <= most; ++n) {
    const proofs::SymbolicChain chain = proofs::SymbolicChain::generic(n);
    const ex det = proofs::expanded_determinant(matrix_B(chain));
    nonzero =
        nonzero && !det.is_zero() && (det + proofs::closed_form_coefficient(chain, 1)).expand().is_zero();
  }
  return judge_word(
      printed.at(0), nonzero ? "nonzero" : "zero", "det B = -sum_i z_i^2 prod_{j != i} k_j",
      {Evidence::by_checked_theorem("Closed form", {"definite.det_B", "definite.det_B_zero"},
                                    "det B = -sum_i z_i^2 prod_{j != i} k_j, negative unless two joints "
                                    "or more are passive"),
       {EvidenceKind::symbolic, "n = 2 … 6: the determinant by minors equals that sum"}});
}

Judgement determinant_A(const Printed& printed, int) {
  bool zero = true;
  for (std::size_t n = fewest; n <= most; ++n) {
    zero = zero && proofs::expanded_determinant(matrix_A(proofs::SymbolicChain::generic(n))).is_zero();
  }
  return judge_word(printed.at(0), zero ? "zero" : "nonzero", "det A = 0",
                    {Evidence::by_checked_theorem("Closed form", {"definite.det_A"}, "A has a row of zeros"),
                     {EvidenceKind::symbolic, "n = 2 … 6: the last row and column of A vanish"}});
}

/// Both computed once for each n.
std::size_t generic_rank(std::size_t n) {
  static std::map<std::size_t, std::size_t> known;
  const auto found = known.find(n);
  if (found != known.end()) return found->second;
  return known.emplace(n, proofs::rank_of_BinvA(proofs::SymbolicChain::generic(n))).first->second;
}
const proofs::ZeroEigenvalue& generic_zero(std::size_t n) {
  static std::map<std::size_t, proofs::ZeroEigenvalue> known;
  const auto found = known.find(n);
  if (found != known.end()) return found->second;
  return known.emplace(n, proofs::zero_eigenvalue(proofs::SymbolicChain::generic(n))).first->second;
}

Judgement rank(const Printed& printed, int) {
  Judgement result = judge_count(printed.at(0), generic_rank,
                                 "rank(B^-1 A) = n: S1 is invertible, det S1 = (-1)^n L_1 … L_n. A rank does "
                                 "not give the two zeros: they "
                                 "follow from det(A F + B), which is of degree n - 1 in F",
                                 EvidenceKind::symbolic, "symbolic lengths and stiffnesses");
  return with_evidence(result,
                       Evidence::by_checked_theorem("Two zeros", {"eigenvalues.rank_BinvA"},
                                                    "rank n for every chain with at most one passive joint"));
}

Judgement zeros(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return generic_zero(n).algebraic; },
      "the eigenvalue 0 has multiplicity two", EvidenceKind::symbolic,
      "order of lambda in the characteristic polynomial");
  return with_evidence(result, Evidence::by_checked_theorem("Two zeros", {"eigenvalues.zero_twice"},
                                                            "multiplicity two for every n"));
}

Judgement eigenvectors(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0),
      [](std::size_t n) {
        return proofs::distinct_critical_forces(unequal_chain(n)) + generic_zero(n).geometric;
      },
      "B^-1 A is defective: it has n independent eigenvectors, one of each of the n - 1 modes, if these are "
      "simple, "
      "and (0, …, 0, 1) alone for the double eigenvalue 0",
      EvidenceKind::exact, "distinct non-zero eigenvalues and eigenvectors of the eigenvalue 0");
  return with_evidence(result,
                       Evidence::by_checked_theorem("Two zeros",
                                                    {"eigenvalues.kernel_of_BinvA", "eigenvalues.semisimple",
                                                     "eigenvalues.eigenvalues_distinct"},
                                                    "one Jordan block of size two at 0; Simple modes"));
}

/// How many vectors of the Jordan chain at zero describe the unbent chain on its axis.
Judgement straight(const Printed& printed, int) {
  std::size_t unbent = 0;
  std::size_t multiplicity = 0;
  for (std::size_t n = fewest; n <= most; ++n) {
    const proofs::ZeroEigenvalue& zero = generic_zero(n);
    multiplicity = zero.algebraic;
    unbent = 0;
    for (const GiNaC::matrix& v : zero.jordan_chain) {
      bool is_zero = true;
      for (std::size_t i = 0; i < n; ++i) is_zero = is_zero && v.op(i).normal().is_zero();
      unbent += is_zero ? 1 : 0;
    }
  }
  const bool right = printed.at(0) == std::to_string(unbent);
  return {right                                           ? Verdict::confirmed
          : printed.at(0) == std::to_string(multiplicity) ? Verdict::imprecise
                                                          : Verdict::refuted,
          right ? ""
                : "one of them: the eigenvector (0, …, 0, 1) is the unbent chain under a lateral force, at "
                  "infinite F_x = "
                  "-1/lambda; the second vector of its Jordan chain, (-1, 0, …, 0), turns the whole chain "
                  "about its base. "
                  "Neither satisfies (29), (30) at any finite F_x",
          {Evidence::by_checked_theorem("Two zeros", {"eigenvalues.jordan_chain"},
                                        "the Jordan chain at 0, for every n"),
           {EvidenceKind::symbolic,
            fmt::format("n = 2 … 6: Jordan chain of length {} at 0, {} of its vectors has q = 0",
                        multiplicity, unbent)}},
          ""};
}

constexpr const char* nonzero_eigenvalues =
    "the eigenvalues of B^-1 A other than 0 are the -1/F of the critical forces F, for every n";

Judgement eigenvalue_of_force(const Printed& printed, int) {
  const proofs::Formulas formulas({"Fx"});
  const proofs::SymbolicChain chain = proofs::SymbolicChain::generic(3);
  const ex lambda = formulas.parse(printed.at(0));
  const ex Fx = formulas.symbol("Fx");
  const ex left = proofs::characteristic_numerator(chain, lambda);
  const ex right = pow(lambda, 4) * proofs::bordered_determinant(chain, Fx);
  const bool same = proofs::identical(left, right);
  return {same ? Verdict::confirmed : Verdict::refuted,
          same ? "" : "lambda = -1/F_x",
          {Evidence::by_checked_theorem("Two zeros", {"eigenvalues.eigenvalues"}, nonzero_eigenvalues),
           {EvidenceKind::symbolic,
            "n = 3: det(lambda B - A) = lambda^4 det(A F_x + B) identically with the printed lambda"}},
          ""};
}

Judgement force_of_eigenvalue(const Printed& printed, int) {
  const proofs::Formulas formulas({"lambda"});
  const proofs::SymbolicChain chain = proofs::SymbolicChain::generic(3);
  const ex lambda = formulas.symbol("lambda");
  const ex F = formulas.parse(printed.at(0));
  const bool same = proofs::identical(proofs::characteristic_numerator(chain, lambda),
                                      pow(lambda, 4) * proofs::bordered_determinant(chain, F));
  return {same ? Verdict::confirmed : Verdict::refuted,
          same ? "" : "F_x = -1/lambda",
          {Evidence::by_checked_theorem("Two zeros", {"eigenvalues.eigenvalues"}, nonzero_eigenvalues),
           {EvidenceKind::symbolic,
            "n = 3: det(lambda B - A) = lambda^4 det(A F_x + B) identically with the printed F_x"}},
          ""};
}

/// The mode (1, -2) of the chain L = k = (1, 1) at F = 5/2, scaled as printed, put into (29) and (30).
Judgement scaled_mode(const Printed& printed, int) {
  const proofs::Formulas formulas({"mu", "v1", "v2", "v3"});
  const std::vector<Rational> q{1, -2};
  const Chain<Rational> exact({1, 1}, {1, 1});
  const Rational F = energy_factor(exact, q);
  const Rational Fy = lateral_force(exact, F, q);
  const GiNaC::exmap values{{formulas.symbol("v1"), 1},
                            {formulas.symbol("v2"), -2},
                            {formulas.symbol("v3"), formulas.parse(Fy.str())}};
  GiNaC::matrix v(3, 1);
  for (unsigned i = 0; i < 3; ++i) v(i, 0) = formulas.parse(printed.at(i)).subs(values);
  const proofs::SymbolicChain chain{{1, 1}, {1, 1}};
  const GiNaC::matrix residual =
      matrix_A(chain).mul_scalar(formulas.parse(F.str())).add(matrix_B(chain)).mul(v);
  bool right = !proofs::identical(v(0, 0), 0);
  for (unsigned i = 0; i < 3; ++i) right = right && proofs::identical(residual(i, 0), 0);
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "(q, F_y) = mu v",
          {{EvidenceKind::symbolic,
            fmt::format("L = k = (1,1), v = (1,-2,{}), F_x = {}: (29) and (30) hold for every mu", Fy.str(),
                        F.str())}},
          ""};
}

Judgement shape_count(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return 2 * proofs::distinct_critical_forces(unequal_chain(n)); },
      "two shapes, of opposite sign, for each of the n - 1 critical forces", EvidenceKind::exact,
      "distinct roots of det(A F + B), L_i = (3i-1)/i");
  return with_evidence(
      result, Evidence::by_checked_theorem("Simple modes", {"forces.critical_forces", "forces.simple_forces"},
                                           "n - 1 critical forces, by Definiteness, all distinct"));
}

/// The number of eigenvalues with multiplicity, and of those that are not zero, from the characteristic
/// polynomial.
Judgement listed_eigenvalues(const Printed& printed, int) {
  const auto degree = [](std::size_t n) {
    return proofs::characteristic_polynomial(unequal_chain(n)).size() - 1;
  };
  const Judgement all =
      judge_count(printed.at(0), degree, "", EvidenceKind::exact, "degrees of the characteristic polynomial");
  const Judgement nonzero = judge_count(
      printed.at(0),
      [&](std::size_t n) {
        return degree(n) - proofs::multiplicity_of_zero(proofs::characteristic_polynomial(unequal_chain(n)));
      },
      "", EvidenceKind::exact, "degrees of the characteristic polynomial less the power of lambda in it");
  if (all.verdict == Verdict::confirmed) return all;
  Judgement result = nonzero;
  if (nonzero.verdict == Verdict::confirmed) result.verdict = Verdict::convention;
  result.truth = "B^-1 A has n + 1 eigenvalues; the n - 1 that are not zero are meant";
  return with_evidence(result,
                       Evidence::by_checked_theorem("Two zeros", {"eigenvalues.characteristic_polynomial"},
                                                    "of n + 1 eigenvalues two are zero, for every n"));
}

/// Which chains the method serves, found by trying.
Judgement generality(const Printed& printed, int) {
  const auto works = [](std::vector<Rational> stiffness) {
    const std::vector<Rational> length(stiffness.size(), 1);
    try {
      return proofs::distinct_critical_forces(Chain<Rational>(length, std::move(stiffness))) > 0;
    } catch (const Error&) {
      return false;
    }
  };
  const bool elastic = works({1, 2, 3, 4});
  const bool base = works({0, 1, 1});
  const bool interior = works({1, 1, 0, 1});
  const bool two_passive = works({0, 1, 0, 1});
  const bool single = works({1});
  const std::string domain = !elastic                  ? "none"
                             : !base || !interior      ? "elastic joints only"
                             : !two_passive || !single ? "two links or more, at most one passive joint"
                                                       : "arbitrary";
  const bool right = printed.at(0) == domain;
  return {right                                              ? Verdict::confirmed
          : printed.at(0) == "arbitrary" && domain != "none" ? Verdict::imprecise
                                                             : Verdict::refuted,
          right ? ""
                : "it serves " + domain +
                      ": two passive joints make B singular (a mechanism), a single link has no "
                      "non-zero eigenvalue",
          {Evidence::by_checked_theorem("Closed form", {"definite.det_B_zero"},
                                        "det B != 0 exactly when at most one joint is passive"),
           {EvidenceKind::exact,
            fmt::format("tried: elastic {}, passive base {}, passive interior joint {}, two passive joints "
                        "{}, one link {}",
                        elastic, base, interior, two_passive, single)}},
          ""};
}

Judgement agrees_with_4_1(const Printed& printed, const Premises& given, int) {
  const proofs::Polynomial D = proofs::bordered_determinant(given.exact_chain("three-links"));
  const std::optional<Rational> F = proofs::parse_decimal(printed.at(0));
  if (!F) throw Error("claim", printed.at(0), "a multiple of k/L");
  const bool root = proofs::evaluate(D, *F) == 0;
  const bool lowest = count_below(given.exact_chain("three-links"), *F) == 0;
  return {root && lowest ? Verdict::confirmed : Verdict::refuted,
          root && lowest ? "" : "the lowest root is F = k/L",
          {{EvidenceKind::exact,
            fmt::format("L = (1,1,1), k = (0,1,1): det(A F + B) vanishes at F = {}: {}; critical forces "
                        "below it: {}",
                        printed.at(0), root, count_below(given.exact_chain("three-links"), *F))}},
          printed.at(0) + " k/L"};
}

}  // namespace

Checks claims::eigenvalues() {
  return {
      {"B-invertible", invertible},
      {"eq-34", eigenvalue_of_force},
      {"eigenvectors", eigenvectors},
      {"eq-35-force", force_of_eigenvalue},
      {"eq-35-mode", scaled_mode},
      {"two-zeros", zeros},
      {"zeros-are-straight", straight},
      {"det-A", determinant_A},
      {"rank", rank},
      {"shape-count", shape_count},
      {"algorithm-1-general", generality},
      {"algorithm-1-step-3", listed_eigenvalues},
      {"agrees-with-4.1", agrees_with_4_1},
  };
}

}  // namespace plumbline::verify
