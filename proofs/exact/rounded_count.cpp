#include "proofs/exact/rounded_count.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/string_in_lanes.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// A little below F and a little above: twice as far as the run of n links in numbers of this unit roundoff
/// may miss, so that rounding the result does no harm.
template <Floating Real>
std::pair<Real, Real> around(const Rational& F, std::size_t n, const Real& unit) {
  const Real middle = from_rational<Real>(F), off = middle * unit * static_cast<double>(2 * (8 * n + 16));
  return {Real(middle - off), Real(middle + off)};
}

template <Floating Real>
Chain<Real> rounded(const std::vector<Integer>& length, const std::vector<Integer>& stiffness) {
  const auto all = [](const std::vector<Integer>& integers) {
    std::vector<Real> values;
    values.reserve(integers.size());
    for (const Integer& x : integers) {
      values.emplace_back(0);
      mpfr_set_z(values.back().backend().data(), x.backend().data(), MPFR_RNDN);
    }
    return values;
  };
  return Chain<Real>(all(length), all(stiffness));
}

/// Decimal digits that a fraction is written with.
int digits_of(const Rational& x) {
  const auto digits = [](const Integer& i) {
    return static_cast<int>(mpz_sizeinbase(i.backend().data(), 10));
  };
  return std::max(digits(mp::numerator(x)), digits(mp::denominator(x)));
}

}  // namespace

RoundedCount::Counts RoundedCount::below(const std::vector<Rational>& forces) const {
  Counts counts(forces.size());
  int most = 0;
  for (const Rational& F : forces) most = std::max(most, digits_of(F));
  constexpr int too_many_for_lanes = 40;  // some of them come with the units
  if (most <= too_many_for_lanes) in_lanes(forces, counts);
  // A decimal that is no critical force is mostly as far from the next one as its digits show.
  most += 8 + static_cast<int>(std::log10(length_.size()));
  for (const int digits : {most, 2 * most}) {
    if (digits <= wide_digits) {
      in_turn<Wide>(forces, counts);
    } else {
      const WorkingPrecision precision(digits);
      in_turn<Mpfr>(forces, counts);
    }
  }
  return counts;
}

void RoundedCount::in_lanes(const std::vector<Rational>& forces, Counts& counts) const {
  const auto chain = rounded<Wide>(length_, stiffness_);
  const detail::BeadString<Wide> string({chain, end_point_});
  std::vector<Wide> beside;
  for (const Rational& F : forces) {
    const auto [low, high] = around(F, length_.size(), Wide(double_word_unit));
    beside.push_back(low);
    beside.push_back(high);
  }
  const auto runs = run_in_lanes(StringInWords(string.pieces()[part_]), beside);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const RunInLanes &low = runs[2 * i], &high = runs[2 * i + 1];
    if (low.sound && high.sound && low.below == high.below) counts[i] = low.below;
  }
}

template <Floating Real>
void RoundedCount::in_turn(const std::vector<Rational>& forces, Counts& counts) const {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!counts[i] && forces[i] > 0) open.push_back(i);
  }
  if (open.empty()) return;
  const auto chain = rounded<Real>(length_, stiffness_);
  const detail::BeadString<Real> string({chain, end_point_});
  const auto piece = string.pieces()[part_];
  in_parallel(open.size(), available_threads(), [&](std::size_t o) {
    const std::size_t i = open[o];
    const auto [low, high] = around(forces[i], length_.size(), epsilon<Real>());
    const std::size_t below = count_below(piece, low);
    if (count_below(piece, high) == below) counts[i] = below;
  });
}

}  // namespace plumbline::proofs
