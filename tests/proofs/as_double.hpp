#pragma once
/// \file
/// What is enclosed, in double precision.

#include <plumbline/base/interval.hpp>

inline double as_double(const plumbline::Interval& x) {
  return static_cast<double>(x.middle());
}
