#include "proofs/paths/structure_equations.hpp"

#include <plumbline/structure/implied_holds.hpp>

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {
namespace {

Span enclosed_span(const Rational& x) {
  return Span(Interval(x));
}

}  // namespace

StructureEquations::StructureEquations(const Structure<Rational>& structure)
    : first_(structure.base.turn.is_held() ? 1 : 0),
      turn_(end_turn(structure).hold),
      turn_stiffness_(enclosed_span(end_turn(structure).stiffness)),
      moment_(enclosed_span(structure.moment)) {
  structure.require_sound();
  if (structure.follower()) throw Error("load", "a follower force, which has no energy", "dead loads");
  const std::size_t n = structure.chain.size();
  Span direction(0), along(0), across(0);
  for (std::size_t i = 0; i < n; ++i) {
    length_.push_back(enclosed_span(structure.chain.length()[i]));
    stiffness_.push_back(enclosed_span(structure.chain.stiffness()[i]));
    rest_.push_back(enclosed_span(structure.chain.rest()[i]));
    slack_.push_back(direction += rest_.back());
  }
  const std::vector<bool> implied = implied_across(structure);
  for (std::size_t node = 1; node <= n; ++node) {
    if (!implied[node]) add_spring(node, 1, structure.across_at(node));
  }
  add_spring(n, 0, structure.end_point.along);
  for (Spring& spring : springs_) {
    for (std::size_t i = 0; i < spring.node; ++i) {
      const auto [c, s] = circle(slack_[i]);
      spring.slack += length_[i] * (spring.coordinate == 0 ? c : s);
    }
  }
  if (turn_ == Hold::held) ++held_;
  for (const int coordinate : {0, 1}) {
    const Restraint<Rational>& base = coordinate == 0 ? structure.base.along : structure.base.across;
    if (!base.is_held()) slides_.push_back({0, coordinate, false, enclosed_span(base.stiffness), Span(0)});
  }
  for (const Load<Rational>& load : structure.loads)
    loads_.push_back({load.node, enclosed_span(load.force.x), enclosed_span(load.force.y), load.multiplied});
}

void StructureEquations::add_spring(std::size_t node, int coordinate, const Restraint<Rational>& restraint) {
  if (restraint.is_free()) return;
  springs_.push_back({node, coordinate, restraint.is_held(), enclosed_span(restraint.stiffness), Span(0)});
  if (restraint.is_held()) ++held_;
}

Vector<Span> StructureEquations::at(const BentStructure<double>& model,
                                    const BentPoint<double>& point) const {
  Vector<Span> u(unknowns());
  const std::vector<double> q = model.angles(point.x);
  double direction = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    direction += q[i];
    if (i >= first_) u(static_cast<Eigen::Index>(i - first_)) = direction;
  }
  const auto slides = static_cast<Eigen::Index>(slides_.size());
  u.segment(moving() - slides, slides) = point.x.tail(slides).cast<Span>();
  u.segment(moving(), held_) = point.multiplier.cast<Span>();
  u(unknowns() - 1) = point.factor;
  return u;
}

std::vector<HyperDual> StructureEquations::directions(const Unknowns& u) const {
  std::vector<HyperDual> theta;
  for (std::size_t i = 0; i < length_.size(); ++i)
    theta.push_back(i < first_ ? HyperDual(slack_[i]) : u[i - first_]);
  return theta;
}

std::vector<StructureEquations::Place> StructureEquations::places(const Unknowns& u,
                                                                  const std::vector<HyperDual>& theta) const {
  Place p;
  for (std::size_t s = 0; s < slides_.size(); ++s)
    p.along(slides_[s].coordinate) = u[theta.size() - first_ + s];
  std::vector<Place> place{p};
  for (std::size_t i = 0; i < theta.size(); ++i) {
    const auto [c, s] = circle(theta[i]);
    p.x += c * length_[i];
    p.y += s * length_[i];
    place.push_back(p);
  }
  return place;
}

std::vector<StructureEquations::Place> StructureEquations::pulls(const Unknowns& u, std::vector<Place>& place,
                                                                 std::vector<HyperDual>& held) const {
  std::vector<Place> pull(place.size());
  const HyperDual& factor = u.back();
  for (const Dead& load : loads_) {
    const HyperDual share = load.multiplied ? factor : HyperDual(Span(1));
    pull[load.node].x += share * load.x;
    pull[load.node].y += share * load.y;
  }
  for (const Spring& spring : springs_) {
    const HyperDual off = place[spring.node].along(spring.coordinate) - spring.slack;
    HyperDual& here = pull[spring.node].along(spring.coordinate);
    if (spring.held) {
      here += u[static_cast<std::size_t>(moving()) + held.size()];
      held.push_back(off);
    } else {
      here -= off * spring.stiffness;
    }
  }
  return pull;
}

