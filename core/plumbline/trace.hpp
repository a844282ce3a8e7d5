#pragma once
/// \file
/// A branch from end to end, with the events on it: folds, bifurcations, quasi-buckling points.

#include <boost/math/tools/roots.hpp>
#include <plumbline/bifurcation.hpp>
#include <string_view>

namespace plumbline {

enum class EventKind {
  fold,           ///< the load turns back: under a growing load the chain must jump (snap)
  bifurcation,    ///< another branch crosses: buckling
  quasi_buckling  ///< the tangent stiffness is least: the shape bends fastest, without a jump
};

/// The word for it.
inline std::string_view name(EventKind kind) {
  switch (kind) {
    case EventKind::fold:
      return "fold";
    case EventKind::bifurcation:
      return "bifurcation";
    case EventKind::quasi_buckling:
      break;
  }
  return "quasi-buckling";
}

template <Number Real>
struct BranchEvent {
  EventKind kind;
  std::size_t before;        ///< it lies behind points[before]
  BranchPoint<Real> point;   ///< located to working precision
  Variation<Real> crossing;  ///< at a bifurcation: the tangent of the other branch
};

/// Why a branch was not followed further.
enum class BranchEnd {
  load,        ///< the last point is at the end of the load window
  closed,      ///< it came back to where it began
  unstable,    ///< it goes on, unstable; only its stable part was asked for
  unbounded,   ///< the force grows beyond bounds: all links come into one line
  degenerate,  ///< a singular point that is neither a fold nor a simple bifurcation
  points       ///< as many points as were allowed
};

template <Number Real>
struct Branch {
  std::vector<BranchPoint<Real>> points;
  std::vector<BranchEvent<Real>> events;
  BranchEnd end;
};

template <Number Real>
struct TraceLimits {
  Real from, to;                      ///< load window
  Real longest = Real(1) / Real(20);  ///< longest step: root mean square turn of the links, in radians
  std::size_t points = 100000;
};

/// Follows one branch.
template <SmoothModel Model>
class Tracer {
 public:
  using Real = typename Model::Real;

  Tracer(Brancher<Model>& brancher, TraceLimits<Real> limits)
      : brancher_(&brancher), limits_(std::move(limits)) {}

  /// From a point, along its tangent. Never crosses to another branch: a step that could is shortened, and
  /// where steps come to nothing the branch ends as degenerate.
  Branch<Real> run(BranchPoint<Real> start) {
    Branch<Real> branch{{std::move(start)}, {}, BranchEnd::points};
    Real h = limits_.longest / Real(16), tried = std::numeric_limits<Real>::max();
    brancher_->refresh(branch.points.back());
    auto horizon = brancher_->horizon(branch.points.back(), 8);
    while (branch.points.size() < limits_.points) {
      const BranchPoint<Real> here = branch.points.back();
      if (horizon.ahead > Real(0) && horizon.ahead < limits_.longest && horizon.ahead < tried / Real(2)) {
        tried = horizon.ahead;
        if (cross(branch, horizon)) {
          tried = std::numeric_limits<Real>::max();
          h = limits_.longest / Real(16);
          brancher_->refresh(branch.points.back());
          horizon = brancher_->horizon(branch.points.back(), 8);
          continue;
        }
      }
      h = smallest(Real(2) * h, limits_.longest, horizon.distance * Real(2) / Real(5));
      std::optional<BranchPoint<Real>> next = advance(here, h);
      while (!next && h > shortest()) {
        h /= Real(2);
        next = advance(here, h);
      }
      if (!next) {
        branch.end = BranchEnd::degenerate;
        return branch;
      }
      if (outside(next->load)) return finish(branch, here);
      horizon = brancher_->horizon(*next, 2);
      if (horizon.distance > Real(4) * tried) tried = std::numeric_limits<Real>::max();
      branch.points.push_back(std::move(*next));
      note_events(branch, h);
      if (closed(branch) || !brancher_->force_bounded(branch.points.back())) {
        branch.end = closed(branch) ? BranchEnd::closed : BranchEnd::unbounded;
        return branch;
      }
    }
    return branch;
  }

  /// The fold between a point and the one h ahead, where the tangent's load changes sign.
  BranchPoint<Real> fold(const BranchPoint<Real>& from, const Real& h) {
    return zero(from, h, [](const BranchPoint<Real>& at) { return at.tangent.load; });
  }

  /// The stationary tangent stiffness between a point and the one h ahead.
  BranchPoint<Real> stationary_stiffness(const BranchPoint<Real>& from, const Real& h) {
    return zero(from, h, [](const BranchPoint<Real>& at) { return at.stiffness_rate; });
  }

 private:
  static Real shortest() {
    using std::pow;
    return pow(epsilon<Real>(), Real(2) / Real(3));
  }
  static Real smallest(const Real& a, const Real& b, const Real& c) {
    using std::min;
    return min(a, min(b, c));
  }
  [[nodiscard]] bool outside(const Real& load) const { return load < limits_.from || load > limits_.to; }

  static bool orientation(const BranchPoint<Real>& p) {
    return (p.negative_directions % 2 == 0) == (p.tangent.load > Real(0));
  }

