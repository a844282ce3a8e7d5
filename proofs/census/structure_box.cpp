#include "proofs/census/structure_box.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {
namespace {

constexpr std::size_t most_turning = 10;
constexpr double above_pi = 3.1415926535897936;

Span span_of(const Rational& x) {
  return Span(Interval(x));
}

}  // namespace

StructureBox::StructureBox(const Structure<Rational>& structure, const Rational& factor, int turns)
    : n_(structure.chain.size()), held_(structure.end_point.across.is_held()) {
  structure.require_sound();
  if (structure.follower()) throw Error("load", "a follower force, which has no energy", "dead loads");
  if (!structure.base.across.is_held() || !structure.base.along.is_held() ||
      !structure.end_point.along.is_free())
    throw Error("census", "a base that moves, or an end point held along",
                "a base that is held, an end point that is not held along");
  Span direction(0), reach(0);
  const double turn = (1 + 2 * turns) * above_pi;
  for (std::size_t i = 0; i < n_; ++i) {
    length_.push_back(span_of(structure.chain.length()[i]));
    stiffness_.push_back(span_of(structure.chain.stiffness()[i]));
    rest_.push_back(span_of(structure.chain.rest()[i]));
    direction += rest_.back();
    slack_.push_back(direction);
    turn_.push_back(Span(-turn, turn));
    reach += length_.back();
    const Restraint<Rational> across = structure.across_at(i + 1);
    spring_.push_back(across.hold == Hold::sprung ? span_of(across.stiffness) : Span(0));
    if (across.is_held() && i + 1 < n_)
      throw Error("census", "a joint between the ends held across", "springs there, or none");
  }
  fixed_.assign(n_, false);
  fixed_.front() = structure.base.turn.is_held();
  fixed_.back() = fixed_.back() || structure.end_point.turn.is_held();
  if (structure.end_point.turn.hold == Hold::sprung) end_turn_ = span_of(structure.end_point.turn.stiffness);
  moment_ = span_of(structure.moment * factor);
  fx_.assign(n_, Span(0)), fy_.assign(n_, Span(0));
  for (const Load<Rational>& load : structure.loads) {
    const Rational share = load.multiplied ? factor : Rational(1);
    for (std::size_t i = 0; i < load.node; ++i) {
      fx_[i] += span_of(share * load.force.x);
      fy_[i] += span_of(share * load.force.y);
    }
  }
  for (std::size_t i = 0; i < n_; ++i) {
    if (!fixed_[i]) unknown_.push_back(i);
  }
  if (unknown_.empty()) throw Error("census", "no link that can turn", "one or more");
  if (unknown_.size() > most_turning)
    throw Error("census", std::to_string(unknown_.size()) + " links that turn",
                "at most " + std::to_string(most_turning));
  bound_force(reach);
  y_rest_ = place_across(slack_, n_);
}

Ranges StructureBox::everything() const {
  Ranges box;
  Span direction(0);
  std::size_t next = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    direction = fixed_[i] ? slack_[i] : direction + rest_[i] + turn_[i];
    if (next < unknown_.size() && unknown_[next] == i) box.push_back(direction), ++next;
  }
  if (held_) box.emplace_back(-largest_force_, largest_force_);
  return box;
}

bool StructureBox::contract(Ranges& box) const {
  for (int pass = 0; pass < 3; ++pass) {
    const double before = size_of(box);
    if (!moments(box) || !newton(box)) return false;
    if (size_of(box) > 0.9 * before) break;
  }
  return true;
}

bool StructureBox::isolates(Ranges& box) const {
  Ranges image = box;
  if (!newton(image)) return false;
  for (std::size_t j = 0; j < size(); ++j) {
    if (!(box[j].low < image[j].low && image[j].high < box[j].high)) return false;
  }
  constexpr double wide = 1e-6;  // beyond it the energy has no sign of curvature
  for (int step = 0; step < 8; ++step) {
    Ranges next = image;
    if (!newton(next)) break;
    image = next;
  }
  box = widest(image) > wide ? narrowed(std::move(image)) : image;
  return true;
}

Ranges StructureBox::narrowed(Ranges box) const {
  constexpr int most = 300;
  constexpr double noticeable = 0.9;
  for (int step = 0; step < most; ++step) {
    Ranges next = box;
    if (!newton(next) || widest(next) < 1e-9) break;
    if (!(widest(next) < noticeable * widest(box))) {
      const std::optional<Ranges> part = part_with_root(next);
      if (!part) return next;
      next = *part;
    }
    box = std::move(next);
  }
  return box;
}

std::optional<Ranges> StructureBox::part_with_root(const Ranges& box) const {
  std::size_t side = 0;
  for (std::size_t j = 1; j < size(); ++j)
    if (box[j].width() > box[side].width()) side = j;
  for (const bool upper : {false, true}) {
    Ranges end = box, rest = box;
    const double at = upper ? box[side].high - box[side].width() / 3 : box[side].low + box[side].width() / 3;
    (upper ? end[side].low : end[side].high) = at;
    (upper ? rest[side].high : rest[side].low) = at;
    if (!contract(end)) return rest;
  }
  return std::nullopt;
}

