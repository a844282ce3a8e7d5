/// \file
/// Section 4.2, the energy of the modes: equations (37) to (39) and the sentences around them.

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/symbolic_chain.hpp"
#include "verify/chains/straight_chains.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

using GiNaC::ex;

/// Symbols of a mode of four links: L, k, v and mu.
struct SymbolicMode {
  proofs::SymbolicChain chain = proofs::SymbolicChain::generic(4);
  proofs::Formulas formulas;
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

Judgement factor_order(const Printed& printed, int) {
  bool equal = true;
  const ex F = GiNaC::realsymbol("F");
  for (std::size_t n = fewest; n <= most; ++n)
    equal = equal && proofs::energy_factor_of_mode(n, F).is_equal(F);
  return judge_word(
      printed.at(0), equal ? "largest" : "another",
      "mu_i^0 = -1/lambda_i: the smallest factor belongs to the largest |lambda|",
      {Evidence::by_checked_theorem("Energy factor", {"definite.energy_factor", "eigenvalues.eigenvalues"},
                                    "mu_i^0 = F_i = -1/lambda_i exactly, for every mode of every chain"),
       {EvidenceKind::symbolic, "n = 2 … 6: (29) and (30) inserted in (39) leave F"}});
}

/// Negative directions at a small bent shape of each mode, among those that keep the end point: the force of
/// mode m is the m-th, and just above it m directions are negative, of which the mode itself is one, which
/// the end point forbids.
Judgement first_mode(const Printed& printed, const Premises& given, int) {
  const Chain<Rational> chain = given.exact_chain("unit-chain");
  const std::size_t modes = chain.size() - 1;
  const auto forces = proofs::enclose_critical_forces(chain, modes, 30);
  std::string found, stable;
  for (std::size_t m = 0; m < modes; ++m) {
    const std::size_t index = count_below(chain, forces[m].high) - 1;
    if (count_below(chain, forces[m].low) != m || index != m)
      throw Error("mode " + std::to_string(m + 1), std::to_string(index) + " negative directions",
                  std::to_string(m) + ", by the theorem “Count of shapes”");
    if (index == 0) stable += std::to_string(m + 1);
    found += fmt::format("{}mode {}: {}", m == 0 ? "" : ", ", m + 1, index);
  }
  const std::string which = stable == "1" ? "minimum" : "another";
  return judge_word(
      printed.at(0), which, "only the mode of the minimum energy is stable",
      {Evidence::by_theorem("Count of shapes", "at the small shape of mode m m - 1 directions are negative"),
       {EvidenceKind::exact,
        "the chain of the example, critical forces below the upper bound of F_m, to 30 digits, less one: " +
            found}});
}

Judgement energy_count(const Printed& printed, int) {
  Judgement result = judge_count(
      printed.at(0), [](std::size_t n) { return proofs::distinct_critical_forces(unequal_chain(n)); },
      "n - 1 energies E_i = F_i delta_x, each of two mirrored shapes", EvidenceKind::exact,
      "distinct roots of det(A F + B), L_i = (3i-1)/i");
  return with_evidence(result, Evidence::by_checked_theorem(
                                   "Energy factor", {"definite.energy_factor", "forces.simple_forces"},
                                   "mu_i = F_i; by Simple modes they are distinct"));
}

/// The printed numbers of the equations that a later one can follow from.
Judgement reference(const Printed& printed, const std::map<std::string, std::string>& claims,
                    const std::function<bool(const Printed&)>& follows, const std::string& truth,
                    const std::string& how) {
  const auto found = claims.find(printed.at(0));
  if (found == claims.end()) throw Error("claim", "(" + printed.at(0) + ")", "an equation near by");
  const bool right = follows(printed_in_paper(found->second));
  return {
      right ? Verdict::confirmed : Verdict::refuted, right ? "" : truth, {{EvidenceKind::symbolic, how}}, ""};
}

/// (37) is the energy of joint angles mu v_ij: only an equation that introduces mu can lead to it.
Judgement reference_of_37(const Printed& printed, int) {
  return reference(
      printed,
      {{"32", "eq-31-33"}, {"33", "eq-31-33"}, {"34", "eq-34"}, {"35", "eq-35-mode"}, {"36", "eq-36"}},
      [](const Printed& equation) {
        return std::any_of(equation.begin(), equation.end(),
                           [](const std::string& entry) { return entry.find("mu") != std::string::npos; });
      },
      "(37) follows from (35), q_j = mu v_ij; (32) has neither mu nor v_ij",
      "q = mu v of (35) in sum k q^2 / 2 and (25) gives (37): eq-37; which of the equations before it have "
      "mu");
}

/// Energies at one deflection: an equation between E_i and delta_x without the scale mu.
Judgement reference_of_39(const Printed& printed, int) {
  Judgement result = reference(
      printed, {{"37", "eq-37"}, {"38", "eq-38"}, {"39", "eq-39"}},
      [](const Printed& equation) {
        return std::any_of(equation.begin(), equation.end(),
                           [](const std::string& entry) { return entry.find("dx") != std::string::npos; });
      },
      "the relation of E_i to delta_x is (38)",
      "(38) has E_i by delta_x; (37) has both by mu, from which (38) follows");
  // (37) leads there too, by eliminating mu
  if (result.verdict == Verdict::refuted && printed.at(0) == "37") result.verdict = Verdict::convention;
  return result;
}

}  // namespace

Checks claims::energy() {
  return {
      {"energy-count", energy_count},    {"first-mode-observed", first_mode}, {"factor-order", factor_order},
      {"reference-37", reference_of_37}, {"reference-39", reference_of_39},
  };
}

}  // namespace plumbline::verify
