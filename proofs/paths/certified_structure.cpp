#include "proofs/paths/certified_structure.hpp"

#include "proofs/paths/regular_tube.hpp"
#include "proofs/paths/structure_equations.hpp"

namespace plumbline::proofs {
namespace {

using Equilibrium = BentPoint<double>;

constexpr double finest = 1e-5;      ///< a longer segment is halved where the factor may turn
constexpr double on_curve = 1e-6;    ///< farther from the curve a point is none of it
constexpr double same_place = 1e-9;  ///< nearer to each other points are one
constexpr std::size_t most_tubes = 4000;

/// A tube and which way the factor goes in it.
struct StructureSegment {
  Vector<Span> normal;
  Tube tube;
  Span factor;
  int way, bend;  ///< signs of the factor's change, 0 where it may vanish, and then of its second derivative
};

class StructureProver {
 public:
  StructureProver(const Structure<Rational>& structure, double last)
      : model_(bent_structure(from_rational<double>(structure))),
        solver_(model_),
        equations_(structure),
        last_(last) {}

  StructureCertificate run(const BentBranch<double>& branch, double gap);

 private:
  [[nodiscard]] double length(const Equilibrium& a, const Equilibrium& b) const {
    const double turn = (b.x - a.x).squaredNorm() / static_cast<double>(a.x.size());
    return std::hypot(std::sqrt(turn), (b.factor - a.factor) / last_);
  }
  std::optional<Equilibrium> across(const Equilibrium& guess, const Equilibrium& a, const Equilibrium& b);
  std::optional<Equilibrium> between(const Equilibrium& a, const Equilibrium& b);
  std::vector<std::vector<Equilibrium>> pieces(const BentBranch<double>& branch, double gap);
  std::optional<StructureSegment> segment(const Equilibrium& a, const Equilibrium& b);
  int way_at(const Vector<Span>& point, const Vector<Span>& normal, const Tube& tube);
  bool join(const Equilibrium& at, const StructureSegment& before, const StructureSegment& after);
  bool account(const StructureSegment& segment, double factor);
  bool settle(int way, double factor);
  bool prove(std::vector<Equilibrium> points);
  bool fail(const Span& factor, std::string why) {
    result_.failed_at = factor;
    result_.failure = std::move(why);
    return false;
  }

  BentStructure<double> model_;
  BentSolver<double> solver_;
  StructureEquations equations_;
  double last_;
  StructureCertificate result_;
  std::size_t tubes_ = 0;  ///< that were tried

