#include "proofs/rod/characteristic.hpp"

#include <cmath>

#include "proofs/rod/series.hpp"

namespace plumbline::proofs {
namespace {

constexpr std::size_t most_unknowns = 6;

using Conditioned = std::vector<std::vector<Expansion>>;

/// By the first row; of the few unknowns that a rod has.
Expansion determinant_of(const Conditioned& rows) {
  if (rows.size() == 1) return rows[0][0];
  Expansion sum(rows[0][0].size());
  for (std::size_t c = 0; c < rows.size(); ++c) {
    if (rows[0][c].norm() == 0) continue;
    Conditioned minor(rows.begin() + 1, rows.end());
    for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
    const Expansion part = rows[0][c] * determinant_of(minor);
    sum += c % 2 == 0 ? part : -part;
  }
  return sum;
}

/// States of the rod, one for each unknown, and what is required of them.
class Conditions {
 public:
  /// Factors are s times one scale, squares of frequencies u times another.
  Conditions(ExpansionSize size, const Rational& factor_scale, const Rational& square_scale)
      : size_(size), factor_scale_(factor_scale), square_scale_(square_scale) {}

  /// At the base the rod begins: each of w, θ that is not held there is unknown.
  void begin(const RodNode& base) {
    if (!base.across.is_held()) add(0);
    if (!base.turn.is_held()) add(1);
    act(base);
    if (base.across.is_held()) add(3);
    if (base.turn.is_held()) add(2);
  }
  void pass(const RodStretch& stretch, const Rational& bed) {
    const RodEquation<Expansion> equation{
        growing(stretch.compression),
        growing(stretch.slope),
        growing(stretch.tangential),
        {size_, Interval(bed), Interval(0), Interval(Rational(-square_scale_))}};
    for (auto& state : states_) state = carried(state, stretch.length, equation);
  }
  void pass(const RodNode& node) {
    act(node);
    for (const auto& [what, by, held] :
         {std::tuple(0u, 3u, node.across.is_held()), std::tuple(1u, 2u, node.turn.is_held())}) {
      if (!held) continue;
      require(what);
      add(by);
    }
  }
  /// Beyond the end point there is nothing: neither M nor V is left.
  Expansion closed() {
    require(2);
    require(3);
    for (auto& row : rows_) row.resize(states_.size(), Expansion(size_));
    return determinant_of(rows_);
  }

 private:
  [[nodiscard]] Expansion growing(const Growing& value) const {
    return {size_, Interval(value.fixed), Interval(Rational(value.multiplied * factor_scale_)), Interval(0)};
  }
  /// What springs and forces along the tangent do.
  void act(const RodNode& node) {
    const Expansion follower = growing(node.follower);
    for (auto& state : states_) {
      state[3] += -(state[0] * Interval(node.across.stiffness) + follower * state[1]);
      state[2] += state[1] * Interval(node.turn.stiffness);
    }
  }
  void add(std::size_t unit) {
    const Expansion zero(size_);
    states_.push_back({zero, zero, zero, zero});
    states_.back()[unit] = Expansion(size_, Interval(1), Interval(0), Interval(0));
    if (states_.size() > most_unknowns) throw Error("rod", "too many supports", "four between its ends");
  }
  void require(std::size_t which) {
    rows_.emplace_back();
    for (const auto& state : states_) rows_.back().push_back(state[which]);
  }

  ExpansionSize size_;
  Rational factor_scale_, square_scale_;
  std::vector<RodState<Expansion>> states_;
  Conditioned rows_;
};

/// The next power of two.
double power_of_two(double x) {
  return std::exp2(std::ceil(std::log2(x)));
}

/// Powers after which the series of √n-fold sines and x^(1/4)-fold exponentials are below 1e-40.
ExpansionSize size_for(const DividedRod& rod, double factor_scale, double square_scale) {
  double load = 0;
  for (const RodStretch& stretch : rod.stretches)
    load += Span(Interval(stretch.length)).high * size_of(Interval(stretch.compression.multiplied));
  return {static_cast<std::size_t>(24 + 2.8 * std::sqrt(load * factor_scale)),
          static_cast<std::size_t>(18 + 1.2 * std::pow(square_scale, 0.25))};
}

/// A polynomial in two variables with its derivatives; the inner one is x.
template <class Real>
Jet<Real> polynomial_jet(const std::vector<std::vector<Real>>& rows, const Real& s, const Real& u) {
  Jet<Real> sum{Real(0), Real(0), Real(0), Real(0)};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    Real p(0), p1(0), p2(0);
    for (auto a = row->rbegin(); a != row->rend(); ++a) {
      p2 = p2 * u + p1;
      p1 = p1 * u + p;
      p = p * u + *a;
    }
    sum = {sum.value * s + p, sum.by_factor * s + sum.value, sum.by_square * s + p1,
           sum.by_square_twice * s + p2 + p2};
  }
  return sum;
}

}  // namespace

