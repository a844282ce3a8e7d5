#include "verify/sampled/chain_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/exact_chain.hpp"
#include "proofs/exact/exact_matrix.hpp"
#include "proofs/exact/exactly.hpp"
#include "verify/sampled/algorithm1_instances.hpp"

namespace plumbline::verify {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The margin of what either holds or not.
Margin holds(bool it) {
  return it ? 0 : infinity;
}

/// Whether `relation` holds between the exact counts below F of the sample and of each other chain, left and
/// right of every critical force of the sample.
template <class Relation>
Margin counts_compare(const Sample& s, const std::vector<Chain<Rational>>& others, Relation relation) {
  for (const std::vector<Rational>* forces : {&s.below, &s.above}) {
    for (const Rational& force : *forces) {
      const std::size_t count = count_below(s.exact, force);
      const auto related = [&](const Chain<Rational>& other) {
        return relation(count, count_below(other, force));
      };
      if (!std::all_of(others.begin(), others.end(), related)) return infinity;
    }
  }
  return 0;
}

/// The relation of two sets of forces of which the other is the higher one, by at most one place.
bool one_or_none_passed(std::size_t count, std::size_t other) {
  return other <= count && count <= other + 1;
}

/// det A = 0 is a single rank lost, but the eigenvalue zero counts twice: a Jordan block of size two.
Margin two_zero_eigenvalues(const Sample& s) {
  const Matrix<Rational> C = algorithm1_matrix(s.exact);
  const Matrix<Rational> square = C * C;
  const std::size_t n = s.exact.size();
  return holds(proofs::rank(C) == n && proofs::rank(square) == n - 1 &&
               proofs::rank(Matrix<Rational>(square * C)) == n - 1);
}

/// A force is simple unless a passive joint inside the chain lets both sides of it buckle alone.
Margin exact_counts(const Sample& s) {
  const auto& k = s.exact.stiffness();
  const bool simple = std::find(k.begin() + 1, k.end(), Rational(0)) == k.end();
  bool right = s.modes.size() == s.exact.size() - 1;
  for (std::size_t i = 0; i < s.modes.size(); ++i) {
    const std::size_t below = count_below(s.exact, s.below[i]), above = count_below(s.exact, s.above[i]);
    right = right && s.below[i] > 0 && below <= i && above > i && (!simple || above == below + 1);
  }
  return holds(right);
}

/// A chain counts only when all its forces are resolved in double: one that is not may spoil all the others.
Margin double_precision(const Sample& s) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double worst = 0;
  for (std::size_t i = 0; i < s.modes.size(); ++i) {
    if (!s.resolved(i, epsilon)) return std::nullopt;
    worst = std::max(worst, s.error_in_double(i) / (epsilon * s.condition[i]));
  }
  return worst;
}

/// |mu - F| <= 3 radius: with the residual R of (32), q^T K q = -(q^T M q + v^T R) / lambda - 2 F_y s and
/// the last entry of R is -lambda s, where s is the residual of (30).
Margin energy_factors(const Sample& s) {
  const auto chain = from_rational<Mpfr50>(s.exact);
  double worst = 0;
  for (std::size_t i = 0; i < s.modes.size(); ++i) {
    const Mpfr50 off = abs(energy_factor(chain, s.modes[i].q) / s.modes[i].force - 1);
    worst = std::max(worst, static_cast<double>(off / (3 * epsilon<Mpfr50>() * s.condition[i])));
  }
  return worst;
}

/// F(c k, d L) = (c / d) F(k, L).
Margin scaling(const Sample& s) {
  const Rational c(3), d(7, 5);
  std::vector<Rational> length = s.exact.length(), stiffness = s.exact.stiffness();
  for (Rational& L : length) L *= d;
  for (Rational& k : stiffness) k *= c;
  const Chain<Rational> scaled(length, stiffness);
  const auto same_count = [&](const Rational& force) {
    return count_below(scaled, Rational(force * c / d)) == count_below(s.exact, force);
  };
  return holds(std::all_of(s.below.begin(), s.below.end(), same_count) &&
               std::all_of(s.above.begin(), s.above.end(), same_count));
}