double StructureBox::widest(const Ranges& box) {
  double width = 0;
  for (const Span& one : box) width = std::max(width, one.high - one.low);
  return width;
}

bool StructureBox::around_one(const Ranges& a, const Ranges& b) const {
  Ranges hull = widened(a, b);
  return isolates(hull);
}

Ranges StructureBox::unwound(const Ranges& box, const Ranges& like) const {
  Ranges moved = box;
  double before = 0;  // turns of the link before
  for (std::size_t i = 0, j = 0; i < n_; ++i) {
    double turns = 0;
    if (j < unknown_.size() && unknown_[j] == i) {
      turns = std::round((box[j].middle() - like[j].middle()) / (2 * above_pi));
      moved[j] = box[j] - turns * Span(Interval::pi() * Interval(2));
      ++j;
    }
    if (turns != before && stiffness_[i].high > 0) return box;
    before = turns;
  }
  return before != 0 && end_turn_.high > 0 ? box : moved;
}

Ranges StructureBox::widened(const Ranges& a, const Ranges& b) const {
  Ranges hull;
  for (std::size_t j = 0; j < size(); ++j) {
    const double low = std::min(a[j].low, b[j].low), high = std::max(a[j].high, b[j].high);
    const double margin = high - low + 1e-12 * std::max(std::abs(low), std::abs(high)) + 1e-300;
    hull.emplace_back(low - margin, high + margin);
  }
  return hull;
}

StructureEquilibrium StructureBox::described(const Ranges& box) const {
  const Ranges theta = directions(box);
  StructureEquilibrium one{angles(theta), held_ ? box.back() : Span(0), Span(0), Span(0), Span(0), {}};
  Span twice(0);
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(theta[i]);
    one.x += length_[i] * t.cosine;
    one.y += length_[i] * t.sine;
    const Span d = one.q[i] - rest_[i];
    if (!fixed_[i] || i > 0) twice += stiffness_[i] * (d * d);
    one.energy -= fx_[i] * length_[i] * t.cosine + fy_[i] * length_[i] * t.sine;
    const Span off = place_across(theta, i + 1) - place_across(slack_, i + 1);
    twice += spring_[i] * (off * off);
  }
  const Span end = theta.back() - slack_.back();
  twice += end_turn_ * (end * end);
  one.energy += 0.5 * twice - moment_ * end;
  Matrix<Span> K = derivative(box);
  if (held_) {  // symmetric: the force's column is minus the closure's row
    for (Eigen::Index i = 0; i + 1 < K.rows(); ++i) K(i, K.cols() - 1) = K(K.rows() - 1, i);
  }
  if (const auto negative = negative_eigenvalues(K); negative && *negative >= (held_ ? 1 : 0))
    one.negative_directions = *negative - (held_ ? 1 : 0);
  return one;
}

bool StructureBox::counted(const Ranges& box) const {
  const Ranges q = angles(directions(box));
  for (std::size_t i = 0; i < n_; ++i) {
    if (!fixed_[i] && intersection(q[i], rest_[i] + turn_[i]).empty()) return false;
  }
  return true;
}

Ranges StructureBox::angles(const Ranges& theta) const {
  Ranges q;
  for (std::size_t i = 0; i < n_; ++i) q.push_back(i == 0 ? theta[0] : theta[i] - theta[i - 1]);
  return q;
}

Ranges StructureBox::directions(const Ranges& box) const {
  Ranges theta = slack_;
  for (std::size_t j = 0; j < unknown_.size(); ++j) theta[unknown_[j]] = box[j];
  return theta;
}

double StructureBox::size_of(const Ranges& box) {
  double sum = 0;
  for (const Span& range : box) sum += range.width();
  return sum;
}

void StructureBox::bound_force(const Span& reach) {
  double moment = moment_.magnitude() + (end_turn_ * Span(above_pi)).magnitude();
  for (std::size_t i = 0; i < n_; ++i)
    moment += (stiffness_[i] * turn_[i]).magnitude() + (length_[i] * fx_[i]).magnitude() +
              (length_[i] * fy_[i]).magnitude() + (spring_[i] * reach * reach).magnitude();
  largest_force_ = held_ ? 100 * moment / reach.low : 0;
}

Span StructureBox::place_across(const Ranges& theta, std::size_t links) const {
  Span y(0);
  for (std::size_t i = 0; i < links; ++i) y += length_[i] * sin(theta[i]);
  return y;
}

Ranges StructureBox::passed_across(const Ranges& theta, const Span& force) const {
  Ranges across(n_);
  Span beyond = force;
  for (std::size_t i = n_; i-- > 0;) {
    beyond -= spring_[i] * (place_across(theta, i + 1) - place_across(slack_, i + 1));
    across[i] = beyond + fy_[i];
  }
  return across;
}

