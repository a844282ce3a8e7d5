#include "proofs/exact/working_precision.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/parallel.hpp>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a precision that one thread has set stays until it is done, whatever others set") {
  std::atomic<int> disturbed = 0;
  in_parallel(2000, 4, [&](std::size_t i) {
    const int digits = 20 + static_cast<int>(i % 50);
    const WorkingPrecision outer(digits + 1);
    {
      const WorkingPrecision inner(digits);
      std::this_thread::yield();
      if (Mpfr::default_precision() != static_cast<unsigned>(digits)) ++disturbed;
    }
    if (Mpfr::default_precision() != static_cast<unsigned>(digits + 1)) ++disturbed;
  });
  CHECK(disturbed == 0);
}