Margin between(const Rational& low, const Rational& value, const Rational& high) {
  return holds(low < value && value < high);
}

Rational sum_of(const std::vector<Rational>& values) {
  return std::accumulate(values.begin(), values.end(), Rational(0));
}

Margin product(const Sample& s) {
  const auto product_of = [](const std::vector<Rational>& values) {
    return std::accumulate(values.begin(), values.end(), Rational(1), std::multiplies<>());
  };
  return between(product_of(s.below), proofs::product_of_forces(s.exact), product_of(s.above));
}

Margin sum(const Sample& s) {
  return between(sum_of(s.below), proofs::sum_of_forces(s.exact), sum_of(s.above));
}

Margin sum_of_inverses(const Sample& s) {
  const auto inverses = [](std::vector<Rational> values) {
    for (Rational& x : values) x = 1 / x;
    return values;
  };
  return between(sum_of(inverses(s.above)), proofs::sum_of_inverse_forces(s.exact),
                 sum_of(inverses(s.below)));
}

/// A stiffer joint adds a matrix of rank one to K: no force falls, and none passes the next one.
Margin stiffer_joint(const Sample& s) {
  std::vector<Chain<Rational>> others;
  for (std::size_t j = 0; j < s.exact.size(); ++j) {
    std::vector<Rational> stiffness = s.exact.stiffness();
    stiffness[j] = 3 * stiffness[j] + 1;
    others.emplace_back(s.exact.length(), stiffness);
  }
  return counts_compare(s, others, one_or_none_passed);
}

/// A frozen joint adds the constraint q_j = 0. A chain whose joint 1 is frozen starts at joint 2.
Margin frozen_joint(const Sample& s) {
  if (s.exact.size() == 2) return std::nullopt;
  std::vector<Chain<Rational>> others;
  for (std::size_t j = 0; j < s.exact.size(); ++j) {
    std::vector<Rational> length = s.exact.length(), stiffness = s.exact.stiffness();
    const auto at = static_cast<std::ptrdiff_t>(j);
    if (j > 0) length[j - 1] += length[j];
    length.erase(length.begin() + at);
    stiffness.erase(stiffness.begin() + at);
    others.emplace_back(length, stiffness);
  }
  return counts_compare(s, others, one_or_none_passed);
}

/// Without a spring at the base, energy, shortening and constraint are the same read from the other end.
Margin reversal(const Sample& s) {
  if (s.exact.stiffness()[0] != 0) return std::nullopt;
  std::vector<Rational> length = s.exact.length(), stiffness = s.exact.stiffness();
  std::reverse(length.begin(), length.end());
  std::reverse(stiffness.begin() + 1, stiffness.end());
  return counts_compare(s, {Chain<Rational>(length, stiffness)}, std::equal_to<>());
}

/// On a passive base for every link, on an elastic one for the first: theorem "Not monotone in length".
Margin longer_link(const Sample& s) {
  std::vector<Chain<Rational>> others;
  const std::size_t links = s.exact.stiffness()[0] == 0 ? s.exact.size() : 1;
  for (std::size_t j = 0; j < links; ++j) {
    std::vector<Rational> length = s.exact.length();
    length[j] *= Rational(3, 2);
    others.emplace_back(length, s.exact.stiffness());
  }
  return counts_compare(s, others, std::less_equal<>());
}

