#pragma once
/// \file
/// Prints that are true though they are not the paper's: the corrections of what it has wrong, and other ways
/// to say what it has right.

#include <map>
#include <string>
#include <vector>

#include "verify/paper/paper.hpp"

/// The true statement for every claim that the paper has wrong, the corrections of its errata among them: the
/// same check must confirm it.
inline std::multimap<std::string, plumbline::verify::Printed> corrected_claims() {
  std::multimap<std::string, plumbline::verify::Printed> all{
      {"energy-extrema", {"minimum", "stable"}},
      {"energy-10", {"E-Fx*Delta"}},
      {"extended-linear", {"bilinear"}},
      {"force-shift", {"stretch"}},
      {"equilibrium-is-minimum", {"stationary point"}},
      {"arg-min", {"local minimum"}},
      {"arg-max", {"local maximum"}},
      {"bent-continuous", {"can jump"}},
      {"eq-6-sizes", {"[Fx Fy]^T", "[0 k*q1 k*q2]^T"}},
      {"phi-one-angle", {"2"}},
      {"symbol-s0", {"2"}},
      {"symbol-energy", {"2"}},
      {"symbol-deflection", {"2"}},
      {"deflection-angles", {"alpha1+q1", "alpha2+q2", "joint"}},
      {"four-unknowns", {"F", "phi", "q1", "q2"}},
      {"fig-7-rest", {"U⁺"}},
      {"fig-14-sign", {"delta_x"}},
      {"eq-8-torques", {"q-q0"}},
      {"fig-16-sheets", {"3 for q4 > 0, 3 for q4 < 0"}},
      {"fig-11-continuity", {"does not prove"}},
      {"straight-below-critical", {"below, near the straight shape"}},
      {"linearised", {"2", "1"}},
      {"zeros-are-straight", {"1"}},
      {"algorithm-1-general", {"two links or more, at most one passive joint"}},
      {"algorithm-1-step-3", {"n+1"}},
      {"three-nonzero-roots", {"3", "-1.0822", "-0.4337", "-0.2841"}},
      {"fig-16-maxima", {"unstable"}},
      {"fig-16-minima", {"stable"}},
      {"fig-9-critical", {"is still negative", "essentially reduces"}},
      {"fig-5b-only", {"U⁺", "one of two stable ones"}},
      {"gravity-axial-stiffness", {"changed"}},
  };
  for (const plumbline::verify::Erratum& erratum : plumbline::verify::paper().errata)
    for (const plumbline::verify::Correction& one : erratum.corrections) all.emplace(one.claim, one.print);
  return all;
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
      {"eq-7-names", "order", "", "definitions in another order"},
      {"fig-4-section", "digit", "2", "section 2 considers the mechanism too"},
      {"fig-5b-name", "word", "U⁻", "the sign of epsilon is not printed"},
      {"four-unknowns", "order", "", "unknowns in another order"},
      {"fig-7-shapes", "order", "", "shapes in another order"},
      {"fig-14-lateral", "order", "", "curves in another order"},
      {"eq-29", "order", "", "terms of a sum in another order"},
      {"table-3-signs", "order", "", "rows in another order"},
      {"table-3-stability", "order", "", "rows in another order"},
      {"fig-16-shapes", "order", "", "rows in another order"},
      {"fig-16-prefers", "order", "", "rows in another order"},
  };
  for (const char* angle : {"-0.3178", "0.0559", "0.0557", "0.3805", "0.3803", "0.3525", "0.3523"})
    list.push_back({"table-1-u", "digit", angle, rounding});
  for (const char* angle : {"-0.2416", "0.6822", "0.6820", "-0.7959", "-0.7957", "0.5171"})
    list.push_back({"table-1-z", "digit", angle, rounding});
  for (const char* angle : {"-0.3178", "0.0557", "0.3805", "0.3523"})
    list.push_back({"table-1-u-shape", "digit", angle, unit});
  for (const char* angle : {"-0.2416", "0.6820", "-0.7957", "0.5171"})
    list.push_back({"table-1-z-shape", "digit", angle, unit});
  for (const char* equation : {"eq-14", "eq-30"})
    list.push_back({equation, "sign", "", "an equation times -1"});
  return list;
}