  /// A step that stays on the branch for sure: an orientation that changes is a crossing, and inertia changes
  /// by one exactly where the load turns.
  std::optional<BranchPoint<Real>> advance(const BranchPoint<Real>& here, const Real& h) {
    auto next = brancher_->step(here, h);
    if (!next || orientation(*next) != orientation(here)) return std::nullopt;
    const std::size_t a = here.negative_directions, b = next->negative_directions;
    if ((a > b ? a - b : b - a) > 1) return std::nullopt;
    return next;
  }

  Branch<Real> finish(Branch<Real>& branch, const BranchPoint<Real>& here) {
    const Real& edge = here.tangent.load > Real(0) ? limits_.to : limits_.from;
    if (auto last = brancher_->at_load(here, edge)) branch.points.push_back(std::move(*last));
    branch.end = BranchEnd::load;
    return std::move(branch);
  }

  static Variation<Real> chord(const BranchPoint<Real>& a, const BranchPoint<Real>& b) {
    return {b.theta - a.theta, {b.force.x - a.force.x, b.force.y - a.force.y}, b.load - a.load};
  }

  /// Over a simple bifurcation ahead, if there is one and it is on this branch.
  bool cross(Branch<Real>& branch, const typename Brancher<Model>::Horizon& horizon) {
    using std::abs;
    const BranchPoint<Real> here = branch.points.back();
    BranchPoint<Real> guess = here;
    Brancher<Model>::move(guess, here.tangent, horizon.ahead);
    auto found = BifurcationSolver<Model>(*brancher_).near(std::move(guess), horizon.direction);
    if (!found || found->tangents.size() != 2 || found->imperfection > Real(256) * epsilon<Real>())
      return false;
    const Variation<Real> way = chord(here, found->point);
    const Real distance = brancher_->length(way), straight = Real(99) / Real(100);
    const auto along = [&](const Variation<Real>& t) { return brancher_->product(way, t) / distance; };
    if (distance > Real(2) * horizon.ahead || !(along(here.tangent) > straight)) return false;
    const std::size_t mine = abs(along(found->tangents[0])) > abs(along(found->tangents[1])) ? 0 : 1;
    Variation<Real> tangent = found->tangents[mine];
    if (along(tangent) < Real(0)) Brancher<Model>::scale(tangent, Real(-1));
    if (!(along(tangent) > straight)) return false;
    brancher_->describe_singular(found->point, tangent);
    found->point.negative_directions = here.negative_directions;  // in between, rounding alone would decide
    if (outside(found->point.load)) return false;
    auto beyond = brancher_->step(found->point, distance);
    if (!beyond || orientation(*beyond) == orientation(here)) return false;
    branch.events.push_back(
        {EventKind::bifurcation, branch.points.size() - 1, found->point, found->tangents[1 - mine]});
    branch.points.push_back(found->point);
    branch.points.push_back(std::move(*beyond));
    return true;
  }

  void note_events(Branch<Real>& branch, const Real& h) {
    const auto& points = branch.points;
    const std::size_t last = points.size() - 1;
    const BranchPoint<Real>&a = points[last - 1], &b = points[last];
    if ((a.tangent.load > Real(0)) != (b.tangent.load > Real(0))) {
      branch.events.push_back({EventKind::fold, last - 1, fold(a, h), {}});
      return;
    }
    const Real now = b.stiffness_rate * sign(b.tangent.load);
    const Real before = a.stiffness_rate * sign(a.tangent.load);
    if (before < Real(0) && now > Real(0) && !is_event(branch, last - 1))
      branch.events.push_back({EventKind::quasi_buckling, last - 1, stationary_stiffness(a, h), {}});
  }
  static Real sign(const Real& x) { return x < Real(0) ? Real(-1) : Real(1); }
  static bool is_event(const Branch<Real>& branch, std::size_t point) {
    return !branch.events.empty() && branch.events.back().before + 1 == point;
  }

  template <class Quantity>
  BranchPoint<Real> zero(const BranchPoint<Real>& from, const Real& h, Quantity quantity) {
    using std::abs;
    const auto at = [&](const Real& s) {
      auto point = brancher_->step(from, s);
      if (!point) throw Error("branch", "a step that does not settle", "a regular branch around an event");
      return *point;
    };
    const auto value = [&](const Real& s) { return quantity(at(s)); };
    std::uintmax_t evaluations = 200;
    const auto close = [&](const Real& a, const Real& b) { return abs(b - a) <= epsilon<Real>() * h; };
    const Real left = value(Real(0)), right = value(h);
    const auto [a, b] = boost::math::tools::toms748_solve(value, Real(0), h, left, right, close, evaluations);
    BranchPoint<Real> found = at((a + b) / Real(2));
    found.negative_directions = from.negative_directions;  // at a fold rounding alone would decide
    return found;
  }

  bool closed(const Branch<Real>& branch) const {
    if (branch.points.size() < 8) return false;
    const BranchPoint<Real>&first = branch.points.front(), &last = branch.points.back();
    const Variation<Real> gap = chord(last, first);
    const Real distance = brancher_->length(gap);
    // the start lies within the step just ended, on the same piece of the branch
    return distance < limits_.longest &&
           brancher_->product(first.tangent, last.tangent) > Real(99) / Real(100) &&
           brancher_->product(gap, last.tangent) > Real(99) / Real(100) * distance &&
           first.negative_directions == last.negative_directions;
  }

  Brancher<Model>* brancher_;
  TraceLimits<Real> limits_;
};

}  // namespace plumbline
