/// \file
/// Section 4.2, the eigenvalue problem: equations (34) to (39), the sentences around them, and Algorithm 1.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <plumbline/critical_force.hpp>
#include <plumbline/strain_energy.hpp>

#include "proofs/decimal.hpp"
#include "proofs/exact_chain.hpp"
#include "proofs/symbolic_chain.hpp"
#include "verify/claims.hpp"
#include "verify/judging.hpp"

namespace plumbline {
namespace {

using GiNaC::ex;

constexpr std::size_t fewest = 2;
constexpr std::size_t most = 6;

/// A chain of n unequal links and springs, exact.
Chain<Rational> sample_chain(std::size_t n) {
  std::vector<Rational> length;
  std::vector<Rational> stiffness;
  for (std::size_t i = 0; i < n; ++i) {
    length.emplace_back(static_cast<int>(3 * i + 2), static_cast<int>(i + 1));
    stiffness.emplace_back(static_cast<int>(7 * i % 5 + 1), 2);
  }
  return Chain<Rational>(length, stiffness);
}

Chain<Rational> three_link_chain() { return Chain<Rational>({1, 1, 1}, {0, 1, 1}); }

/// A printed count such as "n-1" against the count computed for n = 2 … 6.
Judgement judge_count(const std::string& printed, const std::function<std::size_t(std::size_t)>& count,
                      const std::string& truth, EvidenceKind kind, const std::string& how) {
  const Formulas formulas({"n"});
  const ex formula = formulas.parse(printed);
  bool right = true;
  std::vector<std::string> found;
  for (std::size_t n = fewest; n <= most; ++n) {
    const std::size_t computed = count(n);
    right = right && identical(formula.subs(formulas.symbol("n") == static_cast<int>(n)), static_cast<int>(computed));
    found.push_back(fmt::format("{}", computed));
  }
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth,
          {{kind, fmt::format("n = 2 … 6: {} ({})", fmt::join(found, ", "), how)}}, ""};
}

Judgement& also(Judgement& judgement, EvidenceKind kind, const std::string& detail) {
  judgement.evidence.push_back({kind, detail});
  std::stable_sort(judgement.evidence.begin(), judgement.evidence.end(),
                   [](const Evidence& a, const Evidence& b) { return a.kind < b.kind; });
  return judgement;
}

Judgement invertible(const Printed& printed, int) {
  bool nonzero = true;
  for (std::size_t n = fewest; n <= most; ++n) {
    const SymbolicChain chain = SymbolicChain::generic(n);
    const ex det = expanded_determinant(matrix_B(chain));
    nonzero = nonzero && !det.is_zero() && (det + closed_form_coefficient(chain, 1)).expand().is_zero();
  }
  return judge_word(printed.at(0), nonzero ? "nonzero" : "zero", {"nonzero", "zero"},
                    "det B = -sum_i z_i^2 prod_{j != i} k_j",
                    {{EvidenceKind::theorem, "Definiteness: det B = -sum_i z_i^2 prod_{j != i} k_j, negative unless two joints "
                                             "or more are passive"},
                     {EvidenceKind::symbolic, "n = 2 … 6: the determinant by minors equals that sum"}});
}

Judgement determinant_A(const Printed& printed, int) {
  bool zero = true;
  for (std::size_t n = fewest; n <= most; ++n) {
    zero = zero && expanded_determinant(matrix_A(SymbolicChain::generic(n))).is_zero();
  }
  return judge_word(printed.at(0), zero ? "zero" : "nonzero", {"nonzero", "zero"}, "det A = 0",
                    {{EvidenceKind::symbolic, "n = 2 … 6: the last row and column of A vanish"}});
}

std::size_t generic_rank(std::size_t n) { return rank_of_BinvA(SymbolicChain::generic(n)); }
ZeroEigenvalue generic_zero(std::size_t n) { return zero_eigenvalue(SymbolicChain::generic(n)); }

Judgement rank(const Printed& printed, int) {
  Judgement result = judge_count(printed.at(0), generic_rank,
                                 "rank(B^-1 A) = n: S1 is invertible, det S1 = (-1)^n L_1 … L_n; the double eigenvalue 0 has "
                                 "one eigenvector only",
                                 EvidenceKind::symbolic, "symbolic lengths and stiffnesses");
  return also(result, EvidenceKind::theorem, "Two zeros: rank n for every chain with at most one passive joint");
}

Judgement zeros(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return generic_zero(n).algebraic; }, "the eigenvalue 0 has multiplicity two",
      EvidenceKind::symbolic, "order of lambda in the characteristic polynomial");
  return also(result, EvidenceKind::theorem, "Two zeros: multiplicity two for every n");
}

