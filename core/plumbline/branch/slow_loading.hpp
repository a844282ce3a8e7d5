#pragma once
/// \file
/// What a slowly loaded chain really does: it follows its stable branch, and where stability ends it jumps,
/// to where the energy flows.
///
/// \code{.cpp}
/// // A link that leans to one side under a compression above k / L, pushed to the other side, snaps over.
/// const NominalModel<double> model(Chain<double>({1}, {1}));
/// const Loading<double> aside{Control::force, {-1.5, 0}, {0, 1}};
/// Brancher<NominalModel<double>> brancher(model, aside, absolute_angles(std::vector{0.0}));
/// const auto start = brancher.start(-1, absolute_angles(std::vector{-1.5}));
/// const auto history = load_slowly(brancher, start, {.from = -1, .to = 1});
/// assert(history.size() == 2);  // up to the snap, and from there
/// assert(history[0].points.back().theta(0) < 0 && history[1].points.front().theta(0) > 0);
/// \endcode

#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/settle.hpp>

namespace plumbline {

namespace detail {

/// The part of a branch before stability is lost.
/// \return whether it was lost
template <Number Real>
bool cut_where_unstable(Branch<Real>& branch) {
  std::size_t end = 0;
  while (end < branch.points.size() && branch.points[end].negative_directions == 0) ++end;
  if (end == branch.points.size()) return false;
  branch.points.resize(end);
  branch.end = BranchEnd::unstable;
  std::erase_if(branch.events, [end](const BranchEvent<Real>& event) { return event.before >= end; });
  if (!branch.events.empty() && branch.events.back().kind != EventKind::quasi_buckling &&
      branch.events.back().before + 1 == end) {
    branch.points.push_back(branch.events.back().point);
  }
  return true;
}

}  // namespace detail

/// The history under a load that grows slowly from the load of `start`, a stable point, to the end of the
/// window. At a fold the chain jumps to where the energy flows. At a bifurcation it leaves to the side of the
/// given sign (of the first angle of the shape that takes over), for in symmetry no side is preferred; on the
/// new branch it goes on without a jump where that is stable, else it flows from there.
/// \throws Error where
/// the start is unstable or no equilibrium is reached
template <SmoothModel Model>
std::vector<Branch<typename Model::Real>> load_slowly(Brancher<Model>& brancher,
                                                      const BranchPoint<typename Model::Real>& start,
                                                      const TraceLimits<typename Model::Real>& limits,
                                                      int side = 1) {
  using Real = typename Model::Real;
  if (start.negative_directions > 0) throw Error("slow loading", "an unstable start", "a stable one");
  const Real nudge = Real(1) / Real(1000);  // radians
  std::vector<Branch<Real>> history;
  BranchPoint<Real> from = start;
  for (int stretch = 0; stretch < 64; ++stretch) {
    if (from.tangent.load < Real(0)) Brancher<Model>::scale(from.tangent, Real(-1));
    Branch<Real> branch = Tracer<Model>(brancher, limits).run(from);
    const bool lost = detail::cut_where_unstable(branch);
    history.push_back(branch);
    if (!lost) return history;
    BranchPoint<Real> last = branch.points.back();
    if (!branch.events.empty() && branch.events.back().kind == EventKind::bifurcation) {
      Variation<Real> way = branch.events.back().crossing;
      if ((way.theta(0) < Real(0)) != (side < 0)) Brancher<Model>::scale(way, Real(-1));
      Brancher<Model>::move(last, way, nudge);
      last.load = branch.points.back().load;
    }
    const Real load = last.load + nudge * nudge * brancher.load_scale();
    if (load > limits.to) return history;
    const auto rest = settle(brancher.model(), brancher.loading(), load, last.theta, last.force);
    from = brancher.start(load, rest.theta, rest.force);
  }
  throw Error("slow loading", "64 jumps", "fewer");
}

}  // namespace plumbline
