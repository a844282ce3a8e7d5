#include "proofs/exact/straight_structure.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>
#include <plumbline/straight/pencil_sweep.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/found_forces.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

MpfrInterval enclosed(const Rational& x) {
  MpfrInterval result;
  mpfi_set_q(result.backend().data(), x.backend().data());
  return result;
}

/// Negative pivots of a band; nothing where the sign of one is open.
std::optional<std::size_t> negative_pivots(const Band<Rational, 2>& band) {
  const Eigen::Index n = band.cols();
  const auto entry = [&](Eigen::Index d, Eigen::Index i) {
    return i + d < n ? enclosed(band(d, i)) : MpfrInterval(0);
  };
  std::size_t negative = 0;
  MpfrInterval here = entry(0, 0), beside = entry(1, 0), next = n > 1 ? entry(0, 1) : MpfrInterval(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (mpfi_has_zero(here.backend().data()) != 0) return std::nullopt;
    if (mpfi_is_neg(here.backend().data()) != 0) ++negative;
    const MpfrInterval far = entry(2, i), share = beside / here, far_share = far / here;
    here = next - share * beside;
    beside = i + 1 < n ? MpfrInterval(entry(1, i + 1) - share * far) : MpfrInterval(0);
    next = i + 2 < n ? MpfrInterval(entry(0, i + 2) - far_share * far) : MpfrInterval(0);
  }
  return negative;
}

/// Digits that intervals take to tell the signs of n pivots apart, mostly.
int first_digits(Eigen::Index n, const Rational& factor) {
  const auto size = static_cast<int>(mpz_sizeinbase(mpq_numref(factor.backend().data()), 10));
  return size + 20 + static_cast<int>(n / 4 < 200 ? n / 4 : 200);
}

std::size_t count_below(const StraightPencil<Rational>& pencil, const Rational& factor) {
  const Band<Rational, 2> at = pencil.at(factor);
  for (int tries = 0, digits = first_digits(at.cols(), factor); tries < 3; ++tries, digits *= 2) {
    const WorkingPrecision precision(digits);
    if (const auto count = negative_pivots(at)) return *count;
  }
  return negative_eigenvalues(at);
}

StraightPencil<Mpfr> rounded(const StraightPencil<Rational>& exact) {
  const auto all = [](const Band<Rational, 2>& band) {
    Band<Mpfr, 2> result(3, band.cols());
    for (Eigen::Index i = 0; i < band.cols(); ++i) {
      for (Eigen::Index d = 0; d <= 2; ++d) result(d, i) = from_rational<Mpfr>(band(d, i));
    }
    return result;
  };
  return {all(exact.stiffness), all(exact.load), exact.unknown};
}

/// Joint angles from deflections of all nodes; a clamped link does not turn, whatever rounding leaves.
std::vector<Mpfr> joint_angles_of(const Structure<Rational>& structure, const std::vector<Mpfr>& w) {
  std::vector<Mpfr> q;
  Mpfr before(0);
  for (std::size_t i = 0; i < structure.chain.size(); ++i) {
    const Mpfr slope = (w[i + 1] - w[i]) / from_rational<Mpfr>(structure.chain.length()[i]);
    q.push_back(slope - before);
    before = slope;
  }
  return q;
}

struct Shape {
  std::vector<Mpfr> q;
  Mpfr fy;
};

/// The force that the end point exerts on what holds it across, at deflections of the nodes.
/// Zero where its terms cancel in so many digits.
Mpfr across_end(const Structure<Rational>& structure, const Mpfr& factor, const std::vector<Mpfr>& w,
                int digits) {
  if (structure.end_point.across.is_free()) return Mpfr(0);
  if (!structure.end_point.across.is_held())
    return from_rational<Mpfr>(structure.end_point.across.stiffness) * w.back();
  Structure<Rational> loose = structure;  // the end point's row is there only where it is not held
  loose.end_point.across = {};
  const StraightPencil<Mpfr> pencil = rounded(straight_pencil(loose));
  const Band<Mpfr, 2> T = pencil.at(factor);
  const Eigen::Index row = pencil.unknown.back();
  Vector<Mpfr> all = Vector<Mpfr>::Constant(pencil.size(), Mpfr(0));
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (pencil.unknown[i] >= 0) all(pencil.unknown[i]) = w[i];
  }
  Mpfr force(0), terms(0);
  for (Eigen::Index d = 0; d <= 2 && d <= row; ++d) {
    force -= T(d, row - d) * all(row - d);
    terms += abs(T(d, row - d)) * all.cwiseAbs().maxCoeff();
  }
  return abs(force) > terms * pow(Mpfr(10), -digits) ? force : Mpfr(0);
}