Judgement eigenvectors(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return distinct_critical_forces(sample_chain(n)) + generic_zero(n).geometric; },
      "B^-1 A is defective: it has n independent eigenvectors, n - 1 of the modes and (0, …, 0, 1)", EvidenceKind::exact,
      "distinct non-zero eigenvalues and eigenvectors of the eigenvalue 0");
  return also(result, EvidenceKind::theorem, "Two zeros: one Jordan block of size two at 0; Simple modes");
}

/// How many vectors of the Jordan chain at zero describe the unbent chain on its axis.
Judgement straight(const Printed& printed, int) {
  std::size_t unbent = 0;
  std::size_t multiplicity = 0;
  for (std::size_t n = fewest; n <= most; ++n) {
    const ZeroEigenvalue zero = generic_zero(n);
    multiplicity = zero.algebraic;
    unbent = 0;
    for (const GiNaC::matrix& v : zero.jordan_chain) {
      bool is_zero = true;
      for (std::size_t i = 0; i < n; ++i) is_zero = is_zero && v.op(i).normal().is_zero();
      unbent += is_zero ? 1 : 0;
    }
  }
  const bool right = printed.at(0) == std::to_string(unbent);
  return {right                                            ? Verdict::confirmed
          : printed.at(0) == std::to_string(multiplicity) ? Verdict::imprecise
                                                           : Verdict::refuted,
          right ? ""
                : "one of them: the eigenvector (0, …, 0, 1) is the unbent chain under a lateral force, at infinite F_x = "
                  "-1/lambda; the second vector of its Jordan chain, (-1, 0, …, 0), turns the whole chain about its base. "
                  "Neither satisfies (29), (30) at any finite F_x",
          {{EvidenceKind::symbolic, fmt::format("n = 2 … 6: Jordan chain of length {} at 0, {} of its vectors has q = 0",
                                                multiplicity, unbent)}},
          ""};
}

Judgement eigenvalue_of_force(const Printed& printed, int) {
  const Formulas formulas({"Fx"});
  const SymbolicChain chain = SymbolicChain::generic(3);
  const ex lambda = formulas.parse(printed.at(0));
  const ex Fx = formulas.symbol("Fx");
  const ex left = characteristic_numerator(chain, lambda);
  const ex right = pow(lambda, 4) * bordered_determinant(chain, Fx);
  const bool same = identical(left, right);
  return {same ? Verdict::confirmed : Verdict::refuted, same ? "" : "lambda = -1/F_x",
          {{EvidenceKind::symbolic, "n = 3: det(lambda B - A) = lambda^4 det(A F_x + B) identically with the printed lambda"}},
          ""};
}

Judgement force_of_eigenvalue(const Printed& printed, int) {
  const Formulas formulas({"lambda"});
  const SymbolicChain chain = SymbolicChain::generic(3);
  const ex lambda = formulas.symbol("lambda");
  const ex F = formulas.parse(printed.at(0));
  const bool same = identical(characteristic_numerator(chain, lambda), pow(lambda, 4) * bordered_determinant(chain, F));
  return {same ? Verdict::confirmed : Verdict::refuted, same ? "" : "F_x = -1/lambda",
          {{EvidenceKind::symbolic, "n = 3: det(lambda B - A) = lambda^4 det(A F_x + B) identically with the printed F_x"}},
          ""};
}

