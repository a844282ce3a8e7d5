#include "proofs/paths/certified_path.hpp"

#include "proofs/exact/as_double.hpp"
#include "proofs/paths/measures.hpp"
#include "proofs/paths/regular_pieces.hpp"
#include "proofs/paths/regular_tube.hpp"

namespace plumbline::proofs {

namespace {

using Model = NominalModel<double>;
using Points = std::vector<BranchPoint<double>>;

constexpr const char *turn_open = "whether the load turns stays open",
                     *type_open = "the type of the equilibria stays open";
constexpr double fine = 1e-5;  ///< a longer segment is halved around a fold, and where its stiffness is open
constexpr double nearest = 1e-6;  ///< farther from the curve a point is none of it

Point<double> middle_of(const Point<Interval>& p) {
  return {as_double(p.x), as_double(p.y)};
}

/// A tube and which way the load goes in it.
struct Segment {
  Vector<Span> normal;
  Tube tube;
  Span load;
  int way;           ///< sign of the load's change, 0 where it may vanish
  int bend;          ///< then: sign of its second derivative
  bool finite;       ///< the tangent stiffness
  int stiffness;     ///< sign of the tangent stiffness along the load, 0 where it is open
  int slope;         ///< sign of its derivative along the path, 0 where it may vanish
  int slope_change;  ///< then: sign of the second one, as it counts where the first vanishes
};

class PathProver {
 public:
  PathProver(const Chain<Interval>& chain, const Loading<Interval>& loading)
      : model_(convert<double>(chain, as_double)),
        brancher_(model_, {loading.control, middle_of(loading.start), middle_of(loading.direction)},
                  absolute_angles(model_.chain().rest())),
        equations_(chain, loading),
        scale_(Vector<double>::Ones(equations_.unknowns())) {
    const auto n = static_cast<Eigen::Index>(model_.size());
    scale_.tail(scale_.size() - n).setConstant(load_unit(chain, Control::force));
    scale_(scale_.size() - 1) = load_unit(chain, loading.control);
  }

  PathCertificate run(const Branch<double>& branch, ProvedPoints points, double gap);

 private:
  [[nodiscard]] Vector<double> shares(const BranchPoint<double>& point) const;
  [[nodiscard]] BranchPoint<double> rounded(BranchPoint<double> point) const;
  bool prove(Points points, bool closed);
  std::optional<Segment> segment(const BranchPoint<double>& a, const BranchPoint<double>& b);
  bool join(const BranchPoint<double>& at, const Segment& before, const Segment& after);
  bool account(const Segment& segment, const BranchPoint<double>& a);
  bool settle(int way, double load);
  void count(const Segment& segment);
  std::optional<BranchPoint<double>> between(const BranchPoint<double>& a, const BranchPoint<double>& b);
  /// Whether shorter segments would show more.
  [[nodiscard]] bool open(const Segment& segment) const {
    return segment.way == 0 || (result_.stiff && segment.stiffness == 0) ||
           (result_.counted && segment.slope == 0 && segment.slope_change == 0);
  }
  bool fail(const Span& load, const char* why) {
    result_.failed_at = load;
    result_.failure = why;
    return false;
  }

  Model model_;
  Brancher<Model> brancher_;
  BranchEquations equations_;
  Vector<double> scale_;  ///< of the unknowns
  ProvedPoints which_ = ProvedPoints::as_followed;
  PathCertificate result_;
  const char* obstacle_ = "";

