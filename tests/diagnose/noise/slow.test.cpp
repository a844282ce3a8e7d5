#include "diagnose/noise/slow.hpp"

#include <doctest/doctest.h>

using namespace plumbline::diagnose;

TEST_CASE("slow components of a series are orthonormal, the constant one among them") {
  for (const std::size_t count : {1U, 4U, 14U, 60U}) {
    for (std::size_t j = 0; j < slow_components(count); ++j) {
      for (std::size_t k = 0; k < slow_components(count); ++k) {
        const double product = cosine_wave(count, j).dot(cosine_wave(count, k));
        CHECK(product == doctest::Approx(j == k ? 1 : 0).scale(1).epsilon(1e-12));
      }
    }
  }
  CHECK(slow_components(4) == 2);
  CHECK(slow_components(60) == 6);
}
