#include "proofs/rod/critical_rod.hpp"

#include "proofs/rod/rod_buckling.hpp"

namespace plumbline::proofs {

RodLoss critical_rod(const Rod& rod, int digits) {
  const DividedRod parts = divided(rod);
  if (!parts.follower()) return {Motion::divergence, rod_buckling(parts, digits), 0};
  return rod_flutter(parts, digits);
}

}  // namespace plumbline::proofs
