#include "verify/claims/claims.hpp"

#include <map>
#include <plumbline/base/error.hpp>
#include <tuple>

#include "verify/paper/paper.hpp"

namespace plumbline::verify {
namespace {

struct Source {
  Checks (*checks)();
  const char* file;
};

const Source sources[] = {
    {claims::two_link, "two_link"},
    {claims::three_link_model, "three_link_model"},
    {claims::symbols, "symbols"},
    {claims::first_figures, "first_figures"},
    {claims::loaded_three_link, "loaded_three_link"},
    {claims::zigzag, "zigzag"},
    {claims::loaded_four_link, "loaded_four_link"},
    {claims::quasi_buckling, "quasi_buckling"},
    {claims::three_link, "three_link"},
    {claims::linearised_model, "linearised_model"},
    {claims::linear_equations, "linear_equations"},
    {claims::sign_of_force, "sign_of_force"},
    {claims::eigenvalues, "eigenvalues"},
    {claims::energy, "energy"},
    {claims::four_link, "four_link"},
    {claims::energy_surface, "energy_surface"},
    {claims::spatial_chains, "spatial_chains"},
    {claims::discussion, "discussion"},
};

std::map<std::string, std::pair<Check, std::string>> all_checks() {
  std::map<std::string, std::pair<Check, std::string>> all;
  for (const Source& source : sources) {
    for (auto& [id, check] : source.checks()) {
      const std::string file = std::string("verify/claims/") + source.file + ".cpp";
      if (!all.emplace(id, std::pair{std::move(check), file}).second)
        throw Error("claim " + id, "two checks", "one");
    }
  }
  return all;
}

}  // namespace

std::vector<Claim> all_claims() {
  std::vector<Claim> claims = paper().claims;
  auto checks = all_checks();
  for (Claim& claim : claims) {
    const auto check = checks.extract(claim.id);
    if (check.empty()) throw Error("claim " + claim.id, "no check", "one");
    std::tie(claim.check, claim.source) = check.mapped();
  }
  if (!checks.empty()) throw Error("check of " + checks.begin()->first, "no such claim", "one");
  return claims;
}

}  // namespace plumbline::verify
