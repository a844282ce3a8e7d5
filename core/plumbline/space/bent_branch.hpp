#pragma once
/// \file
/// Branches of equilibria of a bent structure as the factor of its loads grows: pseudo-arclength
/// continuation, with stability, folds and bifurcations.

#include <functional>
#include <plumbline/space/bent_equilibrium.hpp>

namespace plumbline {

/// The kinds of events on a branch.
enum class BentEventKind {
  fold,        ///< the factor turns back
  bifurcation  ///< another branch crosses this one
};

/// What happens between two points of a branch.
template <Number Real>
struct BentEvent {
  BentEventKind kind;      ///< fold or bifurcation
  std::size_t before;      ///< the event lies before the point of this number
  BentPoint<Real> point;   ///< where it is
  Vector<Real> direction;  ///< at a bifurcation, in which the structure can move at no change of the factor
};

/// The reasons for which a branch ends.
enum class BentEnd {
  factor,    ///< the factor leaves the limits
  closed,    ///< the branch has come back to its first point
  stuck,     ///< no step short enough converges
  loss,      ///< of stability, and the structure went on elsewhere
  flight,    ///< of stability, and no rest was reached beyond
  singular,  ///< at a singular shape of what holds the structure, which decides nothing
  budget     ///< as many linear systems were solved as the limits allow
};

/// A branch of equilibria, in the order in which it was followed.
template <Number Real>
struct BentBranch {
  std::vector<BentPoint<Real>> points;  ///< from the start on
  std::vector<BentEvent<Real>> events;  ///< between those points
  BentEnd end = BentEnd::budget;        ///< why it goes no further
};

/// How far a branch is followed, and in what steps.
template <Number Real>
struct BentLimits {
  Real from;  ///< smallest factor
  Real to;    ///< largest factor
  Real longest =
      Real(1) / Real(20);        ///< step: root mean square turn of the axes in radians, and share of `to`
  std::size_t solves = 150'000;  ///< linear systems of one tracer, at most: all its loops end there
};

/// Pseudo-arclength continuation of one model. Dense, O(n^3) a step.
template <Floating Real>
class BentTracer {
 public:
  /// Whether a shape is singular.
  using Judge = std::function<bool(const Vector<Real>&)>;

  /// \param model  has to outlive the tracer
  BentTracer(const BentStructure<Real>& model, BentLimits<Real> limits)
      : BentTracer(model, std::move(limits),
                   [&model](const Vector<Real>& x) { return is_singular(model, x); }) {}
  /// \param singular  judges shapes in more digits
  BentTracer(const BentStructure<Real>& model, BentLimits<Real> limits, Judge singular)
      : solver_(model), limits_(std::move(limits)), singular_(std::move(singular)) {}

  /// The branch from a point on, towards growing factor, or the other way.
  BentBranch<Real> run(BentPoint<Real> start, bool growing = true) {
    BentBranch<Real> branch;
    orient(start, growing ? Real(1) : Real(-1));
    const BentPoint<Real> first = start;
    branch.points.push_back(std::move(start));
    Real h = limits_.longest / Real(4);
    while (!is_spent()) {
      const BentPoint<Real> here = branch.points.back();
      auto next = step(here, h);
      if (!next) {
        h /= Real(2);
        if (h > limits_.longest * Real(1e-6)) continue;
        branch.end = BentEnd::stuck;
        return branch;
      }
      if (next->factor > limits_.to || next->factor < limits_.from) {
        const Real& edge = next->factor > limits_.to ? limits_.to : limits_.from;
        const Real share = (edge - here.factor) / (next->factor - here.factor);
        const auto last = solver_.at_factor(here.x + share * (next->x - here.x), edge,
                                            here.multiplier + share * (next->multiplier - here.multiplier));
        if (last) {
          BentPoint<Real> end = *last;
          orient(end, here);
          if (!note(branch, here, end, Real(share * h))) return branch;
          branch.points.push_back(std::move(end));
        }
        branch.end = BentEnd::factor;
        return branch;
      }
      if (!note(branch, here, *next, h)) return branch;
      branch.points.push_back(*next);
      if (branch.points.size() > 8 && distance(branch.points.back(), first) < h / Real(2)) {
        branch.end = BentEnd::closed;
        return branch;
      }
      h = std::min(limits_.longest, Real(h * Real(1.5)));
    }
    return branch;
  }

