#include "verify/chains/straight_modes.hpp"

#include <map>
#include <plumbline/chain/mode.hpp>
#include <string>

#include "proofs/exact/certified_modes.hpp"
#include "proofs/exact/decimal.hpp"

namespace plumbline::verify {
namespace {

constexpr int certified_digits = 60;

/// Around a certified decimal.
Interval within_a_unit(const std::string& decimal, int digits) {
  const Rational x = proofs::parse_decimal(decimal).value(), unit = proofs::unit_in_digit(x, digits);
  return hull(Interval(x - unit), Interval(x + unit));
}

CertifiedMode certified_mode(const Chain<Interval>& chain, const proofs::ForceEnclosure& force,
                             const proofs::ShapeEnclosure& shape) {
  const Interval F = hull(Interval(force.low), Interval(force.high));
  std::vector<Interval> q;
  for (const std::string& angle : shape.q)
    q.push_back(angle == "0" ? Interval(0) : within_a_unit(angle, shape.digits));
  const Interval fy = lateral_force(chain, F, q);
  Interval squares = sqr(fy);
  for (const Interval& angle : q) squares += sqr(angle);
  const Interval norm = certainly_negative(q[0]) ? -sqrt(squares) : sqrt(squares);
  for (Interval& angle : q) angle /= norm;
  return {F, Interval(-1) / F, energy_factor(chain, q), fy / norm, q};
}

}  // namespace

const std::vector<CertifiedMode>& certified_modes(const Chain<Rational>& chain) {
  static std::map<std::string, std::vector<CertifiedMode>> known;
  std::string key;
  for (const auto& numbers : {chain.length(), chain.stiffness()})
    for (const Rational& number : numbers) key += number.str() + " ";
  std::vector<CertifiedMode>& found = known[key];
  if (!found.empty()) return found;
  const std::size_t count = chain.size() - 1;
  const proofs::CertifiedModes certified = proofs::certify(chain, count, count, certified_digits);
  const Chain<Interval> enclosed = from_rational<Interval>(chain);
  for (std::size_t m = 0; m < certified.shapes.size(); ++m)
    found.push_back(certified_mode(enclosed, certified.forces[m], certified.shapes[m]));
  return found;
}

}  // namespace plumbline::verify
