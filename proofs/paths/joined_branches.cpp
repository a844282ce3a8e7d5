#include "proofs/paths/joined_branches.hpp"

#include "proofs/paths/measures.hpp"
#include "proofs/paths/pitchfork.hpp"
#include "proofs/paths/unfolding.hpp"

namespace plumbline::proofs {
namespace {

constexpr double same_crossing = 1e-6;  ///< what two branches say of one bifurcation differs by less

class Joiner {
 public:
  Joiner(JoinedBranches& all, bool history) : all_(&all), history_(history) {}

  /// The gap, and all others around the same bifurcation, closed by one fork.
  bool close(std::size_t branch, const Gap& gap, const Chain<Interval>& chain,
             const Loading<Interval>& loading, const std::vector<Symmetry>& symmetries) {
    const std::vector<EndOfPiece> ends = ends_around(gap, branch);
    std::vector<PieceEnd> places;
    for (const EndOfPiece& end : ends) places.push_back(place(end));
    for (const Symmetry& symmetry : symmetries) {
      const auto fork = pitchfork(chain, loading, symmetry, gap.crossing, places);
      if (!fork) continue;
      ProvedFork proved{fork->load * Span(load_unit(chain, loading.control)), symmetry, {}, {}};
      for (const std::size_t i : fork->symmetric) proved.symmetric.push_back(ends[i]);
      for (const std::size_t i : fork->bent) proved.bent.push_back(ends[i]);
      if (!remove_closed(gap, proved)) continue;
      all_->forks.push_back(std::move(proved));
      return true;
    }
    return false;
  }

  /// How far the ends of a gap are from what it is around.
  [[nodiscard]] double reach(std::size_t branch, const Gap& gap) const {
    double farthest = 0;
    for (const EndOfPiece& end : ends_of(branch, gap)) {
      const PieceEnd there = place(end);
      farthest = std::max(farthest, (there.point - gap.crossing).cwiseAbs().maxCoeff() + there.distance);
    }
    return farthest;
  }

 private:
  static bool same(const EndOfPiece& a, const EndOfPiece& b) {
    return a.branch == b.branch && a.piece == b.piece && a.last == b.last;
  }

  [[nodiscard]] PieceEnd place(const EndOfPiece& end) const {
    const ProvedPiece& piece = all_->branches[end.branch].pieces[end.piece];
    return {end.last ? piece.points.back() : piece.points.front(), piece.distance};
  }

  /// On the sides of a gap; where the slowly loaded chain leaves its branch, the beginning of the next one.
  [[nodiscard]] std::vector<EndOfPiece> ends_of(std::size_t branch, const Gap& gap) const {
    std::vector<EndOfPiece> ends;
    if (gap.before) ends.push_back({branch, *gap.before, true});
    if (gap.after) ends.push_back({branch, *gap.after, false});
    const bool leaves = history_ && !gap.after && branch + 1 < all_->branches.size();
    if (leaves && !all_->branches[branch + 1].pieces.empty()) ends.push_back({branch + 1, 0, false});
    return ends;
  }

  [[nodiscard]] static bool near(const Gap& a, const Gap& b) {
    return (a.crossing - b.crossing).cwiseAbs().maxCoeff() < same_crossing;
  }

  [[nodiscard]] std::vector<EndOfPiece> ends_around(const Gap& gap, std::size_t branch) const {
    std::vector<EndOfPiece> ends = ends_of(branch, gap);
    for (std::size_t b = 0; b < all_->branches.size(); ++b) {
      for (const Gap& other : all_->branches[b].gaps) {
        if (!near(gap, other)) continue;
        for (const EndOfPiece& end : ends_of(b, other)) {
          if (std::none_of(ends.begin(), ends.end(), [&](const auto& known) { return same(known, end); }))
            ends.push_back(end);
        }
      }
    }
    return ends;
  }

  /// Removes the gaps around a bifurcation all ends of which are joined; whether there is one.
  bool remove_closed(const Gap& gap, const ProvedFork& fork) {
    bool any = false;
    for (std::size_t b = 0; b < all_->branches.size(); ++b) {
      const auto closed = [&](const Gap& other) {
        if (!near(gap, other)) return false;
        const auto ends = ends_of(b, other);
        return !ends.empty() && std::all_of(ends.begin(), ends.end(), [&](const EndOfPiece& end) {
          const auto is = [&](const EndOfPiece& joined) { return same(joined, end); };
          return std::any_of(fork.symmetric.begin(), fork.symmetric.end(), is) ||
                 std::any_of(fork.bent.begin(), fork.bent.end(), is);
        });
      };
      any = std::erase_if(all_->branches[b].gaps, closed) > 0 || any;
    }
    return any;
  }

  JoinedBranches* all_;
  bool history_;
};

}  // namespace

JoinedBranches certify(const PathReport& report, const Chain<Interval>& chain,
                       const Loading<Interval>& loading, const std::vector<Symmetry>& symmetries,
                       ProvedPoints points) {
  JoinedBranches all;
  // A pitchfork closes wide gaps, too, and next to it tubes are hard to prove, of rounded points above all.
  const double gap = symmetries.empty() && points == ProvedPoints::as_followed ? 1e-5 : 1e-3;
  for (const Branch<double>& branch : report.branches)
    all.branches.push_back(certify(chain, loading, branch, points, gap));
  Joiner joiner(all, report.history);
  for (std::size_t b = 0; b < all.branches.size(); ++b) {
    for (std::size_t i = 0; i < all.branches[b].gaps.size();) {
      const Gap open = all.branches[b].gaps[i];
      if (joiner.close(b, open, chain, loading, symmetries)) continue;
      all.branches[b].gaps[i].unfolded = unfolded(chain, loading, open.crossing, joiner.reach(b, open));
      ++i;
    }
  }
  return all;
}

}  // namespace plumbline::proofs