  // the piece at hand
  int way_ = 0;
  bool typed_ = false;
  int bend_ = 0;  ///< of a stretch in which the factor may turn
  Span turning_;  ///< factors there
};

/// The equilibrium in the plane across the chord from a to b through a guess.
std::optional<Equilibrium> StructureProver::across(const Equilibrium& guess, const Equilibrium& a,
                                                   const Equilibrium& b) {
  auto row = solver_.keep_factor();
  row.x = (b.x - a.x) / static_cast<double>(a.x.size());
  row.factor = (b.factor - a.factor) / (last_ * last_);
  return solver_.correct(guess, row, 10);
}

std::optional<Equilibrium> StructureProver::between(const Equilibrium& a, const Equilibrium& b) {
  const double whole = length(a, b);
  if (!(whole > 4 * same_place)) return std::nullopt;
  Equilibrium guess = a;
  guess.x = (a.x + b.x) / 2;
  guess.multiplier = (a.multiplier + b.multiplier) / 2;
  guess.factor = (a.factor + b.factor) / 2;
  auto middle = across(guess, a, b);
  if (!middle || length(a, *middle) > 0.75 * whole || length(*middle, b) > 0.75 * whole) return std::nullopt;
  return middle;
}

/// The points between bifurcations, each piece as near to these as `gap`.
std::vector<std::vector<Equilibrium>> StructureProver::pieces(const BentBranch<double>& branch, double gap) {
  std::vector<std::vector<Equilibrium>> all(1);
  std::size_t next = 0;
  const auto near = [&](const Equilibrium& crossing, const Equilibrium& from) {
    Equilibrium guess = crossing;
    const double share = gap / length(crossing, from);
    guess.x += share * (from.x - crossing.x);
    guess.multiplier += share * (from.multiplier - crossing.multiplier);
    guess.factor += share * (from.factor - crossing.factor);
    return across(guess, crossing, from).value_or(from);
  };
  for (const auto& event : branch.events) {
    if (event.kind != BentEventKind::bifurcation) continue;
    std::size_t end = std::min(event.before, branch.points.size()), after = end;
    while (end > next && length(branch.points[end - 1], event.point) < 2 * gap) --end;
    while (after < branch.points.size() && length(branch.points[after], event.point) < 2 * gap) ++after;
    while (next < end) all.back().push_back(branch.points[next++]);
    Span open(event.point.factor);
    if (!all.back().empty()) {
      all.back().push_back(near(event.point, all.back().back()));
      open = hull(open, Span(all.back().back().factor));
    }
    all.emplace_back();
    if (after < branch.points.size()) {
      all.back().push_back(near(event.point, branch.points[after]));
      open = hull(open, Span(all.back().back().factor));
    }
    result_.gaps.push_back(open);
    next = after;
  }
  while (next < branch.points.size()) all.back().push_back(branch.points[next++]);
  return all;
}

std::optional<StructureSegment> StructureProver::segment(const Equilibrium& a, const Equilibrium& b) {
  const Vector<Span> from = equations_.at(model_, a), to = equations_.at(model_, b);
  const Eigen::Index size = equations_.unknowns(), moving = equations_.moving();
  StructureSegment found;
  found.normal = Vector<Span>::Constant(size, Span(0));
  for (Eigen::Index i = 0; i < moving; ++i)
    found.normal(i) = (to(i) - from(i)).middle() / static_cast<double>(moving);
  found.normal(size - 1) = (b.factor - a.factor) / (last_ * last_);
  const double largest = found.normal.unaryExpr(magnitude_of).maxCoeff();
  for (Span& x : found.normal) x = x.middle() / largest;
  auto tube = tube_along(equations_, from, to, found.normal);
  if (!tube) return std::nullopt;
  const Vector<Span> everywhere = widened(hull(from, to), tube->image), first = tangent(*tube);
  found.factor = everywhere(size - 1);
  found.way = sign(first(size - 1));
  if (found.way == 0) {  // 0 = E' u'' + E'' u' u'
    const Vector<Span> right = equations_.second(everywhere, first, first);
    found.bend = sign(solve(*tube, -product(tube->inverse, right))(size - 1));
    if (found.bend == 0) return std::nullopt;
    // u' of the factor goes one way: with one sign at both ends it has that sign all along
    const int start = way_at(from, found.normal, *tube), end = way_at(to, found.normal, *tube);
    if (start == end && start != 0) found.way = start, found.bend = 0;
  } else {
    found.bend = 0;
  }
  found.tube = std::move(*tube);
  return found;
}

/// Which way the factor goes where a tube's curve passes the plane through a point; 0 where it is open.
int StructureProver::way_at(const Vector<Span>& point, const Vector<Span>& normal, const Tube& tube) {
  const auto box = tube_at(equations_, point, normal);
  if (!box || (box->image.array() > tube.radius.array()).any()) return 0;
  return sign(tangent(*box)(equations_.unknowns() - 1));
}

/// Whether both segments are the same curve at a point, which is near it; what is known of the point.
bool StructureProver::join(const Equilibrium& at, const StructureSegment& before,
                           const StructureSegment& after) {
  const Vector<Span> point = equations_.at(model_, at);
  const auto box = tube_at(equations_, point, hull(before.normal, after.normal));
  if (!box || (box->image.array() > before.tube.radius.array()).any() ||
      (box->image.array() > after.tube.radius.array()).any())
    return false;
  const double distance = box->image.head(equations_.moving()).maxCoeff();
  if (distance > on_curve) return false;
  result_.distance = std::max(result_.distance, distance);
  const int way = sign(tangent(*box)(equations_.unknowns() - 1));
  if (way == 0) return true;
  if (!settle(way, at.factor)) return false;
  if (typed_) return true;
  if (const auto negative = equations_.negative_directions(widened(point, box->image))) {
    result_.runs.back().negative_directions = *negative;
    typed_ = true;
  }
  return true;
}

/// The factor is known to go one way at a place.
bool StructureProver::settle(int way, double factor) {
  if (way != way_) {
    if (way_ != 0) {
      if (!typed_) return fail(factor, "the type of the equilibria stays open");
      result_.folds.push_back(turning_);
    } else if (bend_ != 0) {
      return fail(turning_, "whether the factor turns stays open");
    }
    result_.runs.push_back({factor, factor, 0});
    typed_ = false;
    way_ = way;
  }
  result_.runs.back().to = factor;
  bend_ = 0;
  return true;
}

bool StructureProver::account(const StructureSegment& segment, double factor) {
  ++result_.segments;
  result_.tube = std::max(result_.tube, segment.tube.image.head(equations_.moving()).maxCoeff());
  if (segment.way != 0) return settle(segment.way, factor);
  if (bend_ != 0 && bend_ != segment.bend) return fail(segment.factor, "whether the factor turns stays open");
  turning_ = bend_ != 0 ? hull(turning_, segment.factor) : segment.factor;
  bend_ = segment.bend;
  return true;
}

/// One curve through all the points.
bool StructureProver::prove(std::vector<Equilibrium> points) {
  way_ = bend_ = 0;
  typed_ = false;
  std::reverse(points.begin(), points.end());
  Equilibrium here = points.back();
  points.pop_back();
  std::optional<StructureSegment> last;
  while (!points.empty()) {
    const Equilibrium there = points.back();
    const double whole = length(here, there);
    if (!(whole > same_place)) {
      points.pop_back();
      continue;
    }
    if (++tubes_ > most_tubes)
      return fail(here.factor,
                  "no end after " + std::to_string(most_tubes) + " tubes: the steps are too short");
    auto next = segment(here, there);
    const bool shorter = !next || (next->way == 0 && whole > finest);
    if (!shorter && join(here, last ? *last : *next, *next)) {
      if (!account(*next, here.factor)) return false;
      last = std::move(next);
      here = there;
      points.pop_back();
      continue;
    }
    if (!result_.certified()) return false;
    auto middle = between(here, there);
    if (!middle)
      return fail(hull(Span(here.factor), Span(there.factor)),
                  "no tube that holds one regular branch: another may touch or cross it");
    points.push_back(*std::move(middle));
  }
  if (!last) return true;
  if (!join(here, *last, *last))
    return result_.certified() ? fail(here.factor, "a point that is not on the branch") : false;
  if (bend_ != 0) return fail(turning_, "whether the factor turns stays open");
  if (!typed_) return fail(here.factor, "the type of the equilibria stays open");
  result_.runs.back().to = here.factor;
  return true;
}

StructureCertificate StructureProver::run(const BentBranch<double>& branch, double gap) {
  for (auto& piece : pieces(branch, gap)) {
    if (!piece.empty() && !prove(std::move(piece))) break;
  }
  if (result_.certified() && result_.segments == 0)
    fail(branch.points.at(0).factor, "a single point shows no branch");
  return std::move(result_);
}

}  // namespace

StructureCertificate certify(const Structure<Rational>& structure, const BentBranch<double>& branch,
                             double last, double gap) {
  return StructureProver(structure, last).run(branch, gap);
}

}  // namespace plumbline::proofs
