#include "verify/claims/claims.hpp"

#include <algorithm>

#include "verify/judging/judge.hpp"

namespace plumbline::verify {

std::vector<Claim> all_claims() {
  std::vector<Claim> claims;
  for (const auto& section :
       {claims::two_link, claims::three_link_model, claims::symbols, claims::first_figures,
        claims::loaded_three_link, claims::zigzag, claims::loaded_four_link, claims::quasi_buckling,
        claims::three_link, claims::linearised_model, claims::eigenvalues, claims::energy, claims::four_link,
        claims::energy_surface, claims::discussion}) {
    const std::vector<Claim> part = section();
    claims.insert(claims.end(), part.begin(), part.end());
  }
  std::stable_sort(claims.begin(), claims.end(),
                   [](const Claim& a, const Claim& b) { return section_of(a) < section_of(b); });
  return claims;
}

}  // namespace plumbline::verify
