#include "proofs/exact/shape_enclosure.hpp"

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

MpfrInterval between(const Rational& low, const Rational& high) {
  MpfrInterval result;
  mpfi_interv_q(result.backend().data(), low.backend().data(), high.backend().data());
  return result;
}
MpfrInterval exact(const Rational& x) {
  return between(x, x);
}

Rational fraction(mpfr_srcptr x) {
  Rational result;
  mpfr_get_q(result.backend().data(), x);
  return result;
}
Rational lower(const MpfrInterval& x) {
  return fraction(&x.backend().data()->left);
}
Rational upper(const MpfrInterval& x) {
  return fraction(&x.backend().data()->right);
}
Rational size_of(const Rational& x) {
  return x < 0 ? Rational(-x) : x;
}

/// Joint angles of the mode, up to a factor, by the recursion of <plumbline/critical_force.hpp>:
/// q_i = z_i g_i / k_i, and at a passive joint that ends the part h returns to zero.
std::vector<MpfrInterval> angles(const StraightChain<Rational>& straight, const ChainPart& part,
                                 const MpfrInterval& F) {
  const Chain<Rational>& chain = straight.chain;
  const std::vector<Rational> z = straight.arms();
  const auto& k = chain.stiffness();
  std::vector<MpfrInterval> q(chain.size(), MpfrInterval(0));
  MpfrInterval h(1), g = exact(k[part.first] / (z[part.first] * z[part.first]));
  q[part.first] = exact(1 / z[part.first]);
  for (std::size_t i = part.first; i < part.last; ++i) {
    const MpfrInterval distance = exact(z[i + 1]);
    g -= F * h * exact(chain.length()[i] / (z[i] * z[i + 1]));
    q[i + 1] = k[i + 1] == 0 ? MpfrInterval(-h / distance) : MpfrInterval(g * exact(z[i + 1] / k[i + 1]));
    h += distance * q[i + 1];
  }
  return q;
}

/// A decimal of so many significant digits within one unit of the last of them from everything in x, with as
/// much as the width of x to spare; "0" when x lies that close to zero at that place behind the point.
std::optional<std::string> certified_decimal(const MpfrInterval& x, int digits) {
  const Rational low = lower(x), high = upper(x), width = high - low;
  const auto within = [&](const Rational& v, const Rational& unit) {
    return v - unit <= low - width && high + width <= v + unit;
  };
  const Rational last_place(1, mp::pow(Integer(10), static_cast<unsigned>(digits)));
  if (low <= 0 && high >= 0) return within(0, last_place) ? std::optional("0") : std::nullopt;
  const std::string text = to_decimal(Rational((low + high) / 2), digits);
  const Rational value = *parse_decimal(text);
  return within(value, unit_in_digit(value, digits)) ? std::optional(text) : std::nullopt;
}

}  // namespace

std::optional<ShapeEnclosure> enclose_shape(const StraightChain<Rational>& chain, const ChainPart& part,
                                            const Rational& low, const Rational& high, int digits) {
  const Rational spread = high / (high - low);
  const auto force_digits = static_cast<int>(Integer(spread).str().size());
  const WorkingPrecision precision(force_digits + 20);
  const std::vector<MpfrInterval> q = angles(chain, part, between(low, high));
  std::size_t largest = part.first;
  for (std::size_t i = part.first; i <= part.last; ++i) {
    if (size_of(lower(q[i])) > size_of(lower(q[largest]))) largest = i;
  }
  if (lower(q[largest]) <= 0 && upper(q[largest]) >= 0) return std::nullopt;

  ShapeEnclosure shape{part, digits, {}};
  for (std::size_t i = 0; i < q.size(); ++i) {
    const bool straight = i < part.first || i > part.last;
    const auto text = i == largest ? std::optional<std::string>("1")
                      : straight   ? std::optional<std::string>("0")
                                   : certified_decimal(MpfrInterval(q[i] / q[largest]), digits);
    if (!text) return std::nullopt;
    shape.q.push_back(*text);
  }
  return shape;
}

}  // namespace plumbline::proofs
