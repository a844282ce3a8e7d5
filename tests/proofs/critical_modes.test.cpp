#include "proofs/critical_modes.hpp"

#include <plumbline/base/parallel.hpp>

#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("chains side by side, each to digits of its own, have the digits that they have alone") {
  const Chain<Rational> chain({1, 2, 3, Rational(7, 10)}, {3, 1, 4, Rational(15, 10)});
  const auto digits = [](std::size_t i) { return 50 + static_cast<int>(30 * (i % 4)); };
  std::vector<std::string> alone, together(40);
  for (std::size_t i = 0; i < 4; ++i) alone.push_back(modes_in_decimals(chain, 1, digits(i))[0].force);
  in_parallel(together.size(), 4,
              [&](std::size_t i) { together[i] = modes_in_decimals(chain, 1, digits(i))[0].force; });
  for (std::size_t i = 0; i < together.size(); ++i) CHECK(together[i] == alone[i % 4]);
}