std::vector<HyperDual> StructureEquations::equations(const Unknowns& u) const {
  const std::size_t n = length_.size();
  const std::vector<HyperDual> theta = directions(u);
  std::vector<Place> place = places(u, theta);
  std::vector<HyperDual> held;
  const std::vector<Place> pull = pulls(u, place, held);
  HyperDual moment = u.back() * moment_;
  const HyperDual turned = theta.back() - slack_.back();
  if (turn_ == Hold::held) {
    moment += u[static_cast<std::size_t>(moving()) + held.size()];
    held.push_back(turned);
  } else {
    moment -= turned * turn_stiffness_;
  }
  std::vector<HyperDual> residual(n);
  Place beyond;
  for (std::size_t i = n; i-- > 0;) {
    beyond.x += pull[i + 1].x;
    beyond.y += pull[i + 1].y;
    const auto [c, s] = circle(theta[i]);
    const HyperDual bend =
        (theta[i] - (i > 0 ? theta[i - 1] : HyperDual(Span(0))) - rest_[i]) * stiffness_[i];
    residual[i] += bend + (beyond.x * s - beyond.y * c) * length_[i];
    if (i > 0) residual[i - 1] -= bend;
  }
  residual.back() -= moment;
  residual.erase(residual.begin(), residual.begin() + static_cast<std::ptrdiff_t>(first_));
  beyond.x += pull[0].x;
  beyond.y += pull[0].y;
  for (const Spring& slide : slides_)
    residual.push_back(place[0].along(slide.coordinate) * slide.stiffness - beyond.along(slide.coordinate));
  residual.insert(residual.end(), held.begin(), held.end());
  return residual;
}

Vector<Span> StructureEquations::value(const Vector<Span>& u) {
  const std::vector<HyperDual> E = equations(Unknowns(u.begin(), u.end()));
  Vector<Span> result = Vector<Span>::Constant(u.size(), Span(0));
  for (std::size_t i = 0; i < E.size(); ++i) result(static_cast<Eigen::Index>(i)) = E[i].value;
  return result;
}

Matrix<Span> StructureEquations::derivative(const Vector<Span>& u, const Vector<Span>& normal) {
  Matrix<Span> M = Matrix<Span>::Constant(u.size(), u.size(), Span(0));
  Unknowns moved(u.begin(), u.end());
  for (std::size_t j = 0; j < moved.size(); ++j) {
    moved[j].first = Span(1);
    const std::vector<HyperDual> E = equations(moved);
    for (std::size_t i = 0; i < E.size(); ++i)
      M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = E[i].first;
    moved[j].first = Span(0);
  }
  M.row(u.size() - 1) = normal.transpose();
  return M;
}

Vector<Span> StructureEquations::second(const Vector<Span>& u, const Vector<Span>& v, const Vector<Span>& w) {
  Unknowns moved;
  for (Eigen::Index i = 0; i < u.size(); ++i) moved.emplace_back(u(i), v(i), w(i), Span(0));
  const std::vector<HyperDual> E = equations(moved);
  Vector<Span> result = Vector<Span>::Constant(u.size(), Span(0));
  for (std::size_t i = 0; i < E.size(); ++i) result(static_cast<Eigen::Index>(i)) = E[i].both;
  return result;
}

std::optional<std::size_t> StructureEquations::negative_directions(const Vector<Span>& u) {
  const Matrix<Span> M = derivative(u, Vector<Span>::Constant(u.size(), Span(0)));
  Matrix<Span> K = Matrix<Span>::Constant(u.size() - 1, u.size() - 1, Span(0));
  const Eigen::Index m = moving();
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index i = j; i < m; ++i) K(i, j) = K(j, i) = M(i, j);
    for (Eigen::Index a = m; a < K.rows(); ++a) K(a, j) = K(j, a) = M(a, j);
  }
  const auto negative = negative_eigenvalues(K);  // where K is regular each of what is held adds one
  if (!negative) return std::nullopt;
  return *negative - static_cast<std::size_t>(held_);
}

}  // namespace plumbline::proofs
