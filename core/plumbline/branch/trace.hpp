#pragma once
/// \file
/// A branch from end to end, with the events on it.
///
/// \code{.cpp}
/// // The equilibria of the paper's Z-chain from its unloaded shape on, its end point pushed in by up to 1.5.
/// const std::vector<double> rest{-0.2417, 0.6821, -0.7958, 0.5170};
/// const NominalModel<double> model(Chain<double>({1, 1, 1, 1}, {1, 1, 1, 1}, rest));
/// const Loading<double> push{Control::end_point, end_point(model.chain(), rest), {-1, 0}};
/// Brancher<NominalModel<double>> brancher(model, push, absolute_angles(rest));
/// const auto start = brancher.start(0, absolute_angles(rest));
/// const auto branch = Tracer<NominalModel<double>>(brancher, {.from = 0, .to = 1.5}).run(start);
/// assert(branch.end == BranchEnd::load && branch.points.back().load == 1.5);
/// assert(branch.events.size() == 1 && branch.events[0].kind == EventKind::quasi_buckling);
/// \endcode

#include <boost/math/tools/roots.hpp>
#include <plumbline/branch/bifurcation.hpp>
#include <plumbline/branch/branch_event.hpp>

namespace plumbline {

/// Why a branch was not followed further.
enum class BranchEnd {
  load,        ///< the last point is at the end of the load window
  closed,      ///< it came back to where it began
  unstable,    ///< it goes on, unstable; only its stable part was asked for
  unbounded,   ///< the force grows beyond bounds: all links come into one line
  degenerate,  ///< a singular point that is neither a fold nor a simple bifurcation
  points       ///< as many points as were allowed
};

/// Points of a branch in their order, what happens between them, and why it ends.
template <Number Real>
struct Branch {
  std::vector<BranchPoint<Real>> points;  ///< at least one
  std::vector<BranchEvent<Real>> events;  ///< in the order of the points
  BranchEnd end;                          ///< why it ends
};

/// How far a branch is followed, and in what steps.
template <Number Real>
struct TraceLimits {
  Real from;                          ///< least load
  Real to;                            ///< largest load
  Real longest = Real(1) / Real(20);  ///< longest way between points: root mean square turn of the links, in
                                      ///< radians
  std::size_t points = 100000;        ///< no stride is begun with more
};

/// Follows one branch.
///
/// A stride goes as far as the series around its first point is exact, and is never chosen by hope: it is
/// taken only where
/// - the horizons of its two ends meet, so that the equations stay regular in between,
/// - (-1)^negative_directions · sign(dload/ds) is the same at both ends, for that cannot change along a
///   branch without a crossing, and the negative directions differ by one at most.
/// So the type of a point in between is that of the end on its side of the fold, if the stride has one.
template <SmoothModel Model>
class Tracer {
 public:
  /// The number type.
  using Real = typename Model::Real;

  /// With the model and the loading of a brancher, which has to outlive it.
  Tracer(Brancher<Model>& brancher, TraceLimits<Real> limits)
      : brancher_(&brancher), limits_(std::move(limits)) {}

  /// From a point, along its tangent. Never crosses to another branch: a stride that could is shortened, and
  /// where strides come to nothing the branch ends as degenerate.
  Branch<Real> run(BranchPoint<Real> start) {
    Branch<Real> branch{{std::move(start)}, {}, BranchEnd::points};
    brancher_->refresh(branch.points.back());
    horizon_ = brancher_->horizon(branch.points.back(), 8);
    tried_ = std::numeric_limits<Real>::max();
    end_.reset();
    while (!end_ && branch.points.size() < limits_.points) {
      here_ = branch.points.back();
      brancher_->expand(here_, series_);
      if (!cross(branch)) stride(branch);
    }
    if (end_) branch.end = *end_;
    return branch;
  }

 private:
  using Series = BranchSeries<Real>;
  using Horizon = typename Brancher<Model>::Horizon;

  static Real shortest() {
    using std::pow;
    return pow(epsilon<Real>(), Real(2) / Real(3));
  }
  [[nodiscard]] bool outside(const Real& load) const { return load < limits_.from || load > limits_.to; }
  static bool orientation(const BranchPoint<Real>& p) {
    return (p.negative_directions % 2 == 0) == (p.tangent.load > Real(0));
  }