  /// The points where another branch leaves a bifurcation, to either side.
  std::vector<BentPoint<Real>> leave(const BentEvent<Real>& event, const Real& by) {
    std::vector<BentPoint<Real>> result;
    for (const Real& side : {by, Real(-by)}) {
      auto row = solver_.keep_factor();
      row.x = event.direction;
      row.factor = Real(0);
      BentPoint<Real> guess = event.point;
      guess.x += side * event.direction;
      auto found = solver_.correct(guess, row);
      if (found) result.push_back(*std::move(found));
    }
    return result;
  }

  /// The Newton solver of the model.
  BentSolver<Real>& solver() { return solver_; }
  /// Whether it has solved as many systems as its limits allow.
  [[nodiscard]] bool is_spent() const { return solver_.solves() >= limits_.solves; }
  /// Whether a shape is singular.
  [[nodiscard]] bool is_singular_at(const Vector<Real>& x) const { return singular_(x); }

 private:
  using Row = typename BentSolver<Real>::Row;

  [[nodiscard]] Real weight() const { return Real(1) / Real(static_cast<double>(solver_.model().size())); }
  [[nodiscard]] Real product(const BentPoint<Real>& a, const Vector<Real>& x, const Real& factor) const {
    return weight() * a.tangent_x.dot(x) + a.tangent_factor * factor / (limits_.to * limits_.to);
  }
  [[nodiscard]] Real distance(const BentPoint<Real>& a, const BentPoint<Real>& b) const {
    using std::sqrt;
    const Real f = (a.factor - b.factor) / limits_.to;
    return sqrt(Real(weight() * (a.x - b.x).squaredNorm() + f * f));
  }
  void scale(BentPoint<Real>& point, const Real& by) const {
    point.tangent_x *= by;
    point.tangent_multiplier *= by;
    point.tangent_factor *= by;
  }
  void unit(BentPoint<Real>& point) const {
    using std::sqrt;
    scale(point, Real(1) / sqrt(product(point, point.tangent_x, point.tangent_factor)));
  }
  void orient(BentPoint<Real>& point, const Real& sign) const {
    unit(point);
    if (point.tangent_factor * sign < Real(0)) scale(point, Real(-1));
  }
  void orient(BentPoint<Real>& point, const BentPoint<Real>& before) const {
    unit(point);
    if (product(before, point.tangent_x, point.tangent_factor) < Real(0)) scale(point, Real(-1));
  }

  std::optional<BentPoint<Real>> step(const BentPoint<Real>& from, const Real& h) {
    BentPoint<Real> guess = from;
    guess.x += h * from.tangent_x;
    guess.multiplier += h * from.tangent_multiplier;
    guess.factor += h * from.tangent_factor;
    const Row row{weight() * from.tangent_x, Vector<Real>::Constant(solver_.model().held(), Real(0)),
                  from.tangent_factor / (limits_.to * limits_.to), Real(0)};
    auto next = solver_.correct(guess, row, 8);
    if (!next || distance(*next, guess) > h / Real(4)) return std::nullopt;
    orient(*next, from);
    if (product(from, next->tangent_x, next->tangent_factor) < Real(0.9)) return std::nullopt;
    const std::size_t a = from.negative_directions, b = next->negative_directions;
    if ((a > b ? a - b : b - a) > 1 && h > limits_.longest * Real(1e-4)) return std::nullopt;
    return next;
  }

