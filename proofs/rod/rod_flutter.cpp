#include "proofs/rod/rod_flutter.hpp"

#include <cmath>

#include "proofs/rod/inertia_of_rod.hpp"
#include "proofs/rod/real_frequencies.hpp"

namespace plumbline::proofs {
namespace {

Error open_sign() {
  return {"rod", "a sign that 64 digits leave open", "fewer digits"};
}

double lower_magnitude(const Span& x) {
  return certainly_positive(x) ? x.low : certainly_negative(x) ? -x.high : 0;
}
bool same_sign(const Span& a, const Span& b) {
  return (certainly_positive(a) && certainly_positive(b)) || (certainly_negative(a) && certainly_negative(b));
}
Span unit_sign(const Span& x) {
  return certainly_positive(x) ? 1 : -1;
}

/// A loss, proved to be the one event among the zeros below the bound at the factors of a span.
struct Event {
  Motion kind;
  Span factors, near;       ///< x near the zeros that take part
  double x;                 ///< where they meet, about
  double sign, least_bend;  ///< of the second derivative near there
};

/// About the k-th square of a frequency at factor 0, from above: with k negative directions below it.
double unloaded_square(const DividedRod& rod, std::size_t k) {
  const auto below = [&](const Rational& x) { return negative_directions(rod, 0, x); };
  Rational low = 0, high = 1;
  while (below(high) < k) high *= 4;
  for (int halving = 0; halving < 12; ++halving) {
    const Rational middle = (low + high) / 2;
    (below(middle) < k ? low : high) = middle;
  }
  return Span(Interval(high)).high;
}

/// Between the lowest so many squares at factor 0 and the next one. 	hrows Open where these are close
double bound_above(const DividedRod& rod, std::size_t frequencies) {
  const double here = unloaded_square(rod, frequencies), next = unloaded_square(rod, frequencies + 1);
  const double bound = std::pow((std::pow(here, 0.25) + std::pow(next, 0.25)) / 2, 4);
  if (negative_directions(rod, 0, Rational(bound)) != frequencies)
    throw Error("rod", "frequencies close to each other", "distinct ones");
  return bound;
}

/// Follows the lowest so many frequencies, those below a bound, while the factor grows from 0.
class Following {
 public:
  Following(const Characteristic& function, std::size_t frequencies, double bound)
      : function_(function), frequencies_(frequencies), bound_(bound) {}

