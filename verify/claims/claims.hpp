#pragma once
/// \file
/// The claims of the paper: what it says (verify/paper) with the checks of this folder, one list of checks a
/// file, its function named as the file.

#include <utility>

#include "verify/judging/claim.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

/// By the id of the claim that each judges.
using Checks = std::vector<std::pair<std::string, Check>>;

namespace claims {

Checks outline();             ///< what the paper says of its sections, equations and symbols
Checks two_link();            ///< section 2, (1) to (3) and what is said around them
Checks first_figures();       ///< section 2, Figures 2, 3, 5 and 6
Checks three_link_model();    ///< section 2, (4) to (10)
Checks symbols();             ///< section 2, the symbols of (4) to (9)
Checks loaded_three_link();   ///< section 3 and 3.1, Fig. 7
Checks zigzag();              ///< section 3.1, Figures 8 and 9
Checks loaded_four_link();    ///< section 3.2, Table 1, Figures 11 to 13
Checks quasi_buckling();      ///< section 3.2, Fig. 14 and the last paragraphs
Checks three_link();          ///< section 4.1, (13) to (20)
Checks linearised_model();    ///< section 4.2, (21), (23), (25) to (28)
Checks linear_equations();    ///< section 4.2, (22), (29) to (33)
Checks sign_of_force();       ///< sections 2 and 4, the signs of (6), (14), (18), (24), (36) and step 4
Checks eigenvalues();         ///< section 4.2, (34), (35) and Algorithm 1
Checks straight_stability();  ///< sections 3.1 and 4, up to which force the straight chain is stable
Checks energy();              ///< section 4.2, (37) to (39)
Checks four_link();           ///< section 4.2, (40), the polynomial, Tables 2 and 3
Checks energy_surface();      ///< section 4.2, Fig. 16
Checks spatial_chains();      ///< section 5, chains in space
Checks discussion();          ///< section 5, prismatic joints, gravity, parameters
Checks outside_the_model();   ///< section 5, couplings, end torque, new starts, tolerance

}  // namespace claims

/// The paper with a check for each claim and each fact: the one that it states, or else, in the paper that
/// the program was made for, told by its DOI, the function of this folder that has its id.
/// \throws Error where a claim has no check, or a function no claim
Paper with_checks(Paper paper);

/// The paper that the program was made for.
const Paper& checked_paper();

/// Its claims, in its order.
std::vector<Claim> all_claims();

}  // namespace plumbline::verify
