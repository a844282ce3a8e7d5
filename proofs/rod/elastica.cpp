#include "proofs/rod/elastica.hpp"

namespace plumbline::proofs {
namespace {

struct Symmetric {
  Interval F, D;  ///< R_F(x, y, 1) and R_D(x, y, 1)
};

/// By duplication (B. C. Carlson, Numer. Algorithms 10, 1995): each step keeps R_F, takes a term out of R_D,
/// and leaves a quarter of the arguments' differences; both are means of the arguments' powers.
Symmetric symmetric_integrals(Interval x, Interval y) {
  constexpr int steps = 100;  // 4^-100 = 6e-61
  Interval z(1), terms(0), share(1);
  const Interval four(4);
  for (int step = 0; step < steps; ++step) {
    const Interval a = sqrt(x), b = sqrt(y), c = sqrt(z), shift = a * b + b * c + c * a;
    terms += share / (c * (z + shift));
    share = share / four;
    x = (x + shift) / four;
    y = (y + shift) / four;
    z = (z + shift) / four;
  }
  const Interval mean = hull(hull(x, y), z), root = sqrt(mean);
  return {Interval(1) / root, Interval(3) * terms + share / (mean * root)};
}

struct Elliptic {
  Interval F, E;  ///< F(u, k) and E(u, k)
};

Elliptic elliptic_integrals(const Interval& sine_of_u, const Interval& k) {
  const Interval square = sqr(sine_of_u), bent = sqr(k) * square;
  const auto [F, D] = symmetric_integrals(Interval(1) - square, Interval(1) - bent);
  return {sine_of_u * F, sine_of_u * (F - bent * D / Interval(3))};
}

}  // namespace

BentCantilever bent_cantilever(const Interval& tip, const Interval& lean) {
  const Interval two(2), k = sin((tip + lean) / two), sine = sin(lean / two) / k;
  const Elliptic whole = elliptic_integrals(1, k), before = elliptic_integrals(sine, k);
  const Interval root = whole.F - before.F;  // of the force
  // along the force, turned round, and across it
  const Interval along = two * (whole.E - before.E) / root - Interval(1),
                 across = two * k * sqrt(Interval(1) - sqr(sine)) / root;
  const Interval c = cos(lean), s = sin(lean);
  return {sqr(root), tip, c * along + s * across, c * across - s * along};
}

BentCantilever cantilever_pushed_across(const Interval& force) {
  const Interval right = Interval::pi() / Interval(2);
  Interval low(0), high = right;
  for (int step = 0; step < 100;
       ++step) {  // the force grows with the tip's angle: the bracket ends below 1e-29
    const Interval middle = (low + high) / Interval(2), at = bent_cantilever(middle, right).force;
    if (certainly_less(at, force))
      low = middle;
    else if (certainly_less(force, at))
      high = middle;
    else
      break;
  }
  return bent_cantilever(hull(low, high), right);
}

}  // namespace plumbline::proofs
