#include "app/critical_modes.hpp"

#include <plumbline/algorithm1.hpp>

#include "proofs/decimal.hpp"

namespace plumbline {
namespace {

std::string decimal(const Mpfr& x, int digits) {
  Rational exact;
  mpfr_get_q(exact.backend().data(), x.backend().data());
  return to_decimal(exact, digits);
}

}  // namespace

std::vector<CriticalMode> critical_modes(const Chain<Rational>& chain, int digits,
                                         std::optional<std::size_t> lowest) {
  Mpfr::default_precision(static_cast<unsigned>(2 * digits + 30));
  const auto rounded = from_rational<Mpfr>(chain);
  std::vector<CriticalMode> result;
  for (const Mode<Mpfr>& mode : algorithm1(rounded)) {
    if (lowest && result.size() == *lowest) break;
    CriticalMode shown{decimal(mode.force, digits),
                       decimal(energy_factor(rounded, mode.q), digits),
                       {},
                       0,
                       sign_pattern(mode.q)};
    for (const Mpfr& angle : mode.q) shown.q.push_back(static_cast<double>(angle));
    shown.fy = static_cast<double>(mode.fy);
    result.push_back(std::move(shown));
  }
  return result;
}

}  // namespace plumbline