/// Whether every row of (K - F G) w is zero but for what its terms lose in so many digits, or in twice as
/// many those of a part that does not bend.
bool balanced(const StraightPencil<Mpfr>& pencil, const Mpfr& factor, const Vector<Mpfr>& w, int digits) {
  const Mpfr largest = w.cwiseAbs().maxCoeff(), share = pow(Mpfr(10), -digits);
  Vector<Mpfr> sum = Vector<Mpfr>::Constant(w.size(), Mpfr(0)), terms = sum;
  const auto add = [&](Eigen::Index row, Eigen::Index column, const Mpfr& k, const Mpfr& g) {
    sum(row) += (k - factor * g) * w(column);
    terms(row) += (abs(k) + factor * abs(g)) * (abs(w(column)) + share * largest);
  };
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    for (Eigen::Index d = 0; d <= 2 && i + d < w.size(); ++d) {
      add(i + d, i, pencil.stiffness(d, i), pencil.load(d, i));
      if (d > 0) add(i, i + d, pencil.stiffness(d, i), pencil.load(d, i));
    }
  }
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    if (abs(sum(i)) > terms(i) * share) return false;
  }
  return true;
}

/// The shapes at the lowest factors, computed with so many digits and sure to some of them; the order of
/// equal ones is open. Nothing where the digits are too few.
std::optional<std::vector<Shape>> shapes_with(int digits, int sure, const Structure<Rational>& structure,
                                              const StraightPencil<Rational>& exact, std::size_t lowest,
                                              std::size_t modes) {
  const WorkingPrecision precision(digits);
  const StraightPencil<Mpfr> pencil = rounded(exact);
  const auto factors = critical_factors(pencil, lowest, modes);
  if (factors.empty()) return std::nullopt;
  const Mpfr close = pow(Mpfr(10), -digits / 2);
  std::vector<Shape> shapes;
  std::vector<Vector<Mpfr>> tied;
  for (std::size_t m = 0; m < factors.size(); ++m) {
    if (m > 0 && factors[m] - factors[m - 1] > close * factors[m]) tied.clear();
    tied.push_back(critical_deflections(pencil, factors[m], tied));
    if (!balanced(pencil, factors[m], tied.back(), sure)) return std::nullopt;
    const auto w = pencil.deflections(tied.back());
    shapes.push_back({joint_angles_of(structure, w), across_end(structure, factors[m], w, 3 * sure / 2)});
  }
  return shapes;
}

/// What rounding leaves of a value that is zero beside others changes with the digits.
void clear_noise(std::vector<Mpfr>& q, int digits) {
  Mpfr largest(0);
  for (const Mpfr& angle : q) largest = std::max(largest, Mpfr(abs(angle)));
  for (Mpfr& angle : q) {
    if (abs(angle) < largest * pow(Mpfr(10), -digits)) angle = 0;
  }
}

/// Size of the largest angle with the sign of the first.
template <class Real>
Real scale_of(const std::vector<Real>& q) {
  using std::abs;
  Real largest(0), first(0);
  for (const Real& angle : q) {
    if (abs(angle) > largest) largest = abs(angle);
    if (first == Real(0)) first = angle;
  }
  return first < Real(0) ? Real(-largest) : largest;
}

}  // namespace

std::vector<std::size_t> count_below(const StraightPencil<Rational>& pencil,
                                     const std::vector<Rational>& factors) {
  std::vector<std::size_t> counts;
  counts.reserve(factors.size());
  for (const Rational& factor : factors) counts.push_back(count_below(pencil, factor));
  return counts;
}

StraightStructure::StraightStructure(const Structure<Rational>& structure) : structure_(structure) {
  structure.require_sound();
  const auto [fixed, multiplied] = compression(structure);
  if (std::all_of(multiplied.begin(), multiplied.end(), [](const Rational& N) { return N == 0; }))
    throw Error("loads", "none that is multiplied and loads a link", "one: its critical factor is asked for");
  string_ = string_form(structure);
  if (string_) {
    modes_ = mode_count(string_->chain);
    return;
  }
  find_pencil();
}

