#include "proofs/paths/regular_pieces.hpp"

namespace plumbline::proofs {

namespace {

using Points = std::vector<BranchPoint<double>>;

class Cutter {
 public:
  Cutter(Brancher<NominalModel<double>>& brancher, double gap) : brancher_(&brancher), gap_(gap) {}

  /// Replaces a last point that is a fold by one beyond it.
  void pass_fold(Points& points, const BranchPoint<double>& fold) {
    if (points.size() < 2 || distance(points.back(), fold) > same_point) return;
    const Variation<double> way = chord(points[points.size() - 2], fold);
    for (double h = brancher_->product(way, fold.tangent); std::abs(h) > same_point; h /= 2) {
      auto beyond = brancher_->step(fold, h);
      if (!beyond) continue;
      points.back() = std::move(*beyond);
      return;
    }
  }

  /// Cuts the points, all from `next` on, at a bifurcation behind points[before].
  void cut(const Points& points, std::size_t before, const BranchPoint<double>& crossing) {
    const auto close = [&](std::size_t i) { return distance(points[i], crossing) < 2 * gap_; };
    std::size_t end = std::min(before + 1, points.size()), after = end;
    while (end > next_ && close(end - 1)) --end;
    while (after < points.size() && close(after)) ++after;
    take(points, end);
    if (after == points.size() && pieces_.points.back().empty()) return;  // nothing but the bifurcation
    Points& piece = pieces_.points.back();
    const Variation<double> way =
        after < points.size() ? chord(crossing, points[after]) : chord(piece.back(), crossing);
    const double ahead = brancher_->product(way, crossing.tangent) < 0 ? -gap_ : gap_;
    Span gap(crossing.load);
    Points further;
    if (!piece.empty()) {
      if (auto last = brancher_->step(crossing, -ahead)) piece.push_back(std::move(*last));
      gap = hull(gap, Span(piece.back().load));
    }
    if (after < points.size()) {
      further.push_back(brancher_->step(crossing, ahead).value_or(points[after]));
      gap = hull(gap, Span(further.back().load));
    }
    pieces_.crossings.push_back({crossing, gap});
    pieces_.points.push_back(std::move(further));
    next_ = after;
  }

  /// Takes the points before `end` to the piece at hand.
  void take(const Points& points, std::size_t end) {
    const auto place = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
    pieces_.points.back().insert(pieces_.points.back().end(), place(next_), place(end));
    next_ = end;
  }

  RegularPieces result() { return std::move(pieces_); }

 private:
  double distance(const BranchPoint<double>& a, const BranchPoint<double>& b) const {
    return brancher_->length(chord(a, b));
  }

  Brancher<NominalModel<double>>* brancher_;
  double gap_;
  RegularPieces pieces_{{{}}, {}};
  std::size_t next_ = 0;
};

}  // namespace

Variation<double> chord(const BranchPoint<double>& a, const BranchPoint<double>& b) {
  return {b.theta - a.theta, {b.force.x - a.force.x, b.force.y - a.force.y}, b.load - a.load};
}

RegularPieces regular_pieces(Brancher<NominalModel<double>>& brancher, const Branch<double>& branch,
                             double gap) {
  Cutter cutter(brancher, gap);
  Points points = branch.points;
  if (!branch.events.empty() && branch.events.back().kind == EventKind::fold)
    cutter.pass_fold(points, branch.events.back().point);
  for (const auto& event : branch.events) {
    if (event.kind == EventKind::bifurcation) cutter.cut(points, event.before, event.point);
  }
  cutter.take(points, points.size());
  return cutter.result();
}

}  // namespace plumbline::proofs
