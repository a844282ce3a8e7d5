#include "verify/claims/claims.hpp"

#include <map>
#include <plumbline/base/error.hpp>

#include "verify/claims/lines.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

Checks (*const lists[])() = {
    claims::outline,        claims::two_link,          claims::three_link_model, claims::symbols,
    claims::first_figures,  claims::loaded_three_link, claims::zigzag,           claims::loaded_four_link,
    claims::quasi_buckling, claims::three_link,        claims::linearised_model, claims::linear_equations,
    claims::sign_of_force,  claims::eigenvalues,       claims::energy,           claims::four_link,
    claims::energy_surface, claims::spatial_chains,    claims::discussion,
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

CodeLine line_of(const std::string& id) {
  for (const CheckLine& one : check_lines) {
    if (id == one.claim) return {one.file, one.line};
  }
  throw Error("claim " + id, "no line of code", "the one that verify/claims/lines.py finds");
}

}  // namespace

std::vector<Claim> all_claims() {
  std::vector<Claim> claims = paper().claims;
  auto checks = all_checks();
  for (Claim& claim : claims) {
    const auto check = checks.extract(claim.id);
    if (check.empty()) throw Error("claim " + claim.id, "no check", "one");
    claim.check = check.mapped();
    claim.source = line_of(claim.id);
  }
  if (!checks.empty()) throw Error("check of " + checks.begin()->first, "no such claim", "one");
  return claims;
}

}  // namespace plumbline::verify