bool StructureBox::bind(Span& known, const Span& other) const {
  known = intersection(known, other);
  return !known.empty();
}

bool StructureBox::moments(Ranges& box) const {
  Ranges theta = directions(box);
  const Span force = held_ ? box.back() : Span(0);
  if (held_ && !(place_across(theta, n_) - y_rest_).contains(0)) return false;
  const Ranges across = passed_across(theta, force);
  Span moment = moment_ - end_turn_ * (theta.back() - slack_.back());
  for (std::size_t i = n_; i-- > 0;) {
    const Circle t = circle(theta[i]);
    if (fixed_[i]) {
      if (i + 1 == n_ && n_ > 1) {  // its direction is held by a moment that is not known
        moment = Span::everything();
        continue;
      }
      break;
    }
    moment += length_[i] * (across[i] * t.cosine - fx_[i] * t.sine);
    const Span before = i > 0 ? theta[i - 1] : Span(0);
    Span q = rest_[i] + turn_[i];
    if (!bind(q, theta[i] - before)) return false;
    if (stiffness_[i].low > 0 && !bind(q, rest_[i] + moment / stiffness_[i])) return false;
    if (!bind(theta[i], before + q)) return false;
    if (i > 0 && !fixed_[i - 1] && !bind(theta[i - 1], theta[i] - q)) return false;
    if (!bind(moment, stiffness_[i] * (q - rest_[i]))) return false;
  }
  for (std::size_t j = 0; j < unknown_.size(); ++j) box[j] = theta[unknown_[j]];
  return true;
}

Ranges StructureBox::residual(const Ranges& box) const {
  const Ranges theta = directions(box);
  const Ranges across = passed_across(theta, held_ ? box.back() : Span(0));
  Ranges all(n_, Span(0));
  for (std::size_t i = 0; i < n_; ++i) {
    const Circle t = circle(theta[i]);
    const Span torque = stiffness_[i] * ((i > 0 ? theta[i] - theta[i - 1] : theta[i]) - rest_[i]);
    all[i] += torque + length_[i] * (t.sine * fx_[i] - t.cosine * across[i]);
    if (i > 0) all[i - 1] -= torque;
  }
  all.back() += end_turn_ * (theta.back() - slack_.back()) - moment_;
  Ranges result;
  for (const std::size_t i : unknown_) result.push_back(all[i]);
  if (held_) result.push_back(place_across(theta, n_) - y_rest_);
  return result;
}

Matrix<Span> StructureBox::derivative(const Ranges& box) const {
  const Ranges theta = directions(box);
  const Ranges across = passed_across(theta, held_ ? box.back() : Span(0));
  Ranges springs_beyond(n_), x(n_), y(n_);
  Span sum(0);
  for (std::size_t i = n_; i-- > 0;) {
    sum += spring_[i];
    springs_beyond[i] = sum;
    const Circle t = circle(theta[i]);
    x[i] = length_[i] * t.cosine, y[i] = length_[i] * t.sine;
  }
  const auto n = static_cast<Eigen::Index>(size());
  Matrix<Span> A = Matrix<Span>::Constant(n, n, Span(0));
  for (std::size_t a = 0; a < unknown_.size(); ++a) {
    const std::size_t i = unknown_[a];
    const auto row = static_cast<Eigen::Index>(a);
    A(row, row) = stiffness_[i] + x[i] * fx_[i] + y[i] * across[i];
    if (i + 1 < n_) A(row, row) += stiffness_[i + 1];
    if (i + 1 == n_) A(row, row) += end_turn_;
    for (std::size_t b = 0; b < unknown_.size(); ++b) {
      const std::size_t k = unknown_[b];
      const auto column = static_cast<Eigen::Index>(b);
      A(row, column) += x[i] * x[k] * springs_beyond[std::max(i, k)];
      if (k == i + 1) A(row, column) -= stiffness_[k];
      if (i == k + 1) A(row, column) -= stiffness_[i];
    }
    if (held_) {
      A(row, n - 1) = -x[i];
      A(n - 1, row) = x[i];
    }
  }
  return A;
}

bool StructureBox::newton(Ranges& box) const {
  const Matrix<Span> A = derivative(box);
  const Eigen::MatrixXd Y = middle(A).inverse();
  if (!Y.allFinite()) return true;
  Ranges centre;
  for (const Span& range : box) centre.emplace_back(range.middle());
  const Ranges f = residual(centre);
  for (std::size_t i = 0; i < size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    Span sum(0), diagonal(0);
    for (std::size_t j = 0; j < size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      Span G(0);
      for (Eigen::Index l = 0; l < A.rows(); ++l) G += Y(row, l) * A(l, column);
      sum += Y(row, column) * f[j];
      if (i == j)
        diagonal = G;
      else
        sum += G * (box[j] - centre[j]);
    }
    if (diagonal.contains(0)) continue;
    if (!bind(box[i], centre[i] - sum / diagonal)) return false;
  }
  return true;
}

}  // namespace plumbline::proofs
