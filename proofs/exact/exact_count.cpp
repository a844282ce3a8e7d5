#include "proofs/exact/exact_count.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>

#include "proofs/exact/rounded_count.hpp"
#include "proofs/exact/string_in_lanes.hpp"

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

/// Whether rounded numbers are faster than integers, whose length grows along the chain: from so many joints
/// on, from fewer where many forces share what it takes to begin, or where each has many digits.
bool rounding_pays(std::size_t joints, const std::vector<Rational>& forces) {
  constexpr std::size_t long_part = 64, long_part_of_many = 16, many = 16, joints_times_digits = 4000;
  if (forces.empty()) return false;
  const std::size_t digits = mpz_sizeinbase(mpq_numref(forces.front().backend().data()), 10);
  return joints >= (forces.size() < many ? long_part : long_part_of_many) ||
         joints * digits >= joints_times_digits;
}

}  // namespace

std::vector<ChainPart> parts(const Chain<Rational>& chain) {
  const std::size_t last = mode_count(chain);
  for (std::size_t i = 1; i <= last; ++i) {
    if (chain.stiffness()[i] == 0 && i < last) return {{0, i}, {i, last}};
  }
  return {{0, last}};
}

ExactCount::ExactCount(const StraightChain<Rational>& straight)
    : end_point_(straight.end_point), parts_(plumbline::proofs::parts(straight.chain)) {
  const Rational per_length = clear_denominators(straight.chain.length(), length_);
  const Rational per_stiffness = clear_denominators(straight.chain.stiffness(), stiffness_);
  per_force_ = per_stiffness / per_length;
  if (end_point_ == EndPoint::free) {
    distance_.assign(length_.size(), Integer(1));
    return;
  }
  distance_.resize(length_.size());
  Integer sum(0);
  for (std::size_t i = length_.size(); i-- > 0;) distance_[i] = sum += length_[i];
}

std::size_t ExactCount::below(const Rational& F) const {
  return below(std::vector{F}).front();
}

std::size_t ExactCount::below(const Rational& F, const ChainPart& part) const {
  const auto at = std::find(parts_.begin(), parts_.end(), part) - parts_.begin();
  return below({F}, static_cast<std::size_t>(at)).front();
}

std::vector<std::size_t> ExactCount::below(const std::vector<Rational>& forces) const {
  std::vector<std::size_t> counts(forces.size());
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    const std::vector<std::size_t> of_part = below(forces, part);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += of_part[i];
  }
  return counts;
}

std::vector<std::size_t> ExactCount::below(const std::vector<Rational>& forces, std::size_t part) const {
  std::vector<Rational> scaled;
  for (const Rational& F : forces) scaled.push_back(F * per_force_);
  RoundedCount::Counts counts(forces.size());
  if (rounding_pays(parts_[part].last - parts_[part].first, scaled))
    counts = RoundedCount(length_, stiffness_, end_point_, part).below(scaled);
  std::vector<std::size_t> result(forces.size());
  in_parallel(forces.size(), threads_for(forces.size(), length_.size()), [&](std::size_t i) {
    result[i] = counts[i] ? *counts[i] : exactly_below(scaled[i], parts_[part]);
  });
  return result;
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