/// The mode (1, -1, -1) of the chain (1, 1, 1), (0, 1, 1) at F = 1, scaled as printed, put into (29) and (30).
Judgement scaled_mode(const Printed& printed, int) {
  const Formulas formulas({"mu", "v1", "v2", "v3", "v4"});
  const SymbolicChain chain{{1, 1, 1}, {0, 1, 1}};
  const std::vector<Rational> q{1, -1, -1};
  const Rational Fy = lateral_force(three_link_chain(), Rational(1), q);
  GiNaC::matrix v(4, 1);
  GiNaC::exmap values;
  for (unsigned i = 0; i < 3; ++i) values[formulas.symbol(fmt::format("v{}", i + 1))] = i == 0 ? 1 : -1;
  values[formulas.symbol("v4")] = formulas.parse(Fy.str());
  for (unsigned i = 0; i < 4; ++i) v(i, 0) = formulas.parse(printed.at(i)).subs(values);
  const GiNaC::matrix residual = matrix_A(chain).add(matrix_B(chain)).mul(v);  // F_x = 1
  bool zero = true;
  for (unsigned i = 0; i < 4; ++i) zero = zero && identical(residual(i, 0), 0);
  const bool grows = !identical(v(0, 0), 0);
  return {zero && grows ? Verdict::confirmed : Verdict::refuted, zero && grows ? "" : "(q, F_y) = mu v",
          {{EvidenceKind::symbolic, "L = (1,1,1), k = (0,1,1), v = (1,-1,-1," + Fy.str() +
                                        "), F_x = 1: (29) and (30) hold for every mu"}}, ""};
}

Judgement shape_count(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return 2 * distinct_critical_forces(sample_chain(n)); },
      "two shapes, of opposite sign, for each of the n - 1 critical forces", EvidenceKind::exact,
      "distinct roots of det(A F + B), L_i = (3i-1)/i");
  return also(result, EvidenceKind::theorem, "Definiteness and Simple modes: n - 1 distinct critical forces");
}

Judgement energy_count(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return distinct_critical_forces(sample_chain(n)); },
      "n - 1 energies E_i = F_i delta_x, each of two mirrored shapes", EvidenceKind::exact,
      "distinct roots of det(A F + B), L_i = (3i-1)/i");
  return also(result, EvidenceKind::theorem, "Energy factor and Simple modes");
}

/// Negative directions of E - F delta_x on the shapes with delta_y = 0, by exact elimination.
std::size_t negative_directions(const Chain<Rational>& chain, const Rational& F) {
  const Vector<Rational> z = matrix_S0(chain);
  const Eigen::Index free = z.size() - 1;
  Matrix<Rational> form = F * matrix_S1(chain);
  for (Eigen::Index i = 0; i < z.size(); ++i) form(i, i) += chain.stiffness()[static_cast<std::size_t>(i)];
  Matrix<Rational> basis = Matrix<Rational>::Zero(free + 1, free);
  for (Eigen::Index j = 0; j < free; ++j) {
    basis(0, j) = -z(j + 1) / z(0);
    basis(j + 1, j) = 1;
  }
  Matrix<Rational> reduced = basis.transpose() * form * basis;
  std::size_t negative = 0;
  for (Eigen::Index i = 0; i < free; ++i) {
    if (reduced(i, i) == 0) throw Error("elimination", "a zero pivot", "a force that makes none");
    negative += reduced(i, i) < 0 ? 1 : 0;
    for (Eigen::Index j = i + 1; j < free; ++j) {
      const Rational factor = reduced(j, i) / reduced(i, i);
      for (Eigen::Index c = i; c < free; ++c) reduced(j, c) -= factor * reduced(i, c);
    }
  }
  return negative;
}

Judgement buckles_at(const Printed& printed, int) {
  const Chain<Rational> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  std::string found;
  bool first = true;
  // forces between the critical ones 0.92…, 2.30…, 3.51… and beyond them
  for (const auto& [F, expected] : std::vector<std::pair<Rational, std::size_t>>{
           {Rational(9, 10), 0}, {Rational(19, 20), 1}, {Rational(12, 5), 2}, {Rational(18, 5), 3}}) {
    const std::size_t negative = negative_directions(chain, F);
    if (negative != count_below(chain, F)) throw Error("count", "different results of recursion and elimination", "agreement");
    first = first && negative == expected;
    found += fmt::format("{}F = {}: {}", found.empty() ? "" : ", ", F.str(), negative);
  }
  return judge_word(printed.at(0), first ? "lowest" : "another", {"lowest", "highest", "another"},
                    "the straight shape loses its stability at the lowest critical force",
                    {{EvidenceKind::theorem, "Definiteness: E - F delta_x is positive definite on delta_y = 0 just below the "
                                             "lowest critical force, and each further one adds a negative direction"},
                     {EvidenceKind::exact, "unit chain of four links, negative directions by elimination: " + found}});
}

