#pragma once
/// \file
/// Random rational chains for property tests; to be called inside a property.

#include <plumbline/chain/chain.hpp>

#include "tests/property.hpp"

/// A positive fraction, over eight decades.
inline plumbline::Rational random_fraction() {
  const auto numerator = *rc::gen::inRange(1L, 1000L);
  const auto exponent = *rc::gen::inRange(0U, 6U);
  return {numerator, plumbline::mp::pow(plumbline::Integer(10), exponent)};
}

inline std::vector<plumbline::Rational> random_fractions(std::size_t n) {
  std::vector<plumbline::Rational> fractions;
  while (fractions.size() < n) fractions.push_back(random_fraction());
  return fractions;
}

enum class Passive { none, base, last, interior, any_one };

/// A chain of `least` to `most` links. `interior` needs three links or more; `any_one` is every kind, none
/// too.
inline plumbline::Chain<plumbline::Rational> random_chain(Passive passive, std::size_t least,
                                                          std::size_t most) {
  const auto n = *rc::gen::inRange(least, most + 1);
  auto stiffness = random_fractions(n);
  std::size_t at = n;
  if (passive == Passive::base) at = 0;
  if (passive == Passive::last) at = n - 1;
  if (passive == Passive::interior) at = *rc::gen::inRange<std::size_t>(1, n - 1);
  if (passive == Passive::any_one) at = *rc::gen::inRange<std::size_t>(0, 2 * n);
  if (at < n) stiffness[at] = 0;
  return plumbline::Chain<plumbline::Rational>(random_fractions(n), std::move(stiffness));
}
