#include "verify/claims/claims.hpp"

#include <map>
#include <plumbline/base/error.hpp>

#include "verify/claims/lines.hpp"
#include "verify/generic/generic.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

Checks (*const lists[])() = {
    claims::outline,        claims::two_link,         claims::three_link_model,
    claims::symbols,        claims::first_figures,    claims::loaded_three_link,
    claims::zigzag,         claims::loaded_four_link, claims::quasi_buckling,
    claims::three_link,     claims::linearised_model, claims::linear_equations,
    claims::sign_of_force,  claims::eigenvalues,      claims::straight_stability,
    claims::energy,         claims::four_link,        claims::energy_surface,
    claims::spatial_chains, claims::discussion,       claims::outside_the_model,
};

std::map<std::string, Check> all_checks() {
  std::map<std::string, Check> all;
  for (const auto list : lists) {
    for (auto& [id, check] : list()) {
      if (!all.emplace(id, std::move(check)).second) throw Error("claim " + id, "two checks", "one");
    }
  }
  return all;
}

CodeLine line_of(const std::string& function) {
  for (const CheckLine& one : check_lines) {
    if (function == one.claim) return {one.file, one.line};
  }
  throw Error("claim " + function, "no line of code", "the one that verify/claims/lines.py finds");
}

/// Gives each claim the check that it states, or else the function that has its id, which is taken out of
/// `functions`.
void give_checks(std::vector<Claim>& claims, std::map<std::string, Check>& functions) {
  for (Claim& claim : claims) {
    if (!claim.stated.kind.empty()) {
      claim.check = generic_check(claim.stated);
      claim.source = line_of("generic " + claim.stated.kind);
      continue;
    }
    const auto check = functions.extract(claim.id);
    if (check.empty())
      throw Error("claim " + claim.id, "no check", "one that it states (verify/papers/README.md)");
    claim.check = check.mapped();
    claim.source = line_of(claim.id);
  }
}

}  // namespace

Paper with_checks(Paper paper) {
  constexpr const char* ours = "10.1016/j.mechmachtheory.2022.104783";
  auto functions = paper.doi == ours ? all_checks() : std::map<std::string, Check>{};
  give_checks(paper.claims, functions);
  give_checks(paper.facts, functions);
  if (!functions.empty()) throw Error("check of " + functions.begin()->first, "no such claim", "one");
  return paper;
}

const Paper& checked_paper() {
  static const Paper instance = with_checks(paper());
  return instance;
}

std::vector<Claim> all_claims() {
  return checked_paper().claims;
}

}  // namespace plumbline::verify
