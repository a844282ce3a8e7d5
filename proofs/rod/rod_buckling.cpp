#include "proofs/rod/rod_buckling.hpp"

#include "proofs/rod/inertia_of_rod.hpp"

namespace plumbline::proofs {
NarrowBracket rod_buckling(const DividedRod& rod, int digits) {
  const auto gives_way = [&](const Rational& factor) { return negative_directions(rod, factor, 0) > 0; };
  Rational most = 0;  // compression at factor 1
  for (const RodStretch& stretch : rod.stretches) {
    most = std::max(most, stretch.compression.multiplied);
    most =
        std::max(most, Rational(stretch.compression.multiplied + stretch.slope.multiplied * stretch.length));
  }
  if (most == 0) throw Error("rod", "no load that the factor multiplies and that compresses it", "one");
  if (gives_way(0))
    throw Error("rod", "fixed loads under which it gives way", "a rod that is stable at factor 0");
  RootBracket bracket{0, Rational(2) / most};
  while (!gives_way(bracket.high)) {
    bracket.low = bracket.high;
    bracket.high *= 2;
  }
  return narrowed(bracket, digits, gives_way);
}

}  // namespace plumbline::proofs
