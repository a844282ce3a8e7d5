#pragma once
/// \file
/// Prints that are true though they are not the paper's: the corrections of what it has wrong, and other ways
/// to say what it has right.

#include <map>
#include <string>
#include <vector>

#include "verify/judging/claim.hpp"

/// The true statement for every claim that the paper has wrong: the same check must confirm it.
inline std::multimap<std::string, plumbline::verify::Printed> corrected_claims() {
  return {
      {"outline", {"2", "3", "4", "6"}},
      {"energy-extrema", {"minimum", "stable"}},
      {"energy-extrema", {"maximum", "unstable"}},
      {"energy-10", {"E-Fx*Delta"}},
      {"reference-37", {"35"}},
      {"reference-39", {"38"}},
      {"extended-linear", {"bilinear"}},
      {"fig-9-softening", {"does not"}},
      {"z-to-u-proved", {"continuous", "reduces"}},
      {"force-shift", {"stretch"}},
      {"sudden-change", {"continuous"}},
      {"eq-7-names", {"S0", "C0", "S01", "C01", "S012", "C012"}},
      {"equilibrium-is-minimum", {"stationary point"}},
      {"arg-min", {"local minimum"}},
      {"arg-max", {"local maximum"}},
      {"fig-5b-only", {"U⁺", "one of two stable"}},
      {"bent-continuous", {"can jump"}},
      {"fig-8-shapes", {"Z⁻", "Z⁻"}},
      {"fig-9-name", {"Z⁻, then U⁺"}},
      {"fig-9-signs", {"++, then +-"}},
      {"eq-6-sizes", {"[Fx Fy]^T", "[0 k*q1 k*q2]^T"}},
      {"phi-one-angle", {"2"}},
      {"deflection-angles", {"alpha1+q1", "alpha2+q2", "joint"}},
      {"fig-5b-name", {"U⁺ for epsilon < 0, U⁻ for epsilon > 0"}},
      {"four-unknowns", {"F", "phi", "q1", "q2"}},
      {"fig-7-feasible", {"U⁺", "U⁻"}},
      {"fig-7-rest", {"U⁺"}},
      {"straight-jump", {"continuous"}},
      {"fig-14-sign", {"delta_x"}},
      {"eq-8-torques", {"q-q0"}},
      {"given-force-equations", {"2"}},
      {"fig-16-sheets", {"3 for q4 > 0, 3 for q4 < 0"}},
      {"fig-11-continuity", {"does not prove"}},
      {"fig-8-jump", {"continuous"}},
      {"fig-9-angle", {"negative"}},
      {"fig-9-local", {"equal"}},
      {"fig-13-count", {"2 minima, 1 saddle"}},
      {"straight-below-critical", {"below, near the straight shape"}},
      {"pseudoinverse", {"inv(J*J^T)*J"}},
      {"eq-17",
       {"sin(2*phi)-2*sin(phi)", "sin(2*phi)-sin(phi)", "-sin(phi)", "cos(2*phi)+2*cos(phi)",
        "cos(2*phi)+cos(phi)", "cos(phi)"}},
      {"eq-18",
       {"L*(sin(2*phi)-2*sin(phi))*Fx+L*(cos(2*phi)+2*cos(phi))*Fy",
        "L*(sin(2*phi)-sin(phi))*Fx+L*(cos(2*phi)+cos(phi))*Fy-k*3*phi",
        "-L*sin(phi)*Fx+L*cos(phi)*Fy+k*3*phi"}},
      {"z-no-exact-solution", {"solutions"}},
      {"linearised", {"2", "1"}},
      {"eigenvectors", {"n"}},
      {"zeros-are-straight", {"1"}},
      {"rank", {"n"}},
      {"eq-36", {"1/max(lambda)"}},
      {"eq-24", {"k1*q1", "k2*q2", "k3*q3", "k4*q4"}},
      {"algorithm-1-general", {"two links or more, at most one passive joint"}},
      {"algorithm-1-step-3", {"n+1"}},
      {"algorithm-1-step-4", {"1/max(lambda)"}},
      {"three-nonzero-roots", {"3", "-1.0822", "-0.4337", "-0.2841"}},
      {"table-3-forces",
       {"U", "0.9240", "Z", "3.5203", "ZU", "2.3057", "U", "0.9240", "Z", "3.5203", "ZU", "2.3057"}},
      {"fig-16-excluded", {"q3", "q4"}},
      {"fig-16-maxima", {"maximum", "unstable"}},
      {"fig-16-minima", {"minimum", "stable"}},
      {"prismatic-joints", {"changed"}},
      {"gravity-axial-stiffness", {"changed"}},
  };
}

/// Altered prints that are as true as the paper's own, or as little wrong.
struct Survivor {
  std::string id;
  std::string what;   ///< the kind of alteration
  std::string entry;  ///< one of the altered print; empty for any
  std::string reason;
};

inline std::vector<Survivor> survivors() {
  const std::string rounding = "within the rounding of the four angles",
                    unit = "within a unit of the last place";
  std::vector<Survivor> list{
      {"two-link-equilibrium", "order", "", "the two sides of an equation"},
      {"eq-7-names", "order", "", "definitions in another order"},
      {"fig-5b-name", "sign", "U⁻", "the sign of epsilon is not printed"},
      {"four-unknowns", "order", "", "unknowns in another order"},
      {"fig-7-shapes", "order", "", "shapes in another order"},
      {"eq-29", "order", "", "terms of a sum in another order"},
      {"fig-16-maxima", "word", "minimum", "minima are stable"},
      {"fig-16-minima", "word", "maximum", "maxima are unstable"},
  };
  for (const char* angle : {"-0.3178", "0.0559", "0.0557", "0.3805", "0.3803", "0.3525", "0.3523"})
    list.push_back({"table-1-u", "digit", angle, rounding});
  for (const char* angle : {"-0.2416", "0.6822", "0.6820", "-0.7959", "-0.7957", "0.5171"})
    list.push_back({"table-1-z", "digit", angle, rounding});
  for (const char* angle : {"-0.3178", "0.0557", "0.3805", "0.3523"})
    list.push_back({"table-1-u-shape", "digit", angle, unit});
  for (const char* angle : {"-0.2416", "0.6820", "-0.7957", "0.5171"})
    list.push_back({"table-1-z-shape", "digit", angle, unit});
  return list;
}