Characteristic::Characteristic(const DividedRod& rod, const Rational& most_factor,
                               const Rational& most_square)
    : factor_scale_(power_of_two(2 * Span(Interval(most_factor)).high)),
      square_scale_(power_of_two(2 * Span(Interval(most_square)).high)) {
  Conditions conditions(size_for(rod, factor_scale_, square_scale_), Rational(factor_scale_),
                        Rational(square_scale_));
  conditions.begin(rod.nodes[0]);
  for (std::size_t i = 0; i < rod.stretches.size(); ++i) {
    conditions.pass(rod.stretches[i], rod.bed);
    conditions.pass(rod.nodes[i + 1]);
  }
  const Expansion D = conditions.closed();
  coefficients_ = D.rows();
  rest_ = D.rest();
  for (const auto& row : coefficients_) {
    rounded_.emplace_back();
    for (const Interval& a : row) rounded_.back().push_back(Span(a));
  }
}

/// Within half the radius of both discs, Cauchy's estimates on a disc of the other half.
template <class Real>
Jet<Real> Characteristic::with_rest(const Jet<Real>& scaled) const {
  const auto number = [](double x) {
    if constexpr (std::is_same_v<Real, Span>)
      return Span(x);
    else
      return Interval::from_double(x);
  };
  const auto open = [&](const Real& x, double times) {
    Interval rest(0);
    add_remainder(rest, rest_ * times);
    return x + Real(rest);
  };
  const Real s = number(1 / factor_scale_), u = number(1 / square_scale_);
  return {open(scaled.value, 1), s * open(scaled.by_factor, 2), u * open(scaled.by_square, 2),
          u * u * open(scaled.by_square_twice, 8)};
}

Jet<Span> Characteristic::at(const Span& factor, const Span& x) const {
  return Slab(*this, factor).at(x);
}

Jet<Interval> Characteristic::at(const Interval& factor, const Interval& x) const {
  return with_rest(polynomial_jet(coefficients_, factor / Interval::from_double(factor_scale_),
                                  x / Interval::from_double(square_scale_)));
}

Characteristic::Slab::Slab(const Characteristic& function, const Span& factor) : function_(function) {
  const Span s = factor / Span(function.factor_scale_);
  const double middle = s.middle();
  std::size_t powers = 0;
  for (const auto& row : function.rounded_) powers = std::max(powers, row.size());
  for (std::size_t j = 0; j < powers; ++j) {
    Span p(0), slope(0), at_middle(0);
    for (auto row = function.rounded_.rbegin(); row != function.rounded_.rend(); ++row) {
      slope = slope * s + p;
      p = p * s;
      at_middle = at_middle * Span(middle);
      if (j >= row->size()) continue;
      p += (*row)[j];
      at_middle += (*row)[j];
    }
    value_.push_back(intersection(p, at_middle + slope * (s - Span(middle))));
    by_factor_.push_back(slope);
  }
}

Jet<Span> Characteristic::Slab::horner(const Span& u) const {
  Jet<Span> jet{0, 0, 0, 0};
  for (std::size_t j = value_.size(); j-- > 0;) {
    jet.by_square_twice = jet.by_square_twice * u + jet.by_square;
    jet.by_square = jet.by_square * u + jet.value;
    jet.value = jet.value * u + value_[j];
    jet.by_factor = jet.by_factor * u + by_factor_[j];
  }
  jet.by_square_twice += jet.by_square_twice;
  return jet;
}

/// By powers, and by the mean value theorem from the middle.
Jet<Span> Characteristic::Slab::at(const Span& x) const {
  const Span u = x / Span(function_.square_scale_), from = u - Span(u.middle());
  Jet<Span> jet = horner(u);
  if (x.width() > 0) {
    const Jet<Span> middle = horner(u.middle());
    jet.by_square = intersection(jet.by_square, middle.by_square + jet.by_square_twice * from);
    jet.value = intersection(jet.value, middle.value + jet.by_square * from);
  }
  return function_.with_rest(jet);
}

}  // namespace plumbline::proofs