  /// The event between two points a step h apart, where the negative directions change. \return false where
  /// it is at a singular shape, which ends the branch
  bool note(BentBranch<Real>& branch, const BentPoint<Real>& a, const BentPoint<Real>& b, const Real& h) {
    const bool turned = (a.tangent_factor < Real(0)) != (b.tangent_factor < Real(0));
    if (a.negative_directions == b.negative_directions && !turned) return true;
    Real low(0), high = h;
    BentPoint<Real> at = b;
    for (int i = 0; i < 60; ++i) {
      const Real middle = (low + high) / Real(2);
      const auto between = step(a, middle);
      if (!between) break;
      at = *between;
      const bool passed = turned ? (at.tangent_factor < Real(0)) != (a.tangent_factor < Real(0))
                                 : at.negative_directions != a.negative_directions;
      (passed ? high : low) = middle;
      if (high - low < Real(64) * epsilon<Real>()) break;
    }
    if (singular_(at.x)) {
      branch.end = BentEnd::singular;
      return false;
    }
    const auto kind = turned ? BentEventKind::fold : BentEventKind::bifurcation;
    branch.events.push_back(
        {kind, branch.points.size(), at, turned ? Vector<Real>() : solver_.weakest_direction(at)});
    return true;
  }

  BentSolver<Real> solver_;
  BentLimits<Real> limits_;
  Judge singular_;
};

namespace detail {

/// The stable part of a branch; whether there is more of it.
template <Floating Real>
bool cut_where_unstable(BentBranch<Real>& branch) {
  const auto unstable = std::find_if(branch.points.begin(), branch.points.end(),
                                     [](const auto& point) { return point.negative_directions > 0; });
  if (unstable == branch.points.end()) return false;
  const auto end = static_cast<std::size_t>(unstable - branch.points.begin());
  branch.points.erase(unstable, branch.points.end());
  std::erase_if(branch.events, [end](const auto& event) { return event.before > end; });
  branch.end = BentEnd::loss;
  return true;
}

/// The weakest direction of a point, towards a side.
template <Floating Real>
Vector<Real> leaving(BentSolver<Real>& solver, const BentPoint<Real>& point, int side) {
  Vector<Real> way = solver.weakest_direction(point);
  const auto first =
      std::find_if(way.begin(), way.end(), [](const Real& x) { return x > Real(1e-6) || x < Real(-1e-6); });
  if (first != way.end() && (*first < Real(0)) != (side < 0)) way = -way;
  return way;
}

}  // namespace detail

/// What a slowly loaded structure does: it follows its stable branch from a point on; where stability ends it
/// leaves a bifurcation to the given side, or jumps, to where the energy flows. \throws Error where the start
/// is unstable
template <Floating Real>
std::vector<BentBranch<Real>> load_slowly(BentTracer<Real>& tracer, BentPoint<Real> start,
                                          const BentLimits<Real>& limits, int side = 1) {
  if (start.negative_directions > 0) throw Error("slow loading", "an unstable start", "a stable one");
  const Real nudge = Real(1) / Real(1000);
  std::vector<BentBranch<Real>> history;
  while (true) {
    history.push_back(tracer.run(start));
    BentBranch<Real>& branch = history.back();
    if (!detail::cut_where_unstable(branch)) return history;
    const BentPoint<Real> last = branch.events.empty() ? branch.points.back() : branch.events.back().point;
    const Vector<Real> way = detail::leaving(tracer.solver(), last, side);
    const Real factor = last.factor + nudge * nudge * limits.to;
    if (factor > limits.to) return history;
    auto rest = tracer.solver().settle(last.x + nudge * way, factor);
    if (!rest) {
      branch.end = BentEnd::flight;
    } else if (tracer.is_singular_at(rest->x)) {
      branch.end = BentEnd::singular;
    } else if (tracer.is_spent()) {
      branch.end = BentEnd::budget;
    } else {
      start = *std::move(rest);
      continue;
    }
    return history;
  }
}

}  // namespace plumbline
