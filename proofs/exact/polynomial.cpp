#include "proofs/exact/polynomial.hpp"

#include <algorithm>
#include <cstdint>
#include <plumbline/base/error.hpp>

namespace plumbline::proofs {
namespace {

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<long>(i));
  return result;
}

/// p times a positive number that makes its coefficients integers without a common factor: keeps remainder
/// sequences short.
Polynomial primitive(Polynomial p) {
  Integer denominators = 1;
  for (const Rational& c : p) denominators = mp::lcm(denominators, mp::denominator(c));
  Integer content = 0;
  for (const Rational& c : p) content = mp::gcd(content, mp::numerator(Rational(c * denominators)));
  for (Rational& c : p) c = c * denominators / content;
  return p;
}

Polynomial remainder(Polynomial p, const Polynomial& divisor) {
  while (p.size() >= divisor.size()) {
    const Rational factor = p.back() / divisor.back();
    const std::size_t shift = p.size() - divisor.size();
    for (std::size_t i = 0; i < divisor.size(); ++i) p[i + shift] -= factor * divisor[i];
    p = trimmed(std::move(p));
  }
  return p;
}

/// Sturm's sequence p, p', … each term the negated remainder of the two before it, up to positive factors.
std::vector<Polynomial> sturm_sequence(const Polynomial& p) {
  std::vector<Polynomial> sequence{primitive(p)};
  Polynomial next = derivative(p);
  while (!next.empty()) {
    sequence.push_back(primitive(next));
    next = remainder(sequence[sequence.size() - 2], sequence.back());
    for (Rational& c : next) c = -c;
  }
  return sequence;
}

/// Whether p, of whole coefficients, and its derivative have no common factor modulo a prime that does not
/// divide p's leading coefficient: then they have none, and no root of p is multiple.
bool apart_modulo(const Polynomial& p) {
  constexpr std::int64_t prime = 2147483647;
  const auto inverse = [](std::int64_t a) {  // a^(prime - 2)
    std::int64_t result = 1;
    for (std::int64_t e = prime - 2; e > 0; e /= 2, a = a * a % prime)
      if (e % 2 == 1) result = result * a % prime;
    return result;
  };
  const auto trim = [](std::vector<std::int64_t>& q) {
    while (!q.empty() && q.back() == 0) q.pop_back();
  };
  std::vector<std::int64_t> f, g;
  for (const Rational& c : p)
    f.push_back(Integer((mp::numerator(c) % prime + prime) % prime).convert_to<std::int64_t>());
  if (f.back() == 0) return false;
  for (std::size_t i = 1; i < f.size(); ++i)
    g.push_back(f[i] * static_cast<std::int64_t>(i % static_cast<std::size_t>(prime)) % prime);
  trim(g);
  while (!g.empty()) {
    const std::int64_t per_leading = inverse(g.back());
    while (f.size() >= g.size()) {
      const std::int64_t share = f.back() * per_leading % prime;
      const std::size_t by = f.size() - g.size();
      for (std::size_t i = 0; i < g.size(); ++i)
        f[i + by] = (f[i + by] + prime - share * g[i] % prime) % prime;
      trim(f);
      if (f.empty()) break;
    }
    std::swap(f, g);
  }
  return f.size() == 1;
}

std::size_t sign_changes(const std::vector<int>& signs) {
  std::size_t changes = 0;
  int last = 0;
  for (const int sign : signs) {
    changes += sign * last < 0 ? 1 : 0;
    last = sign != 0 ? sign : last;
  }
  return changes;
}

}  // namespace

Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

Rational evaluate(const Polynomial& p, const Rational& x) {
  Rational sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
  return sum;
}

Polynomial interpolate(const std::vector<Rational>& values) {
  std::vector<Rational> difference = values;  // becomes Newton's divided differences
  const auto size = static_cast<long>(values.size());
  for (long order = 1; order < size; ++order) {
    for (long i = size; i-- > order;) {
      auto& at = difference[static_cast<std::size_t>(i)];
      at = (at - difference[static_cast<std::size_t>(i) - 1]) / order;
    }
  }
  Polynomial p;
  for (long i = size; i-- > 0;) {  // p becomes p (x - i) + difference[i]
    p.insert(p.begin(), Rational(0));
    for (std::size_t j = 0; j + 1 < p.size(); ++j) p[j] -= p[j + 1] * i;
    p[0] += difference[static_cast<std::size_t>(i)];
  }
  return trimmed(std::move(p));
}

std::size_t multiplicity_of_zero(const Polynomial& p) {
  const auto lowest = std::find_if(p.begin(), p.end(), [](const Rational& c) { return c != 0; });
  if (lowest == p.end()) throw Error("polynomial", "zero", "a polynomial that is not identically zero");
  return static_cast<std::size_t>(lowest - p.begin());
}

std::size_t distinct_negative_roots(const Polynomial& p) {
  const auto zeros = static_cast<std::ptrdiff_t>(multiplicity_of_zero(p));
  std::vector<int> far_left, at_zero;
  for (const Polynomial& term : sturm_sequence(Polynomial(p.begin() + zeros, p.end()))) {
    far_left.push_back(term.size() % 2 == 1 ? term.back().sign() : -term.back().sign());
    at_zero.push_back(term.front().sign());
  }
  return sign_changes(far_left) - sign_changes(at_zero);
}

std::size_t distinct_positive_roots(const Polynomial& p) {
  Polynomial mirrored = p;
  for (std::size_t i = 1; i < p.size(); i += 2) mirrored[i] = -mirrored[i];
  return distinct_negative_roots(mirrored);
}

SturmSequence::SturmSequence(const Polynomial& p) {
  if (p.empty()) throw Error("polynomial", "zero", "a polynomial that is not identically zero");
  terms_ = sturm_sequence(p);
}

std::size_t SturmSequence::distinct_roots(const Rational& low, const Rational& high) const {
  const auto changes = [&](const Rational& x) {
    std::vector<int> signs;
    for (const Polynomial& term : terms_) signs.push_back(evaluate(term, x).sign());
    return sign_changes(signs);
  };
  return changes(low) - changes(high);
}

Polynomial squarefree(const Polynomial& p) {
  if (p.empty()) throw Error("polynomial", "zero", "a polynomial that is not identically zero");
  if (apart_modulo(primitive(p))) return p;
  const Polynomial common = sturm_sequence(p).back();  // of p and its derivative
  Polynomial rest = p, quotient(p.size() - common.size() + 1, Rational(0));
  for (std::size_t shift = quotient.size(); shift-- > 0;) {
    quotient[shift] = rest[shift + common.size() - 1] / common.back();
    for (std::size_t i = 0; i < common.size(); ++i) rest[i + shift] -= quotient[shift] * common[i];
  }
  return quotient;
}

}  // namespace plumbline::proofs