void StraightStructure::find_pencil() {
  pencil_ = straight_pencil(structure_);
  const PencilKind kind = kind_of(pencil_);
  if (kind.unstable > 0)
    throw Error("structure", "one that the fixed loads alone make give way",
                "fixed loads below the critical ones");
  if (kind.mechanism)
    throw Error("structure", "a mechanism, which moves across without any force",
                "ends, springs and stiffnesses that hold it");
  if (kind.modes == 0)
    throw Error("structure", "loads that no positive factor makes critical: they pull, or nothing can turn",
                "a load that compresses, and two links or more that can turn");
  modes_ = kind.modes;
}

std::vector<ForceEnclosure> StraightStructure::enclose(std::size_t lowest, int digits) const {
  if (string_) return enclose_critical_forces(string_->straight(), lowest, digits);
  FoundForces found(std::min(lowest, modes_), digits,
                    [&](const std::vector<Rational>& factors) { return count_below(pencil_, factors); });
  const int lost = 4 + static_cast<int>(4 * std::log10(static_cast<double>(pencil_.size()) + 1));
  for (int sure_digits = digits + 12; !found.complete(); sure_digits += sure_digits / 2) {
    require_affordable(sure_digits);
    const WorkingPrecision precision(sure_digits + lost);
    found.enclose(critical_factors(proofs::rounded(pencil_), lowest, modes_), sure_digits);
  }
  return found.all();
}

std::string StraightStructure::rounded(const ForceEnclosure& factor, int digits) const {
  const std::string low = to_decimal(factor.low, digits), high = to_decimal(factor.high, digits);
  if (low == high) return low;
  const Rational half_way = (*parse_decimal(low) + *parse_decimal(high)) / 2;
  const std::size_t below = string_ ? ExactCount(string_->straight()).below(half_way)
                                    : count_below(pencil_, std::vector{half_way}).front();
  return below >= factor.index ? low : high;
}

std::vector<CriticalMode> StraightStructure::in_decimals(std::size_t lowest, int digits, bool shapes) const {
  std::vector<CriticalMode> modes;
  constexpr int most = 15;
  for (const ForceEnclosure& factor : enclose(lowest, digits)) {
    const std::string text = rounded(factor, digits);
    modes.push_back({text, digits > most ? rounded(factor, most) : text, {}, 0, {}});
  }
  if (shapes) string_ ? add_string_shapes(modes, digits) : add_pencil_shapes(modes, digits);
  return modes;
}

void StraightStructure::add_string_shapes(std::vector<CriticalMode>& modes, int digits) const {
  auto found = modes_in_decimals(string_->straight(), modes.size(), digits);
  // the springs of a guided string are shares of the compression, and so is the force that its guide takes up
  const Rational unit =
      string_->end_point == EndPoint::guided ? compression(structure_).multiplied[0] : Rational(1);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<double> q(structure_.chain.size(), 0.0);
    std::string signs(structure_.chain.size(), '0');
    for (std::size_t i = 0; i < string_->joints; ++i) {
      q[string_->first + i] = found[m].q[i];
      signs[string_->first + i] = found[m].signs[i];
    }
    const double scale = scale_of(q);
    for (double& angle : q) angle /= scale == 0 ? 1 : scale;
    modes[m].q = std::move(q);
    modes[m].signs = std::move(signs);
    if (scale < 0) {
      for (char& sign : modes[m].signs) sign = sign == '+' ? '-' : sign == '-' ? '+' : '0';
    }
    Rational size;
    mpq_set_d(size.backend().data(), scale == 0 ? 1 : scale);
    modes[m].fy = found[m].fy * unit / size;
  }
}

void StraightStructure::add_pencil_shapes(std::vector<CriticalMode>& modes, int digits) const {
  const int lost = 4 + static_cast<int>(4 * std::log10(static_cast<double>(pencil_.size()) + 1));
  const int sure = std::max(digits, 16) + 24;
  std::optional<std::vector<Shape>> shapes;
  int working = 2 * (sure + lost);
  for (; !shapes; working *= 2) {
    require_affordable(working);
    shapes = shapes_with(working, sure, structure_, pencil_, modes.size(), modes_);
  }
  const WorkingPrecision precision(working);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<Mpfr>& q = (*shapes)[m].q;
    clear_noise(q, sure);
    const Mpfr scale = scale_of(q);
    for (const Mpfr& angle : q)
      modes[m].q.push_back(angle == 0 ? 0.0 : static_cast<double>(Mpfr(angle / scale)));
    for (const Mpfr& angle : q) modes[m].signs += angle == 0 ? '0' : (angle / scale < 0 ? '-' : '+');
    modes[m].fy = exactly(Mpfr((*shapes)[m].fy / scale));
  }
}

}  // namespace plumbline::proofs
