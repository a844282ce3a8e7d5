#include "proofs/exact_count.hpp"

#include "proofs/working_precision.hpp"

namespace plumbline::proofs {
namespace {

mpz_ptr raw(Integer& x) {
  return x.backend().data();
}
mpz_srcptr raw(const Integer& x) {
  return x.backend().data();
}

/// Multiplies all values by the same positive number, so that they become integers without a common factor;
/// returns that number.
Rational clear_denominators(const std::vector<Rational>& values, std::vector<Integer>& cleared) {
  Integer multiple(1), divisor(0);
  for (const Rational& x : values) mpz_lcm(raw(multiple), raw(multiple), mpq_denref(x.backend().data()));
  for (const Rational& x : values) {
    Integer& integer = cleared.emplace_back();
    mpz_divexact(raw(integer), raw(multiple), mpq_denref(x.backend().data()));
    mpz_mul(raw(integer), raw(integer), mpq_numref(x.backend().data()));
    mpz_gcd(raw(divisor), raw(divisor), raw(integer));
  }
  for (Integer& integer : cleared) mpz_divexact(raw(integer), raw(integer), raw(divisor));
  return {multiple, divisor};
}

MpfrInterval interval(const Rational& x) {
  MpfrInterval result;
  mpfi_set_q(result.backend().data(), x.backend().data());
  return result;
}

/// From so many joints on intervals are faster than integers, whose length grows along the chain.
constexpr std::size_t long_part = 100;

}  // namespace

std::vector<ChainPart> parts(const Chain<Rational>& chain) {
  const std::size_t last = mode_count(chain);
  for (std::size_t i = 1; i <= last; ++i) {
    if (chain.stiffness()[i] == 0 && i < last) return {{0, i}, {i, last}};
  }
  return {{0, last}};
}

ExactCount::ExactCount(const Chain<Rational>& chain) : parts_(plumbline::proofs::parts(chain)) {
  const Rational per_length = clear_denominators(chain.length(), length_);
  per_force_ = clear_denominators(chain.stiffness(), stiffness_) / per_length;
  distance_.assign(length_.size(), Integer(0));
  Integer sum(0);
  for (std::size_t i = length_.size(); i-- > 0;) distance_[i] = sum += length_[i];
}

std::size_t ExactCount::below(const Rational& F) const {
  std::size_t count = 0;
  for (const ChainPart& part : parts_) count += below(F, part);
  return count;
}

std::size_t ExactCount::below(const Rational& F, const ChainPart& part) const {
  const Rational scaled = F * per_force_;
  if (part.last - part.first >= long_part) {
    if (const auto certain = certainly_below(scaled, part)) return *certain;
  }
  return exactly_below(scaled, part);
}

std::optional<std::size_t> ExactCount::certainly_below(const Rational& scaled, const ChainPart& part) const {
  const auto digits = static_cast<int>(mp::numerator(scaled).str().size());
  const WorkingPrecision precision(digits + 30);
  const MpfrInterval F = interval(scaled);
  MpfrInterval h = interval(distance_[part.first]), M = interval(stiffness_[part.first]);
  std::size_t count = 0;
  bool positive = true;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const MpfrInterval z = interval(distance_[i + 1]), L = interval(length_[i]);
    M = (z * M - F * L * h) / interval(distance_[i]);
    h = stiffness_[i + 1] == 0 ? M : MpfrInterval(h + z * M / interval(stiffness_[i + 1]));
    if (mpfi_has_zero(h.backend().data()) != 0) return std::nullopt;
    if ((mpfi_is_strictly_pos(h.backend().data()) != 0) != positive) {
      ++count;
      positive = !positive;
    }
  }
  return count;
}

std::size_t ExactCount::exactly_below(const Rational& scaled, const ChainPart& part) const {
  const Integer P = mp::numerator(scaled), D = mp::denominator(scaled);
  Integer h = distance_[part.first], M = stiffness_[part.first], t, factor;
  std::size_t count = 0;
  bool positive = true;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const Integer &z = distance_[i + 1], &k = stiffness_[i + 1];
    mpz_mul(raw(factor), raw(D), raw(z));
    mpz_mul(raw(t), raw(factor), raw(M));
    mpz_mul(raw(factor), raw(P), raw(length_[i]));
    mpz_submul(raw(t), raw(factor), raw(h));
    if (k == 0) {  // the part ends here: a passive joint transmits no moment
      h = t;
    } else {
      mpz_mul(raw(factor), raw(D), raw(distance_[i]));
      mpz_mul(raw(factor), raw(factor), raw(k));
      mpz_mul(raw(h), raw(h), raw(factor));
      mpz_addmul(raw(h), raw(z), raw(t));
      mpz_mul(raw(M), raw(k), raw(t));
    }
    if (h != 0 && (h > 0) != positive) {
      ++count;
      positive = !positive;
    }
  }
  return count;
}

}  // namespace plumbline::proofs
