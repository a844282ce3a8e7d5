#include "proofs/exact/tie.hpp"

#include "proofs/exact/exact_count.hpp"

namespace plumbline::proofs {
namespace {

/// p + c q, and p + c x q.
Polynomial plus(Polynomial p, const Rational& c, const Polynomial& q, std::size_t shift = 0) {
  p.resize(std::max(p.size(), q.size() + shift), Rational(0));
  for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] += c * q[i];
  return trimmed(std::move(p));
}

/// The recursion of <plumbline/critical_force.hpp> along a part, in polynomials in F: h at its end, or g
/// where the end is a passive joint. The critical forces of the part are the roots.
Polynomial force_polynomial(const StraightChain<Rational>& straight, const ChainPart& part) {
  const Chain<Rational>& chain = straight.chain;
  const std::vector<Rational> z = straight.arms();
  const auto& k = chain.stiffness();
  Polynomial h{1}, g = trimmed({k[part.first] / (z[part.first] * z[part.first])});
  for (std::size_t i = part.first; i < part.last; ++i) {
    g = plus(g, -chain.length()[i] / (z[i] * z[i + 1]), h, 1);
    if (k[i + 1] == 0) return g;
    h = plus(h, z[i + 1] * z[i + 1] / k[i + 1], g);
  }
  return h;
}

struct Division {
  Polynomial quotient, rest;
};
Division divide(Polynomial p, const Polynomial& by) {
  Polynomial quotient(p.size() < by.size() ? 0 : p.size() - by.size() + 1, Rational(0));
  while (p.size() >= by.size()) {
    const std::size_t shift = p.size() - by.size();
    quotient[shift] = p.back() / by.back();
    p = plus(p, -quotient[shift], by, shift);
  }
  return {quotient, p};
}

Polynomial greatest_common_factor(Polynomial p, Polynomial q) {
  while (!q.empty()) {
    p = divide(p, q).rest;
    std::swap(p, q);
    if (!q.empty()) q = plus({}, 1 / q.back(), q);  // or the fractions grow exponentially
  }
  return p;
}

}  // namespace

std::optional<Tie> find_tie(const StraightChain<Rational>& chain, const ForceEnclosure& bounds) {
  if (bounds.below_high != bounds.below_low + 2) return std::nullopt;
  std::vector<Polynomial> polynomials;
  for (const ChainPart& part : parts(chain.chain)) polynomials.push_back(force_polynomial(chain, part));
  const Polynomial factor = greatest_common_factor(polynomials.front(), polynomials.back());
  if (evaluate(factor, bounds.low) * evaluate(factor, bounds.high) >= 0) return std::nullopt;
  Tie tie{bounds.below_low + 1, bounds.low, bounds.high, factor, {}};
  for (const Polynomial& p : polynomials)
    tie.cofactors.push_back(plus({}, 1 / p.front(), divide(p, factor).quotient));
  return tie;
}

}  // namespace plumbline::proofs
