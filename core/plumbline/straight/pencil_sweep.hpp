#pragma once
/// \file
/// The positive eigenvalues of a straight structure's pencil by the iteration that finds the critical forces
/// of a string (critical_force.hpp): what is swept is the factorisation K - F G = U^T D U, in O(n).
///
/// Beside the string, whose data are perturbed relatively by rounding, this loses up to as many digits as the
/// condition of K has, n^4 of a chain of n equal links: numbers with digits to spare are to be taken, and
/// the counts of exact numbers say whether there were enough.

#include <optional>
#include <plumbline/straight/critical_force.hpp>
#include <plumbline/straight/pencil.hpp>

namespace plumbline::detail {

/// A truncated Taylor series in the relative change of the factor.
template <Floating Real>
using Taylor = std::array<Real, 4>;

template <Floating Real>
Taylor<Real> product(const Taylor<Real>& a, const Taylor<Real>& b) {
  Taylor<Real> c;
  for (std::size_t t = 0; t < 4; ++t) {
    c[t] = Real(0);
    for (std::size_t s = 0; s <= t; ++s) c[t] += a[s] * b[t - s];
  }
  return c;
}
/// \param per_first  the reciprocal of b's first coefficient
template <Floating Real>
Taylor<Real> quotient(const Taylor<Real>& a, const Taylor<Real>& b, const Real& per_first) {
  Taylor<Real> c;
  for (std::size_t t = 0; t < 4; ++t) {
    c[t] = a[t];
    for (std::size_t s = 0; s < t; ++s) c[t] -= c[s] * b[t - s];
    c[t] *= per_first;
  }
  return c;
}
template <Floating Real>
void subtract(Taylor<Real>& a, const Taylor<Real>& b) {
  for (std::size_t t = 0; t < 4; ++t) a[t] -= b[t];
}

/// A pencil whose K is positive definite, how many positive eigenvalues it has, and where they all are.
template <class Real>
struct SweptPencil {
  const StraightPencil<Real>& pencil;
  std::size_t modes;
  Bracket<Real> all{};

  [[nodiscard]] std::size_t size() const { return modes; }
  [[nodiscard]] std::size_t degree() const { return static_cast<std::size_t>(pencil.size()); }
};

/// The determinant of K - F G up to a positive factor, with its Taylor coefficients in the relative change of
/// F, and the number of eigenvalues below F. A pivot that vanishes stands for a tiny one.
template <int order, Floating Real>
Sweep<Real, 3> sweep(const SweptPencil<Real>& swept, const Real& F) {
  using std::abs;
  const Band<Real, 2>&K = swept.pencil.stiffness, &G = swept.pencil.load;
  const Eigen::Index n = K.cols();
  const auto entry = [&](Eigen::Index d, Eigen::Index i) {
    const Real push = -F * G(d, i);
    return Taylor<Real>{Real(K(d, i) + push), push, Real(0), Real(0)};
  };
  const auto none = Taylor<Real>{Real(0), Real(0), Real(0), Real(0)};
  Taylor<Real> f{Real(1), Real(0), Real(0), Real(0)};
  // what elimination has left of the entries of this column and of the next
  Taylor<Real> here = entry(0, 0), beside = n > 1 ? entry(1, 0) : none, next = n > 1 ? entry(0, 1) : none;
  Sweep<Real, 3> result{{}, 0};
  for (Eigen::Index i = 0; i < n; ++i) {
    if (here[0] == Real(0)) here[0] = epsilon<Real>() * abs(K(0, i));
    if (here[0] < Real(0)) ++result.below;
    const Real per_pivot = Real(1) / here[0];
    f = product(f, here);
    const Real scale = Real(1) / abs(f[0]);
    for (Real& x : f) x *= scale;
    const Taylor<Real> far = i + 2 < n ? entry(2, i) : none;
    const Taylor<Real> share = quotient(beside, here, per_pivot), far_share = quotient(far, here, per_pivot);
    subtract(next, product(share, beside));
    Taylor<Real> next_beside = i + 2 < n ? entry(1, i + 1) : none;
    subtract(next_beside, product(share, far));
    Taylor<Real> after = i + 2 < n ? entry(0, i + 2) : none;
    subtract(after, product(far_share, far));
    here = next;
    beside = next_beside;
    next = after;
  }
  for (std::size_t t = 0; t < 4; ++t) result.f[t] = f[t];
  return result;
}

template <Floating Real>
void sweep_all(const SweptPencil<Real>& swept, std::span<const Bracket<Real>> brackets,
               std::span<Sweep<Real, 3>> found) {
  for (std::size_t i = 0; i < brackets.size(); ++i) found[i] = sweep<3>(swept, brackets[i].next);
}

template <Floating Real>
Bracket<Real> all_of(const SweptPencil<Real>& swept) {
  return swept.all;
}

/// A stretch of the line that holds all positive eigenvalues, from the springs over the loads outwards in
/// steps whose exponents double: two dozen leave the range of any type. Nothing where rounding makes K
/// indefinite or hides one of them, which more digits mend.
template <Floating Real>
std::optional<Bracket<Real>> stretch_of(const SweptPencil<Real>& swept) {
  using std::abs;
  constexpr int most = 24;
  Real springs(0), push(0);
  for (Eigen::Index i = 0; i < swept.pencil.size(); ++i) {
    springs += abs(swept.pencil.stiffness(0, i));
    for (Eigen::Index d = 0; d <= 2; ++d) push += abs(swept.pencil.load(d, i));
  }
  if (sweep<3>(swept, Real(0)).below > 0) return std::nullopt;
  Real low = springs / push, high = low, step(256);
  for (int tries = 0; sweep<3>(swept, low).below > 0; ++tries, step *= step) {
    low /= step;
    if (tries == most || !(low > Real(0))) return std::nullopt;
  }
  step = Real(256);
  for (int tries = 0; sweep<3>(swept, high).below < swept.modes; ++tries, step *= step) {
    high *= step;
    if (tries == most || !is_finite(high)) return std::nullopt;
  }
  Bracket<Real> all{low, high, 0, swept.modes, Real(0)};
  all.halve();
  return all;
}

}  // namespace plumbline::detail