/// The last link cut off, with its joint. On an elastic base this may lower the forces, but no further.
Margin cut_link(const Sample& s) {
  if (s.exact.size() == 2) return std::nullopt;
  const auto all_but_last = [](const std::vector<Rational>& values) {
    return std::vector<Rational>(values.begin(), values.end() - 1);
  };
  const Chain<Rational> cut(all_but_last(s.exact.length()), all_but_last(s.exact.stiffness()));
  if (s.exact.stiffness()[0] == 0) return counts_compare(s, {cut}, one_or_none_passed);
  return counts_compare(s, {cut}, [](std::size_t count, std::size_t other) {
    return other <= count + 1 && count <= other + 1;
  });
}

constexpr std::array<ChainProperty, 13> all_properties{{
    {"zero eigenvalues", "B^-1 A has the eigenvalue 0 exactly twice, in one Jordan block",
     &two_zero_eigenvalues},
    {"forces",
     "n - 1 positive forces, simple but for an inner passive joint; Algorithm 1 finds them in 50 digits",
     &exact_counts},
    {"double", "Algorithm 1 in double agrees with 50 digits as the condition permits", &double_precision},
    {"energy factors", "mu_i = F_i", &energy_factors},
    {"scaling", "F(c k, d L) = (c / d) F(k, L)", &scaling},
    {"product", "prod F_i = (sum_i z_i^2 prod_{j!=i} k_j) / (prod L sum L)", &product},
    {"sum", "sum F_i = sum_j (k_j + k_{j+1}) / L_j - k_1 / sum L", &sum},
    {"sum of inverses", "sum 1/F_i in closed form", &sum_of_inverses},
    {"stiffer joint", "no force falls, and none passes the next one", &stiffer_joint},
    {"frozen joint", "the forces interlace with those of the chain with one joint frozen", &frozen_joint},
    {"reversal", "passive base: the reversed chain has the same forces", &reversal},
    {"longer link", "no force rises with L_1, or on a passive base with any length", &longer_link},
    {"cut link", "the forces interlace with those without the last link", &cut_link},
}};

}  // namespace

Sample::Sample(const Chain<double>& chain)
    : exact(convert<Rational>(chain, [](double x) { return Rational(x); })),
      modes(algorithm1(from_rational<Mpfr50>(exact))) {
  const auto mp50 = from_rational<Mpfr50>(exact);
  const auto n = static_cast<double>(exact.size());
  const Matrix<Mpfr50> C = algorithm1_matrix(mp50);
  const Vector<Mpfr50> z = matrix_S0(mp50);
  const Mpfr50 scale = matrix_B(mp50).norm() * C.norm();
  zero_scale = static_cast<double>(10 * n * C.norm() * z.norm() / z(0));
  for (const auto& mode : modes) {
    const Mpfr50 twice_shortening = 2 * small_deflection(mp50, mode.q).x;  // and |v| = 1
    condition.push_back(static_cast<double>(10 * n * scale / twice_shortening));
    const Rational force = proofs::exactly(mode.force);
    const Rational radius = force * proofs::exactly(epsilon<Mpfr50>() * Mpfr50(condition.back()));
    below.push_back(force - radius);
    above.push_back(force + radius);
  }
  try {
    for (const Mode<double>& mode : algorithm1(chain)) forces_in_double.push_back(mode.force);
  } catch (const Error&) {
    forces_in_double.clear();
  }
}

double Sample::error_in_double(std::size_t i) const {
  double nearest = infinity;
  for (const double force : forces_in_double)
    nearest = std::min(nearest, static_cast<double>(abs(force / modes[i].force - 1)));
  return nearest;
}

bool Sample::resolved(std::size_t i, double epsilon) const {
  const auto lambda = [&](std::size_t j) { return 1 / static_cast<double>(modes[j].force); };
  double gap = lambda(i) - std::sqrt(epsilon * zero_scale);
  for (std::size_t j = 0; j < modes.size(); ++j) {
    if (j != i) gap = std::min(gap, std::abs(lambda(j) - lambda(i)));
  }
  return 4 * epsilon * condition[i] * lambda(i) <= gap;
}

std::span<const ChainProperty> chain_properties() {
  return all_properties;
}

}  // namespace plumbline::verify