  /// As far as is sure, with the points and events on the way.
  void stride(Branch<Real>& branch) {
    Real h = farthest(Real(1));
    while (h > shortest()) {
      if (stride(branch, h)) return;
      h /= Real(2);
    }
    end_ = BranchEnd::degenerate;
  }
  /// By h, if that is sure; else nothing.
  bool stride(Branch<Real>& branch, const Real& h) {
    const auto next = brancher_->onto(brancher_->along(series_, h), h);
    if (!next) return false;
    const std::size_t events = branch.events.size();
    auto ahead = horizon_if_sure(*next, h);
    if (!ahead || !lay(branch, here_.negative_directions, *next, Real(0), h)) return false;
    horizon_ = std::move(*ahead);
    if (horizon_.distance > Real(4) * tried_) tried_ = std::numeric_limits<Real>::max();
    if (!end_ && !brancher_->force_bounded(*next)) end_ = BranchEnd::unbounded;
    if (branch.events.size() > events) brancher_->refresh(*next);
    return true;
  }
  /// \param share  of the reach of the series
  Real farthest(const Real& share) const {
    using std::min;
    return min(Real(share * series_.reach), Real(1) / Real(2));
  }

  /// The horizon of the end of a stride that stays on its branch for sure.
  std::optional<Horizon> horizon_if_sure(const BranchPoint<Real>& next, const Real& h) {
    const std::size_t a = here_.negative_directions, b = next.negative_directions;
    if (orientation(here_) != orientation(next) || (a > b ? a - b : b - a) > 1) return std::nullopt;
    Horizon ahead = brancher_->horizon(next, 4);
    if (horizon_.distance + ahead.distance < h) return std::nullopt;
    return ahead;
  }

  static Variation<Real> chord(const BranchPoint<Real>& a, const BranchPoint<Real>& b) {
    return {b.theta - a.theta, {b.force.x - a.force.x, b.force.y - a.force.y}, b.load - a.load};
  }
  /// Whether the series passes a point, and where.
  std::optional<Real> passes(const BranchPoint<Real>& point) {
    using std::abs, std::sqrt;
    const Real s = brancher_->product(chord(here_, point), here_.tangent);
    if (!(abs(s) < farthest(Real(3) / Real(2)))) return std::nullopt;
    const Real close = sqrt(sqrt(epsilon<Real>()));
    if (!(brancher_->length(chord(brancher_->along(series_, s), point)) < close * abs(s)))
      return std::nullopt;
    return s;
  }

  /// Over a simple bifurcation ahead, if there is one and it is on this branch.
  bool cross(Branch<Real>& branch) {
    const Real guess = horizon_.ahead;
    if (!(guess > Real(0) && guess < farthest(Real(3) / Real(2)) && guess < tried_ / Real(2))) return false;
    tried_ = guess;
    auto found = detail::BifurcationSolver<Model>(*brancher_)
                     .near(brancher_->along(series_, guess), horizon_.direction);
    if (!found || !found->simple() || outside(found->point.load)) return false;
    const auto s = passes(found->point);
    if (!s || !(*s > Real(0))) return false;
    const auto crossing = take_tangent(*found, *s);
    const auto beyond = crossing ? hop(found->point, *s) : std::nullopt;
    if (!beyond) return false;
    crossing_ = *s;
    const bool laid = lay(branch, here_.negative_directions, found->point, Real(0), *s);
    crossing_.reset();
    if (!laid) return false;
    if (end_) return true;
    branch.events.push_back({EventKind::bifurcation, branch.points.size() - 2, found->point, *crossing});
    here_ = *beyond;
    std::swap(series_, ahead_);
    brancher_->refresh(here_);
    horizon_ = brancher_->horizon(here_, 8);
    tried_ = std::numeric_limits<Real>::max();
    crossing_ = brancher_->product(chord(here_, found->point), here_.tangent);
    if (!lay(branch, here_.negative_directions, here_, *crossing_, Real(0))) branch.points.push_back(here_);
    crossing_.reset();
    brancher_->refresh(here_);
    return true;
  }