namespace plumbline {

/// The lowest positive eigenvalues of a pencil whose K is positive definite, ascending, each as often as it
/// occurs; none where so many digits are too few. \param modes  how many there are: kind_of()
template <Floating Real>
std::vector<Real> critical_factors(const StraightPencil<Real>& pencil, std::size_t lowest,
                                   std::size_t modes) {
  if (modes == 0) return {};
  detail::SweptPencil<Real> swept{pencil, modes};
  const auto all = detail::stretch_of(swept);
  if (!all) return {};
  swept.all = *all;
  return detail::roots_by_brackets(swept, lowest);
}

/// The deflections of the nodes at an eigenvalue, up to a factor, by inverse iteration, at right angles (in
/// G) to those that are given of the same eigenvalue.
template <Floating Real>
Vector<Real> critical_deflections(const StraightPencil<Real>& pencil, const Real& factor,
                                  const std::vector<Vector<Real>>& apart_from = {}) {
  using std::sqrt;
  const Eigen::Index n = pencil.size();
  const auto times_load = [&](const Vector<Real>& w) {
    Vector<Real> result = Vector<Real>::Constant(n, Real(0));
    for (Eigen::Index i = 0; i < n; ++i) {
      result(i) += pencil.load(0, i) * w(i);
      for (Eigen::Index d = 1; d <= 2 && i + d < n; ++d) {
        result(i + d) += pencil.load(d, i) * w(i);
        result(i) += pencil.load(d, i) * w(i + d);
      }
    }
    return result;
  };
  BorderedBand<Real, 2> matrix;
  matrix.factor(pencil.at(Real(factor * (Real(1) + sqrt(epsilon<Real>())))));
  matrix.no_border();
  Vector<Real> w(n), none(0);
  std::uint64_t random = 88172645463325252u + apart_from.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    random ^= random << 13, random ^= random >> 7, random ^= random << 17;
    w(i) = Real(1) + Real(static_cast<double>(random >> 11)) / Real(9007199254740992.0);
  }
  for (int step = 0; step < 4; ++step) {
    for (const Vector<Real>& other : apart_from) {
      const Vector<Real> pushed = times_load(other);
      const Real share = pushed.dot(w) / pushed.dot(other);
      w -= share * other;
    }
    w = times_load(w);
    matrix.solve(w, none);
    w /= w.cwiseAbs().maxCoeff();
  }
  return w;
}

}  // namespace plumbline
