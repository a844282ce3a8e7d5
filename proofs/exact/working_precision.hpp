#pragma once
/// \file
/// The precision of the number types that choose it at run time, for a while.

#include <boost/multiprecision/mpfi.hpp>
#include <mutex>
#include <plumbline/base/number.hpp>

namespace plumbline::proofs {

/// Intervals at run-time precision; Interval of the core has the 64 digits that 50 certified ones take.
using MpfrInterval = mp::number<mp::mpfi_float_backend<0>, mp::et_off>;

/// As many digits as three words of 64 bits hold, kept in place: what fifty certified ones take, mostly.
constexpr int wide_digits = 57;
using Wide = mp::number<mp::mpfr_float_backend<wide_digits, mp::allocate_stack>, mp::et_off>;

/// Mpfr and MpfrInterval have so many decimal digits while this lives. The precision is one for all threads,
/// so that another thread that sets one waits until then; those that share the work use it as it is.
class WorkingPrecision {
 public:
  explicit WorkingPrecision(int digits) : alone_(in_use), before_(Mpfr::default_precision()) {
    set(static_cast<unsigned>(digits));
  }
  ~WorkingPrecision() { set(before_); }
  WorkingPrecision(const WorkingPrecision&) = delete;
  WorkingPrecision& operator=(const WorkingPrecision&) = delete;

 private:
  static void set(unsigned digits) {
    Mpfr::default_precision(digits);
    MpfrInterval::default_precision(digits);
  }
  static inline std::recursive_mutex in_use;  // recursive: one may be set inside another
  std::scoped_lock<std::recursive_mutex> alone_;
  unsigned before_;
};

}  // namespace plumbline::proofs