  /// Describes a bifurcation as a point of this branch. \return the tangent of the other; nothing if neither
  /// goes this way
  std::optional<Variation<Real>> take_tangent(detail::Bifurcation<Real>& found, const Real& s) {
    using std::abs;
    const Variation<Real> along = brancher_->along(series_, s).tangent;
    const auto agrees = [&](const Variation<Real>& t) { return brancher_->product(along, t); };
    const std::size_t mine = abs(agrees(found.tangents[0])) > abs(agrees(found.tangents[1])) ? 0 : 1;
    Variation<Real> tangent = found.tangents[mine];
    if (agrees(tangent) < Real(0)) Brancher<Model>::scale(tangent, Real(-1));
    if (!(agrees(tangent) > Real(99) / Real(100))) return std::nullopt;
    const auto beside = brancher_->onto(brancher_->along(series_, s * Real(63) / Real(64)), s);
    if (!beside) return std::nullopt;
    brancher_->describe_singular(found.point, tangent);
    found.point.stiffness = series_.stiffness(s);
    found.point.negative_directions = beside->negative_directions;  // at the crossing rounding would decide
    return found.tangents[1 - mine];
  }

  /// A point of the same branch beyond a bifurcation that is s ahead, whose own series reaches back to it.
  std::optional<BranchPoint<Real>> hop(const BranchPoint<Real>& over, const Real& s) {
    using std::min;
    const Real longest = Real(1) / Real(20), least = min(s, longest) / Real(64);
    Real h = longest;
    while (h > least) {
      auto beyond = brancher_->step(over, h);
      if (beyond && orientation(*beyond) != orientation(here_)) {
        brancher_->refresh(*beyond);
        brancher_->expand(*beyond, ahead_);
        if (h < Real(3) / Real(2) * ahead_.reach) return beyond;
      }
      h /= Real(2);
    }
    return std::nullopt;
  }

  /// A place in a stride, with what shows an event.
  struct Place {
    Real s;
    Real load;
    Real turn;  ///< derivative of the load
    Real bend;
  };
  Place place(const Real& s) {
    series_.go_to(s);
    return place_at_hand(s);
  }
  [[nodiscard]] Place place_at_hand(const Real& s) const {
    return {s, series_.value(Series::load), series_.slope(Series::load), series_.value(Series::bend)};
  }

  /// The points of a stride over (from, to], evenly spaced, the last one given, with the events between them;
  /// fewer where the branch ends on the way. False, and nothing is laid, where the load turns twice or a
  /// point is not found.
  /// \param type  negative directions up to a fold; behind, those of the last point
  bool lay(Branch<Real>& branch, std::size_t type, BranchPoint<Real> last, const Real& from, Real to) {
    using std::ceil;
    const std::size_t points = branch.points.size(), events = branch.events.size();
    const auto start = points > 1 ? passes(branch.points.front()) : std::nullopt;
    const bool closes = start && *start > from && *start <= to;
    if (closes) {
      last = branch.points.front();
      to = *start;
    }
    const auto count = static_cast<int>(ceil((to - from) / limits_.longest));
    bool turned = false;
    const Real inset = crossing_ ? beside_crossing((to - from) / Real(count)) : Real(0);
    Place before = place(crossing_ && *crossing_ == from ? Real(from + inset) : from);
    for (int i = 1; i <= count; ++i) {
      const Real s = i < count ? Real(from + (to - from) * Real(i) / Real(count)) : to;
      std::optional<BranchPoint<Real>> point = i < count ? point_at(s) : last;
      const bool crosses = crossing_ && *crossing_ == s;
      const Place here = i < count ? place_at_hand(s) : place(crosses ? Real(s - inset) : s);
      const bool turns = (before.turn > Real(0)) != (here.turn > Real(0));
      if (!point || (turns && turned)) {
        branch.points.resize(points);
        branch.events.resize(events);
        return false;
      }
      if (outside(point->load)) {
        leave(branch, place(i > 1 ? before.s : from), place(s));
        return true;
      }
      note_event(branch, before, here);
      turned = turned || turns;
      if (i < count) point->negative_directions = turned ? last.negative_directions : type;
      branch.points.push_back(std::move(*point));
      before = here;
    }
    if (closes) end_ = BranchEnd::closed;
    return true;
  }

