#pragma once
/// \file
/// The claims of the paper, in its order; one list per file section*.cpp.

#include "verify/claim.hpp"

namespace plumbline {

std::vector<Claim> two_link_claims();           ///< section 2, (1) to (3) and what is said around them
std::vector<Claim> first_figures_claims();      ///< section 2, Figures 2, 3, 5 and 6
std::vector<Claim> three_link_model_claims();   ///< section 2, (4) to (10)
std::vector<Claim> symbol_claims();             ///< section 2, the symbols of (4) to (9)
std::vector<Claim> loaded_three_link_claims();  ///< section 3 and 3.1, Fig. 7
std::vector<Claim> zigzag_claims();             ///< section 3.1, Figures 8 and 9
std::vector<Claim> loaded_four_link_claims();   ///< section 3.2, Table 1, Figures 11 to 13
std::vector<Claim> quasi_buckling_claims();     ///< section 3.2, Fig. 14 and the last paragraphs
std::vector<Claim> three_link_claims();         ///< section 4.1, (13) to (20)
std::vector<Claim> linearised_model_claims();   ///< section 4.2, (21) to (33)
std::vector<Claim> eigenvalue_claims();         ///< section 4.2, (34) to (36) and Algorithm 1
std::vector<Claim> energy_claims();             ///< section 4.2, (37) to (39)
std::vector<Claim> four_link_claims();          ///< section 4.2, (40), the polynomial, Tables 2 and 3
std::vector<Claim> energy_surface_claims();     ///< section 4.2, Fig. 16
std::vector<Claim> discussion_claims();         ///< section 5, what is said about straight chains

/// All of them.
std::vector<Claim> all_claims();

}  // namespace plumbline
