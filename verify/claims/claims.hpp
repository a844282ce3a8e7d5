#pragma once
/// \file
/// The claims of the paper, in its order; one list a file of this folder, its function named as the file.

#include "verify/judging/claim.hpp"

namespace plumbline::verify {
namespace claims {

std::vector<Claim> two_link();           ///< section 2, (1) to (3) and what is said around them
std::vector<Claim> first_figures();      ///< section 2, Figures 2, 3, 5 and 6
std::vector<Claim> three_link_model();   ///< section 2, (4) to (10)
std::vector<Claim> symbols();            ///< section 2, the symbols of (4) to (9)
std::vector<Claim> loaded_three_link();  ///< section 3 and 3.1, Fig. 7
std::vector<Claim> zigzag();             ///< section 3.1, Figures 8 and 9
std::vector<Claim> loaded_four_link();   ///< section 3.2, Table 1, Figures 11 to 13
std::vector<Claim> quasi_buckling();     ///< section 3.2, Fig. 14 and the last paragraphs
std::vector<Claim> three_link();         ///< section 4.1, (13) to (20)
std::vector<Claim> linearised_model();   ///< section 4.2, (21) to (33)
std::vector<Claim> eigenvalues();        ///< section 4.2, (34) to (36) and Algorithm 1
std::vector<Claim> energy();             ///< section 4.2, (37) to (39)
std::vector<Claim> four_link();          ///< section 4.2, (40), the polynomial, Tables 2 and 3
std::vector<Claim> energy_surface();     ///< section 4.2, Fig. 16
std::vector<Claim> discussion();         ///< section 5, what is said about straight chains

}  // namespace claims

/// All of them.
std::vector<Claim> all_claims();

}  // namespace plumbline::verify
