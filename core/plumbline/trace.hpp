#pragma once
/// \file
/// A branch from end to end, with the events on it.

#include <boost/math/tools/roots.hpp>
#include <plumbline/bifurcation.hpp>
#include <plumbline/branch_event.hpp>

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

template <Number Real>
struct Branch {
  std::vector<BranchPoint<Real>> points;
  std::vector<BranchEvent<Real>> events;
  BranchEnd end;
};

template <Number Real>
struct TraceLimits {
  Real from, to;                      ///< load window
  Real longest = Real(1) / Real(20);  ///< longest way between points: root mean square turn of the links, in
                                      ///< radians
  std::size_t points = 100000;
};

/// Follows one branch.
///
/// A stride goes as far as the series around its first point is exact, and is never chosen by hope: it is
/// taken only where
/// - the horizons of its two ends meet, so that the equations stay regular in between,
/// - (-1)^negative_directions · sign(dload/ds) is the same at both ends, for that cannot change along a
/// branch
///   without a crossing, and the negative directions differ by one at most.
/// So the type of a point in between is that of the end on its side of the fold, if the stride has one.
template <SmoothModel Model>
class Tracer {
 public:
  using Real = typename Model::Real;

  Tracer(Brancher<Model>& brancher, TraceLimits<Real> limits)
      : brancher_(&brancher), limits_(std::move(limits)) {}