  // the run at hand
  int way_ = 0;
  bool typed_ = false;
  struct Bend {
    int sign;
    Span load;
  };
  std::optional<Bend> bend_;
  int slope_ = 0;              ///< of the stiffness, as it was known last
  std::optional<Bend> least_;  ///< where it may since have vanished, once
};

/// The unknowns without units.
Vector<double> PathProver::shares(const BranchPoint<double>& point) const {
  Vector<double> u = scale_;
  u.head(point.theta.size()) = point.theta;
  if (u.size() > point.theta.size() + 1) u.tail<3>().head<2>() << point.force.x, point.force.y;
  u(u.size() - 1) = point.load;
  return u.cwiseQuotient(scale_);
}

BranchPoint<double> PathProver::rounded(BranchPoint<double> point) const {
  if (which_ == ProvedPoints::as_followed) return point;
  const Vector<double> u =
      shares(point).unaryExpr([](double x) { return std::round(x * 1e9) / 1e9; }).cwiseProduct(scale_);
  point.theta = u.head(point.theta.size());
  if (u.size() > point.theta.size() + 1) point.force = {u(u.size() - 3), u(u.size() - 2)};
  point.load = u(u.size() - 1);
  return point;
}

std::optional<BranchPoint<double>> PathProver::between(const BranchPoint<double>& a,
                                                       const BranchPoint<double>& b) {
  const double length = brancher_.length(chord(a, b));
  if (!(length > 4 * same_point)) return std::nullopt;  // neither part is too short
  for (const bool forwards : {true, false}) {
    const BranchPoint<double>&from = forwards ? a : b, &to = forwards ? b : a;
    const auto middle = brancher_.step(from, brancher_.product(chord(from, to), from.tangent) / 2);
    if (middle && brancher_.length(chord(a, *middle)) < 0.75 * length &&
        brancher_.length(chord(*middle, b)) < 0.75 * length)
      return rounded(*middle);
  }
  return std::nullopt;
}

std::optional<Segment> PathProver::segment(const BranchPoint<double>& a, const BranchPoint<double>& b) {
  const Variation<double> along = chord(a, b);
  const double length = brancher_.length(along);
  const Eigen::Index size = equations_.unknowns();
  Segment found;
  found.normal = Vector<Span>::Constant(size, Span(0));
  found.normal.head(along.theta.size()) = (brancher_.weighted(along.theta) / length).cast<Span>();
  found.normal(size - 1) = brancher_.load_weight() * along.load / length;
  const Vector<Span> from = equations_.at(a), to = equations_.at(b);
  auto tube = tube_along(equations_, from, to, found.normal);
  if (!tube) {
    obstacle_ = "no tube that holds one regular branch: another may touch or cross it";
    return std::nullopt;
  }
  const Vector<Span> everywhere = widened(hull(from, to), tube->image);
  const auto derivative = rates(equations_, *tube, everywhere);
  found.load = equations_.load(everywhere);
  found.way = sign(equations_.load(derivative[0]));
  found.bend = found.way == 0 ? sign(equations_.load(derivative[1])) : 0;
  if (found.way == 0 && found.bend == 0) {
    obstacle_ = turn_open;
    return std::nullopt;
  }
  const StiffnessChange change = equations_.stiffness(everywhere, derivative);
  found.finite = sign(change.way) != 0;
  found.stiffness = sign(change.value);
  found.slope = sign(change.slope);
  found.slope_change = found.slope == 0 ? sign(change.bend) : 0;
  found.tube = std::move(*tube);
  return found;
}

/// Whether both segments are the same curve at a point, which is near it; what is known of the point.
bool PathProver::join(const BranchPoint<double>& at, const Segment& before, const Segment& after) {
  const Vector<Span> point = equations_.at(at);
  const auto box = tube_at(equations_, point, hull(before.normal, after.normal));
  if (!box || (box->image.array() > before.tube.radius.array()).any() ||
      (box->image.array() > after.tube.radius.array()).any()) {
    obstacle_ = "the curves before and after may not be one";
    return false;
  }
  const double distance = box->image.head(at.theta.size()).maxCoeff();
  if (distance > nearest) {
    obstacle_ = "a point that is not on the branch";
    return false;
  }
  result_.distance = std::max(result_.distance, distance);
  double& farthest = result_.pieces.back().distance;
  farthest = std::max(farthest, (box->image.array() / scale_.array()).maxCoeff());
  const int way = sign(equations_.load(tangent(*box)));
  if (way == 0) return true;
  if (!settle(way, at.load)) return false;
  if (typed_) return true;
  if (const auto negative = equations_.negative_directions(widened(point, box->image))) {
    result_.runs.back().negative_directions = *negative;
    typed_ = true;
  }
  return true;
}

/// The load is known to go one way at a place.
bool PathProver::settle(int way, double load) {
  if (way != way_) {
    if (way_ != 0) {
      if (!typed_) return fail(load, type_open);
      result_.folds.push_back(bend_.value().load);
    } else if (bend_) {
      return fail(bend_->load, turn_open);
    }
    result_.runs.push_back({load, load, 0});
    typed_ = false;
    way_ = way;
  }
  result_.runs.back().to = load;
  bend_.reset();
  return true;
}

bool PathProver::account(const Segment& segment, const BranchPoint<double>& a) {
  ++result_.segments;
  result_.finite = result_.finite && segment.finite;
  result_.stiff = result_.stiff && segment.finite && segment.stiffness > 0;
  result_.softens = result_.softens && segment.finite && segment.slope < 0;
  count(segment);
  result_.tube = std::max(result_.tube, segment.tube.image.head(a.theta.size()).maxCoeff());
  if (segment.way != 0) return settle(segment.way, a.load);
  if (bend_ && bend_->sign != segment.bend) return fail(segment.load, turn_open);
  bend_ = Bend{segment.bend, bend_ ? hull(bend_->load, segment.load) : segment.load};
  return true;
}

/// Minima of the tangent stiffness: where its slope may vanish it is finite, and the slope only rises, or
/// only falls, through zero.
void PathProver::count(const Segment& segment) {
  if (segment.slope == 0) {
    const bool same = !least_ || least_->sign == segment.slope_change;
    if (!segment.finite || segment.slope_change == 0 || slope_ == 0 || !same) result_.counted = false;
    least_ = Bend{same ? segment.slope_change : 0, least_ ? hull(least_->load, segment.load) : segment.load};
    return;
  }
  if (least_ && least_->sign > 0 && slope_ < 0 && segment.slope > 0) result_.softest.push_back(least_->load);
  slope_ = segment.slope;
  least_.reset();
}

/// One curve through all the points.
bool PathProver::prove(Points points, bool closed) {
  way_ = 0;
  typed_ = false;
  bend_.reset();
  slope_ = 0;
  least_.reset();
  const std::size_t runs = result_.runs.size(), folds = result_.folds.size();
  for (BranchPoint<double>& point : points) point = rounded(std::move(point));
  result_.pieces.push_back({{shares(points.front())}, {}, {}, {}, 0});
  std::reverse(points.begin(), points.end());
  BranchPoint<double> here = points.back();
  points.pop_back();
  std::optional<Segment> first, last;
  while (!points.empty()) {
    const BranchPoint<double>& there = points.back();
    if (!(brancher_.length(chord(here, there)) > same_point)) {  // the same point again
      points.pop_back();
      continue;
    }
    auto next = segment(here, there);
    if (next && open(*next) && brancher_.length(chord(here, there)) > fine) {
      if (auto middle = between(here, there)) {
        points.push_back(std::move(*middle));
        continue;
      }
    }
    if (next && join(here, last ? *last : *next, *next)) {
      if (!account(*next, here)) return false;
      if (!first) first = next;
      result_.pieces.back().tubes.push_back(next->tube.image.cwiseQuotient(scale_));
      last = std::move(next);
      here = there;
      result_.pieces.back().points.push_back(shares(here));
      points.pop_back();
      continue;
    }
    if (!result_.certified()) return false;
    auto middle = between(here, there);
    if (!middle) return fail(hull(Span(here.load), Span(there.load)), obstacle_);
    points.push_back(std::move(*middle));
  }
  if (!last) {
    result_.pieces.pop_back();
    return true;
  }
  if (!join(here, *last, closed ? *first : *last))
    return result_.certified() ? fail(here.load, obstacle_) : false;
  if (bend_) return fail(bend_->load, turn_open);
  if (!typed_) return fail(here.load, type_open);
  result_.runs.back().to = here.load;
  if (least_) result_.counted = false;
  ProvedPiece& piece = result_.pieces.back();
  piece.runs.assign(result_.runs.begin() + static_cast<std::ptrdiff_t>(runs), result_.runs.end());
  for (std::size_t i = folds; i < result_.folds.size(); ++i)
    piece.folds.push_back(result_.folds[i] / Span(scale_(scale_.size() - 1)));
  return true;
}

PathCertificate PathProver::run(const Branch<double>& branch, ProvedPoints points, double gap) {
  which_ = points;
  RegularPieces pieces = regular_pieces(brancher_, branch, gap);
  const bool closed = branch.end == BranchEnd::closed && pieces.crossings.empty();
  std::vector<std::optional<std::size_t>> proved(pieces.points.size());
  for (std::size_t i = 0; i < pieces.points.size() && result_.certified(); ++i) {
    const std::size_t next = result_.pieces.size();
    if (pieces.points[i].empty() || !prove(std::move(pieces.points[i]), closed)) continue;
    if (result_.pieces.size() > next) proved[i] = next;
  }
  for (std::size_t i = 0; i < pieces.crossings.size(); ++i) {
    const Crossing& crossing = pieces.crossings[i];
    result_.gaps.push_back({crossing.loads, shares(crossing.point), proved[i], proved[i + 1], false});
  }
  if (result_.certified() && result_.segments == 0)
    fail(branch.points.at(0).load, "a single point shows no branch");
  return std::move(result_);
}

}  // namespace

bool PathCertificate::regular() const {
  return certified() && gaps.empty() && runs.size() == 1 && runs[0].negative_directions == 0 &&
         runs[0].from < runs[0].to;
}

PathCertificate certify(const Chain<Interval>& chain, const Loading<Interval>& loading,
                        const Branch<double>& branch, ProvedPoints points, double gap) {
  const Measures m = measures_of(convert<double>(chain, as_double));
  PathCertificate proved = PathProver(measured(chain, m), measured(loading, m))
                               .run(measured(branch, m, loading.control), points, gap);
  const double unit = m.load(loading.control);  // a power of two
  const auto restore = [unit](Span& loads) { loads = {loads.low * unit, loads.high * unit}; };
  for (CertifiedRun& run : proved.runs) run.from *= unit, run.to *= unit;
  for (Span& fold : proved.folds) restore(fold);
  for (Span& least : proved.softest) restore(least);
  for (Gap& around : proved.gaps) restore(around.loads);
  if (proved.failed_at) restore(*proved.failed_at);
  return proved;
}

}  // namespace plumbline::proofs
