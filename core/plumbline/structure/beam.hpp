#pragma once
/// \file
/// A rod as a chain: Hencky's bars, each as long as the others, whose joints bend like the rod between the
/// middles of two bars.
///
/// A joint stands for the piece of rod around it, half a bar to either side: k = E I / l, l = length / n. At
/// a clamped end there is half a bar alone, whose stiffness is 2 E I / l: a clamp that held the first bar
/// itself would leave the rod half a bar too stiff, one with k half a bar too soft. With these ends the
/// discrete problem is the rod's with second differences for second derivatives, so that under an end force P
///
///     P_chain = 4 E I / l^2 sin^2(l / 2 sqrt(P_rod / E I)) = P_rod (1 - P_rod l^2 / (12 E I) + …) ,
///
/// exactly, whichever of Euler's four ends it has but for fixed and pinned, whose line does not run along the
/// bars' ends.

#include <plumbline/structure/structure.hpp>

namespace plumbline {

/// Ends of a rod.
enum class RodEnd { free, pinned, clamped };

/// A straight rod of bending stiffness E I in so many bars, without loads.
/// \throws Error for no bars, and a base that is free
template <Number Real>
Structure<Real> rod(const Real& EI, const Real& length, std::size_t bars, RodEnd base, RodEnd end_point) {
  if (bars == 0) throw Error("beam", "no links", "one or more");
  if (base == RodEnd::free) throw Error("beam", "a free base", "one that is pinned or clamped");
  const Real l = length / Real(static_cast<int>(bars)), k = EI / l, half = Real(2) * k;
  std::vector<Real> stiffness(bars, k);
  stiffness[0] = base == RodEnd::clamped ? half : Real(0);
  Structure<Real> structure(Chain<Real>(std::vector<Real>(bars, l), std::move(stiffness)));
  structure.end_point = end_point == RodEnd::free ? Support<Real>() : guided<Real>();
  if (end_point == RodEnd::clamped) structure.end_point.turn = Restraint<Real>::sprung(half);
  return structure;
}

}  // namespace plumbline