/// F_x^0 = sign / max |lambda|, against (35) with the lowest force of the unit chain of four links.
Judgement critical_force(const Printed& printed, int) {
  const Chain<Rational> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  const Polynomial chi = characteristic_polynomial(chain);
  // all coefficients positive: no positive root, so that every non-zero lambda is negative and -1/lambda positive
  bool negative_roots = true;
  for (std::size_t i = 2; i <= chain.size() + 1; ++i) negative_roots = negative_roots && chi.at(i) > 0;
  const bool right = printed.at(0) == (negative_roots ? "1" : "-1");
  return {right ? Verdict::confirmed : Verdict::refuted,
          right ? "" : "F_x^0 = +1/max|lambda_i|: every non-zero lambda_i is negative and (35) reads F_x = -1/lambda_i > 0, as "
                       "Table 3 lists it (0.9240)",
          {{EvidenceKind::theorem, "Definiteness: all n - 1 forces -1/lambda_i are positive"},
           {EvidenceKind::exact, fmt::format("unit chain of four links: the coefficients of the characteristic polynomial are "
                                             "all positive: {}", negative_roots)}},
          ""};
}

Judgement listed_eigenvalues(const Printed& printed, int) {
  const Judgement all = judge_count(printed.at(0), [](std::size_t n) { return n + 1; }, "", EvidenceKind::exact,
                                    "eigenvalues of an (n+1) x (n+1) matrix");
  const Judgement nonzero = judge_count(printed.at(0), [](std::size_t n) { return n + 1 - generic_zero(n).algebraic; }, "",
                                        EvidenceKind::symbolic, "non-zero eigenvalues");
  if (all.verdict == Verdict::confirmed) return all;
  Judgement result = nonzero;
  if (nonzero.verdict == Verdict::confirmed) result.verdict = Verdict::convention;
  result.truth = "B^-1 A has n + 1 eigenvalues; the n - 1 that are not zero are meant";
  return result;
}

/// Which chains the method serves, found by trying.
Judgement generality(const Printed& printed, int) {
  const auto works = [](std::vector<Rational> stiffness) {
    const std::vector<Rational> length(stiffness.size(), 1);
    try {
      return distinct_critical_forces(Chain<Rational>(length, std::move(stiffness))) > 0;
    } catch (const Error&) {
      return false;
    }
  };
  const bool elastic = works({1, 2, 3, 4});
  const bool base = works({0, 1, 1});
  const bool interior = works({1, 1, 0, 1});
  const bool two_passive = works({0, 1, 0, 1});
  const bool single = works({1});
  const std::string domain = !elastic                    ? "none"
                             : !base || !interior        ? "elastic joints only"
                             : !two_passive || !single   ? "two links or more, at most one passive joint"
                                                         : "arbitrary";
  const bool right = printed.at(0) == domain;
  return {right                                                  ? Verdict::confirmed
          : printed.at(0) == "arbitrary" && domain != "none"     ? Verdict::imprecise
                                                                 : Verdict::refuted,
          right ? "" : "it serves " + domain + ": two passive joints make B singular (a mechanism), a single link has no "
                       "non-zero eigenvalue",
          {{EvidenceKind::theorem, "Definiteness: det B != 0 exactly when at most one joint is passive"},
           {EvidenceKind::exact, fmt::format("tried: elastic {}, passive base {}, passive interior joint {}, two passive joints "
                                             "{}, one link {}", elastic, base, interior, two_passive, single)}},
          ""};
}

