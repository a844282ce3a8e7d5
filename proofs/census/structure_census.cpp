#include "proofs/census/structure_census.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {
namespace {

using Ranges = std::vector<Span>;  ///< of the unknowns: directions of links that turn, then the force across

constexpr std::size_t boxes_at_most = 4000000, most_undecided = 1000, most_turning = 10;
constexpr double smallest = 1e-7;
constexpr double above_pi = 3.1415926535897936;
constexpr double uneven = 0.4876543;  // where a box is halved: no symmetric shape lies there

Span span_of(const Rational& x) {
  return Span(Interval(x));
}

/// The equilibrium equations over a box.
class StructureBox {
 public:
  StructureBox(const Structure<Rational>& structure, const Rational& factor, int turns)
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
    if (structure.end_point.turn.hold == Hold::sprung)
      end_turn_ = span_of(structure.end_point.turn.stiffness);
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

  [[nodiscard]] std::size_t turning() const { return unknown_.size(); }
  [[nodiscard]] std::size_t size() const { return unknown_.size() + (held_ ? 1 : 0); }
  [[nodiscard]] double largest_force() const { return largest_force_; }
  [[nodiscard]] double widest_turn() const { return turn_[0].high; }

  [[nodiscard]] Ranges everything() const {
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

  /// False: nothing is left.
  bool contract(Ranges& box) const {
    for (int pass = 0; pass < 3; ++pass) {
      const double before = size_of(box);
      if (!moments(box) || !newton(box)) return false;
      if (size_of(box) > 0.9 * before) break;
    }
    return true;
  }

  /// Whether one Newton step leads strictly inside: exactly one root; the box is then that much smaller.
  bool isolates(Ranges& box) const {
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

  /// A box around one root, as far as Newton's steps narrow it; where they gain little, as near a critical
  /// load, the part of it that is not proved to be empty.
  [[nodiscard]] Ranges narrowed(Ranges box) const {
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

  /// Of a box around one root: without the third at either end of its widest side, where that is proved to be
  /// empty.
  [[nodiscard]] std::optional<Ranges> part_with_root(const Ranges& box) const {
    std::size_t side = 0;
    for (std::size_t j = 1; j < size(); ++j)
      if (box[j].width() > box[side].width()) side = j;
    for (const bool upper : {false, true}) {
      Ranges end = box, rest = box;
      const double at =
          upper ? box[side].high - box[side].width() / 3 : box[side].low + box[side].width() / 3;
      (upper ? end[side].low : end[side].high) = at;
      (upper ? rest[side].high : rest[side].low) = at;
      if (!contract(end)) return rest;
    }
    return std::nullopt;
  }

  static double widest(const Ranges& box) {
    double width = 0;
    for (const Span& one : box) width = std::max(width, one.high - one.low);
    return width;
  }

  /// Whether two boxes that overlap, each around one root, are around the same: their hull has one as well.
  [[nodiscard]] bool around_one(const Ranges& a, const Ranges& b) const {
    Ranges hull = widened(a, b);
    return isolates(hull);
  }

  /// A box of the same shapes whose directions lie as near to another's as whole turns of passive joints
  /// bring them: no spring counts those.
  [[nodiscard]] Ranges unwound(const Ranges& box, const Ranges& like) const {
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

  /// The hull of two boxes and a little more: a Newton step leads strictly inside no box that is already as
  /// small as it can make it.
  [[nodiscard]] Ranges widened(const Ranges& a, const Ranges& b) const {
    Ranges hull;
    for (std::size_t j = 0; j < size(); ++j) {
      const double low = std::min(a[j].low, b[j].low), high = std::max(a[j].high, b[j].high);
      const double margin = high - low + 1e-12 * std::max(std::abs(low), std::abs(high)) + 1e-300;
      hull.emplace_back(low - margin, high + margin);
    }
    return hull;
  }

  [[nodiscard]] StructureEquilibrium described(const Ranges& box) const {
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

  /// Whether a box is not certainly outside the window.
  [[nodiscard]] bool counted(const Ranges& box) const {
    const Ranges q = angles(directions(box));
    for (std::size_t i = 0; i < n_; ++i) {
      if (!fixed_[i] && intersection(q[i], rest_[i] + turn_[i]).empty()) return false;
    }
    return true;
  }

  [[nodiscard]] Ranges angles(const Ranges& theta) const {
    Ranges q;
    for (std::size_t i = 0; i < n_; ++i) q.push_back(i == 0 ? theta[0] : theta[i] - theta[i - 1]);
    return q;
  }
  [[nodiscard]] Ranges directions(const Ranges& box) const {
    Ranges theta = slack_;
    for (std::size_t j = 0; j < unknown_.size(); ++j) theta[unknown_[j]] = box[j];
    return theta;
  }

 private:
  static double size_of(const Ranges& box) {
    double sum = 0;
    for (const Span& range : box) sum += range.width();
    return sum;
  }

  /// A hundred times what the springs and loads can turn the chain with.
  void bound_force(const Span& reach) {
    double moment = moment_.magnitude() + (end_turn_ * Span(above_pi)).magnitude();
    for (std::size_t i = 0; i < n_; ++i)
      moment += (stiffness_[i] * turn_[i]).magnitude() + (length_[i] * fx_[i]).magnitude() +
                (length_[i] * fy_[i]).magnitude() + (spring_[i] * reach * reach).magnitude();
    largest_force_ = held_ ? 100 * moment / reach.low : 0;
  }

  [[nodiscard]] Span place_across(const Ranges& theta, std::size_t links) const {
    Span y(0);
    for (std::size_t i = 0; i < links; ++i) y += length_[i] * sin(theta[i]);
    return y;
  }

  /// The force across that link i passes on: loads, springs and what holds the end point, beyond it.
  [[nodiscard]] Ranges passed_across(const Ranges& theta, const Span& force) const {
    Ranges across(n_);
    Span beyond = force;
    for (std::size_t i = n_; i-- > 0;) {
      beyond -= spring_[i] * (place_across(theta, i + 1) - place_across(slack_, i + 1));
      across[i] = beyond + fy_[i];
    }
    return across;
  }

  bool bind(Span& known, const Span& other) const {
    known = intersection(known, other);
    return !known.empty();
  }

  /// From the end point to the base, what the moment at a joint says of its angle; and the closure.
  bool moments(Ranges& box) const {
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

  [[nodiscard]] Ranges residual(const Ranges& box) const {
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

  [[nodiscard]] Matrix<Span> derivative(const Ranges& box) const {
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

  bool newton(Ranges& box) const {
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

  std::size_t n_;
  bool held_;
  Ranges length_, stiffness_, rest_, slack_, turn_, spring_, fx_, fy_;
  std::vector<bool> fixed_;
  std::vector<std::size_t> unknown_;
  Span end_turn_{0}, moment_{0}, y_rest_{0};
  double largest_force_ = 0;
};

/// Two parts of a box along its widest side; the force counts as the turn that it can make.
std::pair<Ranges, Ranges> halved(const Ranges& box, const StructureBox& system) {
  std::size_t widest = 0;
  double most = -1;
  for (std::size_t j = 0; j < box.size(); ++j) {
    const double unit = j < system.turning() ? 1 : above_pi / system.largest_force();
    if (box[j].width() * unit > most) most = box[j].width() * unit, widest = j;
  }
  Ranges low = box, high = box;
  const double at = box[widest].low + uneven * box[widest].width();
  low[widest].high = high[widest].low = at;
  return {std::move(low), std::move(high)};
}

double widest_of(const Ranges& box, std::size_t turning) {
  double widest = 0;
  for (std::size_t j = 0; j < turning; ++j) widest = std::max(widest, box[j].width());
  return widest;
}

bool overlap(const Ranges& a, const Ranges& b) {
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (intersection(a[j], b[j]).empty()) return false;
  }
  return true;
}

/// Adds a box around an equilibrium; those on the border between two boxes are found in both, and those half
/// a turn off at a passive joint to either side.
/// \returns false where it is open whether it is a new one
bool add(std::vector<Ranges>& found, const Ranges& box, const StructureBox& system) {
  for (const Ranges& other : found) {
    const Ranges same = system.unwound(box, other);
    if (overlap(other, same)) return system.around_one(other, same);
  }
  found.push_back(box);
  return true;
}

}  // namespace

StructureCensus take_census(const Structure<Rational>& structure, const Rational& factor, int turns) {
  const StructureBox system(structure, factor, turns);
  StructureCensus census{{}, {}, system.widest_turn(), system.largest_force(), 0};
  std::vector<Ranges> open{system.everything()}, found;
  while (!open.empty()) {
    if (++census.boxes > boxes_at_most)
      throw Error("census", "no end after " + std::to_string(boxes_at_most) + " boxes",
                  "fewer links, or a smaller load");
    Ranges box = std::move(open.back());
    open.pop_back();
    if (!system.contract(box)) continue;
    const bool small = widest_of(box, system.turning()) < smallest;
    Ranges one = small ? system.widened(box, box) : box;
    if (system.isolates(one)) {
      if (system.counted(one) && !add(found, one, system))
        census.undecided.push_back(system.angles(system.directions(one)));
      continue;
    }
    if (small) {
      census.undecided.push_back(system.angles(system.directions(box)));
      if (census.undecided.size() > most_undecided)
        throw Error("census", "more than " + std::to_string(most_undecided) + " boxes that stay undecided",
                    "isolated equilibria");
      continue;
    }
    auto [low, high] = halved(box, system);
    open.push_back(std::move(low));
    open.push_back(std::move(high));
  }
  for (const Ranges& box : found) census.equilibria.push_back(system.described(box));
  std::stable_sort(census.equilibria.begin(), census.equilibria.end(),
                   [](const auto& a, const auto& b) { return a.energy.middle() < b.energy.middle(); });
  return census;
}

}  // namespace plumbline::proofs
