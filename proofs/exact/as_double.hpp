#pragma once
/// \file
/// What is enclosed, in double precision.

#include <plumbline/base/interval.hpp>

namespace plumbline::proofs {

inline double as_double(const Interval& x) {
  return static_cast<double>(x.middle());
}

}  // namespace plumbline::proofs