Judgement agrees_with_4_1(const Printed& printed, int) {
  const Polynomial D = bordered_determinant(three_link_chain());
  const std::optional<Rational> F = parse_decimal(printed.at(0));
  if (!F) throw Error("claim", printed.at(0), "a multiple of k/L");
  const bool root = evaluate(D, *F) == 0;
  const bool lowest = count_below(three_link_chain(), *F) == 0;
  return {root && lowest ? Verdict::confirmed : Verdict::refuted, root && lowest ? "" : "the lowest root is F = k/L",
          {{EvidenceKind::exact, fmt::format("L = (1,1,1), k = (0,1,1): det(A F + B) vanishes at F = {}: {}; critical forces "
                                             "below it: {}", printed.at(0), root, count_below(three_link_chain(), *F))}},
          printed.at(0) + " k/L"};
}

/// Symbols of a mode of four links: L, k, v and mu.
struct SymbolicMode {
  SymbolicChain chain = SymbolicChain::generic(4);
  Formulas formulas;
  std::vector<ex> v;
  ex energy = 0, shortening = 0;
  SymbolicMode()
      : formulas([] {
          std::vector<std::string> names{"mu"};
          for (int i = 1; i <= 4; ++i) {
            for (const char* name : {"L", "k", "v"}) names.push_back(fmt::format("{}{}", name, i));
          }
          return names;
        }()) {
    const ex mu = formulas.symbol("mu");
    ex theta = 0;
    for (int i = 1; i <= 4; ++i) {
      const ex q = mu * formulas.symbol(fmt::format("v{}", i));
      theta += q;
      energy += formulas.symbol(fmt::format("k{}", i)) * pow(q, 2) / 2;
      shortening += formulas.symbol(fmt::format("L{}", i)) * pow(theta, 2) / 2;
    }
  }
};

Judgement mode_energy(const Printed& printed, int) {
  const SymbolicMode mode;
  return judge_formulas(mode.formulas, printed, {mode.energy, mode.shortening}, {"E_i", "delta_x"},
                        "q = mu v in sum k q^2 / 2 and in (25), n = 4");
}

Judgement factor(const Printed& printed, int) {
  const SymbolicMode mode;
  return judge_formulas(mode.formulas, printed, {mode.energy / mode.shortening}, {"mu_i^0"}, "E_i / delta_x of (37), n = 4");
}

Judgement energy_law(const Printed& printed, int) {
  const SymbolicMode mode;
  const Formulas formulas({"f", "dx"});
  const ex right_side = formulas.parse(printed.at(0)).subs(
      GiNaC::lst{formulas.symbol("f") == mode.energy / mode.shortening, formulas.symbol("dx") == mode.shortening});
  const bool right = identical(right_side, mode.energy);
  return {right ? Verdict::confirmed : Verdict::refuted, right ? "" : "E_i = mu_i^0 delta_x",
          {{EvidenceKind::symbolic, "(37) and (39) inserted, n = 4; leading order in delta_x, as (25) is"}}, ""};
}

Judgement factor_order(const Printed& printed, int) {
  bool equal = true;
  const ex F = GiNaC::realsymbol("F");
  for (std::size_t n = fewest; n <= most; ++n) equal = equal && energy_factor_of_mode(n, F).is_equal(F);
  return judge_word(printed.at(0), equal ? "largest" : "another", {"largest", "smallest", "another"},
                    "mu_i^0 = -1/lambda_i: the smallest factor belongs to the largest |lambda|",
                    {{EvidenceKind::theorem, "Energy factor: mu_i^0 = F_i = -1/lambda_i exactly, for every mode of every chain"},
                     {EvidenceKind::symbolic, "n = 2 … 6: (29) and (30) inserted in (39) leave F"}});
}

/// Negative directions at a small bent shape of mode m, among those that keep the end point: one for each lower mode.
Judgement first_mode(const Printed& printed, int) {
  const Chain<Rational> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  // just above F_m: m negative directions, of which the mode itself is one, which the end point forbids
  const std::vector<Rational> above{Rational(925, 1000), Rational(2306, 1000), Rational(352, 100)};
  std::string stable;
  std::string found;
  for (std::size_t m = 0; m < above.size(); ++m) {
    const std::size_t index = negative_directions(chain, above[m]) - 1;
    if (index == 0) stable += std::to_string(m + 1);
    found += fmt::format("{}mode {}: {}", m == 0 ? "" : ", ", m + 1, index);
  }
  const std::string which = stable == "1" ? "minimum" : "another";
  return judge_word(printed.at(0), which, {"minimum", "maximum", "another"}, "only the mode of the minimum energy is stable",
                    {{EvidenceKind::exact, "unit chain of four links, negative directions of the energy at the small bent shape "
                                           "under an imposed end point: " + found}});
}

}  // namespace