  /// How far from a crossing the turn of the load is looked at: it may vanish there without a fold, and near
  /// it rounding blurs the turn.
  static Real beside_crossing(const Real& interval) {
    using std::max, std::min, std::sqrt;
    const Real blur = Real(64) * sqrt(epsilon<Real>());
    return min(max(blur, Real(interval / Real(1000))), Real(interval / Real(2)));
  }

  std::optional<BranchPoint<Real>> point_at(const Real& s) {
    using std::abs;
    BranchPoint<Real> point = brancher_->along(series_, s);
    if (abs(s) <= series_.reach) return point;
    return brancher_->onto(std::move(point), Real(abs(s)));
  }

  void note_event(Branch<Real>& branch, const Place& a, const Place& b) {
    using std::abs;
    if ((a.turn > Real(0)) != (b.turn > Real(0))) {
      const Real s = zero([this](const Real& at) { return place(at).turn; }, a.s, b.s);
      auto found = located(branch, EventKind::fold, s);
      // beside a crossing the turn may be all rounding, and its sign means nothing
      if (!found && crossing_ && abs(s - *crossing_) < (b.s - a.s) / Real(100)) return;
      if (!found) throw Error("branch", "a fold that cannot be located", "a regular branch around it");
      branch.events.push_back({EventKind::fold, branch.points.size() - 1, std::move(*found), {}});
    } else if (a.bend < Real(0) && b.bend > Real(0)) {
      const Real s = zero([this](const Real& at) { return place(at).bend; }, a.s, b.s);
      auto found = located(branch, EventKind::quasi_buckling, s);
      // where the bend is all rounding, as beside a crossing, its sign means nothing
      if (!found || (found->load > a.load) == (found->load > b.load)) return;
      // a branch that turns back at a crossing is softest there by itself
      const bool by_crossing = crossing_ && abs(s - *crossing_) < b.s - a.s;
      if (by_crossing && !(found->stiffness < series_.stiffness(*crossing_))) return;
      branch.events.push_back({EventKind::quasi_buckling, branch.points.size() - 1, std::move(*found), {}});
    }
  }
  std::optional<BranchPoint<Real>> located(const Branch<Real>& branch, EventKind kind, const Real& s) {
    BranchPoint<Real> near = brancher_->along(series_, s);
    near.negative_directions = branch.points.back().negative_directions;
    return locate(*brancher_, kind, std::move(near));
  }

  /// The last point, at the edge of the load window.
  void leave(Branch<Real>& branch, const Place& inside, const Place& beyond) {
    end_ = BranchEnd::load;
    const Real& edge = beyond.load > limits_.to ? limits_.to : limits_.from;
    if (outside(inside.load) || inside.load == edge) return;
    const Real s = zero([&](const Real& at) { return Real(place(at).load - edge); }, inside.s, beyond.s);
    auto last = brancher_->at_load(brancher_->along(series_, s), edge);
    if (!last) return;  // no event either: one lies between two points
    note_event(branch, inside, place(s));
    branch.points.push_back(std::move(*last));
  }

  template <class Quantity>
  static Real zero(const Quantity& quantity, const Real& low, const Real& high) {
    using std::abs;
    std::uintmax_t evaluations = 200;
    const auto close = [&](const Real& a, const Real& b) {
      return abs(b - a) <= epsilon<Real>() * abs(high);
    };
    const auto [a, b] = boost::math::tools::toms748_solve(quantity, low, high, close, evaluations);
    return (a + b) / Real(2);
  }

  Brancher<Model>* brancher_;
  TraceLimits<Real> limits_;
  BranchPoint<Real> here_;  ///< where the series is expanded
  Series series_;
  Series ahead_;  ///< beyond a crossing
  std::optional<BranchEnd> end_;
  Horizon horizon_;
  Real tried_;  ///< the nearest crossing that was looked for and not found: to look again only when nearer
  std::optional<Real> crossing_;  ///< a bifurcation at an end of the stride
};

}  // namespace plumbline
