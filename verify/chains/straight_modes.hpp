#pragma once
/// \file
/// The modes of a straight chain, every number certified.

#include <plumbline/base/interval.hpp>
#include <plumbline/chain/chain.hpp>
#include <vector>

namespace plumbline::verify {

/// (q, F_y) has norm 1, and q_1 > 0 where it is not zero.
struct CertifiedMode {
  Interval force, lambda, factor, fy;
  std::vector<Interval> q;
};

/// All modes, ascending in force, each number to about sixty digits. Computed once.
/// \throws Error for n = 1 or a mechanism
const std::vector<CertifiedMode>& certified_modes(const Chain<Rational>& chain);

}  // namespace plumbline::verify