std::vector<Claim> eigenvalue_claims() {
  const std::string k_sum = "k1*v1^2+k2*v2^2+k3*v3^2+k4*v4^2";
  const std::string L_sum = "L1*v1^2+L2*(v1+v2)^2+L3*(v1+v2+v3)^2+L4*(v1+v2+v3+v4)^2";
  return {
      {"B-invertible", "4.2, before (34)", "B is invertible, det B != 0", {"nonzero"}, invertible},
      {"eq-34", "4.2, (34)", "(B^-1 A - lambda I) v = 0 with lambda = -1/F_x", {"-1/Fx"}, eigenvalue_of_force},
      {"eigenvectors", "4.2, before (35)", "B^-1 A has the eigenvectors v_1, …, v_{n+1}", {"n+1"}, eigenvectors},
      {"eq-35-force", "4.2, (35)", "F_x = -1/lambda_i", {"-1/lambda"}, force_of_eigenvalue},
      {"eq-35-mode", "4.2, (35)", "q_j = mu v_ij, F_y = mu v_{i,n+1}", {"mu*v1", "mu*v2", "mu*v3", "mu*v4"}, scaled_mode},
      {"two-zeros", "4.2, after (35)", "exactly two eigenvalues are zero", {"2"}, zeros},
      {"zeros-are-straight", "4.2, after (35)", "the two zero eigenvalues correspond to a straight configuration", {"2"},
       straight},
      {"det-A", "4.2, after (35)", "det A = 0", {"zero"}, determinant_A},
      {"rank", "4.2, after (35)", "rank(B^-1 A) = n - 1", {"n-1"}, rank},
      {"shape-count", "4.2, before (36)", "there are 2(n-1) possible shapes", {"2*(n-1)"}, shape_count},
      {"buckles-at-lowest", "4.2, before (36)", "buckling happens at the lowest of the equilibrium loadings", {"lowest"},
       buckles_at},
      {"eq-36", "4.2, (36)", "critical force F_x^0 = -1/max|lambda_i|", {"-1"}, critical_force},
      {"eq-37", "4.2, (37)", "E_i and delta_x of a mode",
       {"mu^2/2*(" + k_sum + ")", "mu^2/2*(" + L_sum + ")"}, mode_energy},
      {"eq-38", "4.2, (38)", "E_i = mu_i^0 delta_x", {"f*dx"}, energy_law},
      {"eq-39", "4.2, (39)", "energy factor mu_i^0", {"(" + k_sum + ")/(" + L_sum + ")"}, factor},
      {"energy-count", "4.2, after (39)", "for one delta_x there are n-1 shapes with different energies", {"n-1"},
       energy_count},
      {"first-mode-observed", "4.2, after (39)", "the mode with the minimum energy factor is the one observed", {"minimum"},
       first_mode},
      {"factor-order", "4.2, after (39)", "the minimum of mu_i^0 belongs to the largest |lambda_i|", {"largest"},
       factor_order},
      {"algorithm-1-general", "4.2, before Algorithm 1", "it applies to arbitrary link lengths and joint stiffnesses",
       {"arbitrary"}, generality},
      {"algorithm-1-step-3", "4.2, Algorithm 1", "step 3: the eigenvalues lambda_1 … lambda_{n-1} of B^-1 A", {"n-1"},
       listed_eigenvalues},
      {"algorithm-1-step-4", "4.2, Algorithm 1", "step 4: F_x^0 = -1/max|lambda_i|", {"-1"}, critical_force},
      {"agrees-with-4.1", "4.2, last paragraph", "the method agrees with the critical force of 4.1, k/L", {"1"},
       agrees_with_4_1},
  };
}

}  // namespace plumbline