  /// The first event up to a factor.
  [[nodiscard]] std::optional<Event> first_event(double most) const {
    double at = 0, width = most / 64;
    const double least = width * 1e-5;
    while (at + width < most) {
      if (simple_zeros(function_, {at, at + width}, {0, bound_}) == frequencies_) {
        at += width;
        width *= 1.4;
        continue;
      }
      if (const auto event = fold(at, width, most)) return event;
      if (const auto event = divergence(at, width, most)) return event;
      if ((width /= 2) < least) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// x where the function is stationary beside a place, and the factor at which it is zero there.
  [[nodiscard]] std::optional<std::pair<double, double>> stationary_zero(double factor, double x,
                                                                         double most) const {
    for (int step = 0; step < 60; ++step) {
      const Jet<Span> jet = function_.at(Span(factor), Span(x));
      const double to_x = -jet.by_square.middle() / jet.by_square_twice.middle();
      const double to_factor = -jet.value.middle() / jet.by_factor.middle();
      x += to_x;
      factor += to_factor;
      if (!(x > 0 && x < bound_ && factor > 0 && factor < most)) return std::nullopt;
      if (std::abs(to_x) < 1e-7 * x && std::abs(to_factor) < 1e-10 * factor) return std::pair(factor, x);
    }
    return std::nullopt;
  }
  /// Places where the function is stationary at a factor, about.
  [[nodiscard]] std::vector<double> stationary(double factor) const {
    const Characteristic::Slab slab(function_, factor);
    std::vector<double> found;
    constexpr int parts = 64;
    double before = 0, at = 0;
    for (int i = 0; i <= parts; ++i) {
      const double x = bound_ * std::pow(static_cast<double>(i) / parts, 4);
      const double slope = slab.at(x).by_square.middle();
      if (i > 0 && (slope > 0) != (before > 0)) found.push_back((x + at) / 2);
      before = slope;
      at = x;
    }
    return found;
  }

  /// Two zeros meet within reach of the interval of factors that begins at `from`.
  [[nodiscard]] std::optional<Event> fold(double from, double width, double most) const {
    for (const double start : stationary(from)) {
      const auto meeting = stationary_zero(from, start, most);
      if (!meeting || meeting->first <= from || meeting->first > from + 2 * width ||
          2 * meeting->first - from > most)
        continue;
      const auto [factor, x] = *meeting;
      const Jet<Span> there = function_.at(Span(factor), Span(x));
      const double half = 2 * std::sqrt(2 * (factor - from) * there.by_factor.magnitude() /
                                        there.by_square_twice.magnitude());
      const Span factors{from, factor + (factor - from)}, near{x - half, x + half};
      if (!(near.low > 0 && near.high < bound_)) continue;
      const Jet<Span> jet = function_.at(factors, near);
      const auto ends_agree = [&](double end) {
        return same_sign(function_.at(factors, Span(end)).value, jet.by_square_twice);
      };
      if (!same_sign(jet.by_factor, jet.by_square_twice) || !ends_agree(near.low) || !ends_agree(near.high))
        continue;
      const auto below = simple_zeros(function_, factors, {0, near.low}),
                 above = simple_zeros(function_, factors, {near.high, bound_});
      if (below && above && *below + *above + 2 == frequencies_)
        return Event{Motion::flutter,
                     factors,
                     near,
                     x,
                     unit_sign(jet.by_square_twice).low,
                     lower_magnitude(jet.by_square_twice)};
    }
    return std::nullopt;
  }

  /// A zero passes 0 within reach of the interval of factors that begins at `from`.
  [[nodiscard]] std::optional<Event> divergence(double from, double width, double most) const {
    double factor = from;
    for (int step = 0; step < 60 && factor >= 0 && factor <= most; ++step) {
      const Jet<Span> jet = function_.at(Span(factor), Span(0));
      factor -= jet.value.middle() / jet.by_factor.middle();
    }
    if (!(factor > from && factor <= from + 2 * width && 2 * factor - from <= most)) return std::nullopt;
    const Jet<Span> there = function_.at(Span(factor), Span(0));
    const double reach = 2 * (factor - from) * there.by_factor.magnitude() / there.by_square.magnitude();
    const Span factors{from, factor + (factor - from)}, near{0, reach};
    if (!(reach < bound_)) return std::nullopt;
    const Jet<Span> jet = function_.at(factors, near);
    if (!same_sign(jet.by_factor, jet.by_square) ||
        !same_sign(function_.at(factors, Span(reach)).value, jet.by_square))
      return std::nullopt;
    if (simple_zeros(function_, factors, {reach, bound_}) != frequencies_ - 1) return std::nullopt;
    return Event{Motion::divergence, factors, near, 0, unit_sign(jet.by_square).low, 0};
  }

  const Characteristic& function_;
  std::size_t frequencies_;
  double bound_;  ///< of the squares of frequencies
};

/// Whether an event has taken place at a factor of its span.
class Reached {
 public:
  Reached(const Characteristic& function, const Event& event)
      : function_(function), event_(event), x_(Interval::from_double(event.x)) {}

  bool operator()(const Rational& factor) {
    return event_.kind == Motion::divergence ? passed(Interval(factor)) : parted(Interval(factor));
  }

 private:
  /// The function is of one sign at x = 0 before, of the other after.
  [[nodiscard]] bool passed(const Interval& factor) const {
    const Interval value = Interval::from_double(event_.sign) * function_.at(factor, Interval(0)).value;
    if (certainly_negative(value)) return false;
    if (certainly_positive(value)) return true;
    throw open_sign();
  }
  /// While its least value near the meeting is below zero there are two zeros; above, none. A function whose
  /// second derivative is at least c is nowhere less than f - f'^2 / (2 c).
  bool parted(const Interval& factor) {
    const Interval sign = Interval::from_double(event_.sign);
    for (int step = 0; step < 12; ++step) {
      const Jet<Interval> jet = function_.at(factor, x_);
      const Interval value = sign * jet.value;
      if (certainly_negative(value)) return false;
      const Interval least = value - sqr(jet.by_square) / Interval::from_double(2 * event_.least_bend);
      if (certainly_positive(least)) return true;
      const Interval nearer = x_ - jet.by_square / jet.by_square_twice;
      if (!Span(nearer).inside(event_.near)) break;
      x_ = Interval(nearer.middle(), nearer.middle());
    }
    throw open_sign();
  }

  const Characteristic& function_;
  Event event_;
  Interval x_;
};

}  // namespace

RodLoss rod_flutter(const DividedRod& rod, int digits) {
  Rational most = 0;
  bool fixed = false;
  for (const RodStretch& stretch : rod.stretches) {
    most = std::max(most, Rational(abs(stretch.compression.multiplied)));
    fixed = fixed || stretch.tangential.fixed != 0;
  }
  for (const RodNode& node : rod.nodes) fixed = fixed || node.follower.fixed != 0;
  if (most == 0) throw Error("rod", "no load that the factor multiplies", "one");
  if (fixed) throw Error("rod", "a follower force that is fixed", "one that the factor multiplies");
  if (negative_directions(rod, 0, 0) != 0)
    throw Error("rod", "fixed loads under which it gives way", "a rod that is stable at factor 0");
  for (const std::size_t frequencies : {4u, 6u}) {
    const double bound = bound_above(rod, frequencies);
    for (const int reach : {32, 64, 128}) {
      const Rational factors = reach / most;
      const Characteristic function(rod, factors, Rational(bound));
      const auto event = Following(function, frequencies, bound).first_event(Span(Interval(factors)).low);
      if (!event) continue;
      Reached reached(function, *event);
      const auto at = [&](const Rational& factor) { return reached(factor); };
      const RootBracket bracket{Rational(event->factors.low), Rational(event->factors.high)};
      return {event->kind, narrowed(bracket, digits, at), frequencies};
    }
  }
  throw Error("rod", "no loss of stability that could be proved", "one among its lowest frequencies");
}

}  // namespace plumbline::proofs
