#include "proofs/rod/elastica.hpp"

namespace plumbline::proofs {

/// K = pi / (2 M), M the limit of a and g; E / K = 1 - sum over the steps of 2^(i-1) c_i^2, c_0 = k. After a
/// step, M lies between g and a, and each later c^2 is below (a - g)^2 / 4 of the step before.
BentCantilever bent_cantilever(const Interval& tip) {
  const Interval half = tip / Interval(2), k = sin(half);
  Interval a(1), g = cos(half), weight = Interval(Rational(1, 2)), sum = weight * sqr(k);
  constexpr int steps = 9;  // the difference of 1 and g is squared by each: below 1e-64 from 0.999 on
  for (int step = 0; step < steps; ++step) {
    const Interval mean = (a + g) / Interval(2), difference = (a - g) / Interval(2);
    g = sqrt(a * g);
    a = mean;
    weight = weight * Interval(2);
    sum += weight * sqr(difference);
  }
  // what is left of the sum: less than twice the next term
  const Interval last = weight * Interval(4) * sqr(a - g);
  const Interval share = Interval(1) - hull(sum, sum + last), K = Interval::pi() / (Interval(2) * hull(a, g));
  return {sqr(K), Interval(2) * share - Interval(1), Interval(2) * k / K};
}

}  // namespace plumbline::proofs