  /// From a point, along its tangent. Never crosses to another branch: a stride that could is shortened, and
  /// where strides come to nothing the branch ends as degenerate.
  Branch<Real> run(BranchPoint<Real> start) {
    Branch<Real> branch{{std::move(start)}, {}, BranchEnd::points};
    brancher_->refresh(branch.points.back());
    horizon_ = brancher_->horizon(branch.points.back(), 8);
    tried_ = std::numeric_limits<Real>::max();
    std::optional<BranchEnd> end;
    while (!end && branch.points.size() < limits_.points) {
      const BranchPoint<Real> here = branch.points.back();
      brancher_->expand(here, series_);
      if (cross(branch, here)) continue;
      end = stride(branch, here);
    }
    if (end) branch.end = *end;
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

  /// As far as is sure, with the points and events on the way. Says why the branch ends, where it does.
  std::optional<BranchEnd> stride(Branch<Real>& branch, const BranchPoint<Real>& here) {
    for (Real h = farthest(Real(1)); h > shortest(); h /= Real(2)) {
      const auto next = brancher_->onto(brancher_->along(series_, h), h);
      if (!next || !sure(here, *next, h)) continue;
      const BranchPoint<Real> first = branch.points.front();
      const Real back = brancher_->product(chord(here, first), here.tangent);
      const bool closes = branch.points.size() > 1 && back > Real(0) && back <= h && meets(back, first);
      const std::size_t events = branch.events.size();
      const Laid laid =
          lay(branch, here.negative_directions, closes ? first : *next, Real(0), closes ? back : h);
      if (laid == Laid::unsure) continue;
      if (laid == Laid::left) return BranchEnd::load;
      if (closes) return BranchEnd::closed;
      if (!brancher_->force_bounded(*next)) return BranchEnd::unbounded;
      if (branch.events.size() > events) brancher_->refresh(*next);
      return std::nullopt;
    }
    return BranchEnd::degenerate;
  }
  /// \param share  of the reach of the series
  Real farthest(const Real& share) const {
    using std::min;
    return min(Real(share * series_.reach), Real(1) / Real(2));
  }

  /// Whether a stride stays on its branch; the horizon is then that of its end.
  bool sure(const BranchPoint<Real>& here, const BranchPoint<Real>& next, const Real& h) {
    const std::size_t a = here.negative_directions, b = next.negative_directions;
    if (orientation(here) != orientation(next) || (a > b ? a - b : b - a) > 1) return false;
    const Horizon ahead = brancher_->horizon(next, 4);
    if (horizon_.distance + ahead.distance < h) return false;
    horizon_ = ahead;
    if (horizon_.distance > Real(4) * tried_) tried_ = std::numeric_limits<Real>::max();
    return true;
  }

  static Variation<Real> chord(const BranchPoint<Real>& a, const BranchPoint<Real>& b) {
    return {b.theta - a.theta, {b.force.x - a.force.x, b.force.y - a.force.y}, b.load - a.load};
  }
  /// Whether the series passes a point, beside the way to there.
  bool meets(const Real& s, const BranchPoint<Real>& point) {
    using std::sqrt;
    return brancher_->length(chord(brancher_->along(series_, s), point)) < sqrt(sqrt(epsilon<Real>())) * s;
  }

  /// Over a simple bifurcation ahead, if there is one and it is on this branch.
  bool cross(Branch<Real>& branch, const BranchPoint<Real>& here) {
    using std::abs, std::min;
    const Real guess = horizon_.ahead, straight = Real(99) / Real(100);
    if (!(guess > Real(0) && guess < farthest(Real(2)) && guess < tried_ / Real(2))) return false;
    tried_ = guess;
    auto found =
        BifurcationSolver<Model>(*brancher_).near(brancher_->along(series_, guess), horizon_.direction);
    if (!found || !found->simple()) return false;
    const Real s = brancher_->product(chord(here, found->point), here.tangent);
    if (!(s > Real(0) && s < farthest(Real(2)) && meets(s, found->point)) || outside(found->point.load))
      return false;
    const Variation<Real> along = brancher_->along(series_, s).tangent;
    const auto agrees = [&](const Variation<Real>& t) { return brancher_->product(along, t); };
    const std::size_t mine = abs(agrees(found->tangents[0])) > abs(agrees(found->tangents[1])) ? 0 : 1;
    Variation<Real> tangent = found->tangents[mine];
    if (agrees(tangent) < Real(0)) Brancher<Model>::scale(tangent, Real(-1));
    if (!(agrees(tangent) > straight)) return false;
    brancher_->describe_singular(found->point, tangent);
    found->point.stiffness = series_.stiffness(s);
    found->point.negative_directions = here.negative_directions;  // in between, rounding alone would decide
    std::optional<BranchPoint<Real>> beyond;
    for (Real hop = Real(1) / Real(20); !beyond && hop > min(s, Real(1) / Real(20)) / Real(16);
         hop /= Real(4)) {
      beyond = brancher_->step(found->point, hop);
      if (beyond && orientation(*beyond) == orientation(here)) beyond.reset();
    }
    if (!beyond) return false;
    crossing_ = s;
    const Laid laid = lay(branch, here.negative_directions, found->point, Real(0), s);
    crossing_.reset();
    if (laid != Laid::whole) return false;
    branch.events.push_back(
        {EventKind::bifurcation, branch.points.size() - 2, found->point, found->tangents[1 - mine]});
    brancher_->refresh(*beyond);
    horizon_ = brancher_->horizon(*beyond, 8);
    tried_ = std::numeric_limits<Real>::max();
    brancher_->expand(*beyond, series_);
    const Real from = brancher_->product(chord(*beyond, found->point), beyond->tangent);
    crossing_ = from;
    lay(branch, beyond->negative_directions, *beyond, from, Real(0));
    crossing_.reset();
    brancher_->refresh(*beyond);
    return true;
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

  enum class Laid : std::uint8_t {
    whole,
    left,   ///< the branch leaves the load window; it ends at the edge
    unsure  ///< the load turns twice, or a point is not found: nothing was laid
  };

  /// The points of a stride over (from, to], evenly spaced, the last one given, with the events between them.
  /// \param type  negative directions up to a fold; behind, those of the last point
  Laid lay(Branch<Real>& branch, std::size_t type, const BranchPoint<Real>& last, const Real& from,
           const Real& to) {
    using std::ceil;
    const std::size_t points = branch.points.size(), events = branch.events.size();
    const auto count = static_cast<int>(ceil((to - from) / limits_.longest));
    bool turned = false;
    Place before = place(from);
    for (int i = 1; i <= count; ++i) {
      const Real s = i < count ? Real(from + (to - from) * Real(i) / Real(count)) : to;
      std::optional<BranchPoint<Real>> point = i < count ? point_at(s) : last;
      const Place here = i < count ? place_at_hand(s) : place(s);
      const bool turns = (before.turn > Real(0)) != (here.turn > Real(0));
      if (!point || (turns && turned)) {
        branch.points.resize(points);
        branch.events.resize(events);
        return Laid::unsure;
      }
      if (outside(point->load)) return leave(branch, before, here);
      note_event(branch, before, here);
      turned = turned || turns;
      if (i < count) point->negative_directions = turned ? last.negative_directions : type;
      branch.points.push_back(std::move(*point));
      before = here;
    }
    return Laid::whole;
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
      if (crossing_ && abs(s - *crossing_) < (b.s - a.s) / Real(1000)) return;
      auto found = located(branch, EventKind::fold, s);
      if (!found) throw Error("branch", "a fold that cannot be located", "a regular branch around it");
      branch.events.push_back({EventKind::fold, branch.points.size() - 1, std::move(*found), {}});
    } else if (a.bend < Real(0) && b.bend > Real(0)) {
      const Real s = zero([this](const Real& at) { return place(at).bend; }, a.s, b.s);
      auto found = located(branch, EventKind::quasi_buckling, s);
      // where the bend is all rounding, as beside a crossing, its sign means nothing
      if (!found || (found->load > a.load) == (found->load > b.load)) return;
      branch.events.push_back({EventKind::quasi_buckling, branch.points.size() - 1, std::move(*found), {}});
    }
  }
  std::optional<BranchPoint<Real>> located(const Branch<Real>& branch, EventKind kind, const Real& s) {
    BranchPoint<Real> near = brancher_->along(series_, s);
    near.negative_directions = branch.points.back().negative_directions;
    return locate(*brancher_, kind, std::move(near));
  }

  /// The last point, at the edge of the load window.
  Laid leave(Branch<Real>& branch, const Place& inside, const Place& beyond) {
    const Real& edge = beyond.load > limits_.to ? limits_.to : limits_.from;
    if (!outside(inside.load) && inside.load != edge) {
      const Real s = zero([&](const Real& at) { return Real(place(at).load - edge); }, inside.s, beyond.s);
      auto last = brancher_->at_load(brancher_->along(series_, s), edge);
      note_event(branch, inside, place(s));
      if (last) branch.points.push_back(std::move(*last));
    }
    return Laid::left;
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
  Series series_;
  Horizon horizon_;
  Real tried_;  ///< the nearest crossing that was looked for and not found: to look again only when nearer
  std::optional<Real> crossing_;  ///< a bifurcation on the stride: the load may turn there, without a fold
};

}  // namespace plumbline
