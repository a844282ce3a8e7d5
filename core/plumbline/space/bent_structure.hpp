#pragma once
/// \file
/// A bent chain, in the plane or in space, with any ends, supports and dead loads: its energy, and what holds
/// it, to second order in the joint angles. Dense, O(n^2) numbers: whoever needs only the paper's ends and a
/// force there has nominal_model.hpp in O(n).
///
/// For a turn about axis a_i through o_i, a point p beyond it moves by a_i x (p - o_i), and for i <= k the
/// second derivative is a_i x (a_k x (p - o_k)). All else is sums of those.

#include <Eigen/Dense>
#include <cmath>
#include <plumbline/space/space_structure.hpp>
#include <plumbline/structure/implied_holds.hpp>

namespace plumbline {

/// What holds a chain in space, and what loads it.
template <Number Real>
struct SpaceSetting {
  /// A point or a vector, x, y, z.
  using Place = Eigen::Matrix<Real, 3, 1>;
  /// One coordinate of one node, against a spring that is slack where the chain rests, or held there.
  struct Hold {
    std::size_t node;           ///< from 0, the base
    int coordinate;             ///< 0, 1, 2: x, y, z
    Restraint<Real> restraint;  ///< against moving along it
  };
  /// A force of constant direction.
  struct Force {
    std::size_t node;  ///< where it acts, from 0, the base
    Place force;       ///< exerted on the chain, at factor 1
    bool multiplied;   ///< by the factor; else it is there as it stands
  };
  std::vector<Hold> holds;      ///< of nodes 1 … n
  std::vector<Hold> slides;     ///< of the base: coordinates that are not held there
  std::vector<Force> forces;    ///< dead
  std::vector<int> directions;  ///< coordinates of the last link's direction that are held
  Restraint<Real> turn;         ///< of the last link, where all axes are along z
  Real moment{0};               ///< at the end point, about z, multiplied, where all axes are along z
  bool base_clamped = false;    ///< joint 1 does not turn
};

/// A model at one shape: everything to second order.
template <Number Real>
struct BentExpansion {
  Real energy;                 ///< of springs, less what fixed loads have done
  Vector<Real> gradient;       ///< of the energy at the factor
  Vector<Real> load;           ///< minus its derivative by the factor: what a unit of the factor does
  Matrix<Real> hessian;        ///< of the energy, less the multipliers' part of what is held
  Vector<Real> held;           ///< how far what is held is from where it is to be
  Matrix<Real> held_gradient;  ///< a row for each
  std::vector<Eigen::Matrix<Real, 3, 1>> place;  ///< of nodes 0 … n
};

/// A chain with its setting, as a function of its unknowns.
template <Floating Number_>
class BentStructure {
 public:
  using Real = Number_;                     ///< the number type
  using Place = Eigen::Matrix<Real, 3, 1>;  ///< a point or a vector, x, y, z

  /// At rest all springs, those of the supports among them, are slack. \throws Error where nothing can move
  BentStructure(SpaceChain<Real> chain, SpaceSetting<Real> setting)
      : chain_(std::move(chain)), setting_(std::move(setting)) {
    using std::sqrt;
    for (std::size_t i = 0; i < chain_.size(); ++i) {
      for (const Axis<Real>& axis : chain_.joint[i].axes) {
        const Place d(axis.direction[0], axis.direction[1], axis.direction[2]);
        axes_.push_back(
            {d / sqrt(d.dot(d)), axis.stiffness, axis.rest, i, !(i == 0 && setting_.base_clamped)});
      }
    }
    for (std::size_t a = 0; a < axes_.size(); ++a) {
      if (axes_[a].turns) free_.push_back(a);
    }
    if (size() == 0)
      throw Error("structure", "nothing that can move", "a joint that turns, or a base that slides");
    const Kinematics at_rest = kinematics(rest());
    rest_place_ = at_rest.place;
    rest_direction_ = at_rest.direction;
  }

  /// Unknowns: angles of the axes that turn, then the base's slides.
  [[nodiscard]] Eigen::Index size() const {
    return static_cast<Eigen::Index>(free_.size() + setting_.slides.size());
  }
  /// Places and directions that are held.
  [[nodiscard]] Eigen::Index held() const {
    const auto of_nodes = std::count_if(setting_.holds.begin(), setting_.holds.end(),
                                        [](const auto& hold) { return hold.restraint.is_held(); });
    return of_nodes + static_cast<Eigen::Index>(setting_.directions.size()) +
           (setting_.turn.is_held() ? 1 : 0);
  }
  /// The unknowns where all springs are slack.
  [[nodiscard]] Vector<Real> rest() const {
    Vector<Real> x = Vector<Real>::Constant(size(), Real(0));
    for (std::size_t f = 0; f < free_.size(); ++f) x(static_cast<Eigen::Index>(f)) = axes_[free_[f]].rest;
    return x;
  }
  /// Angles of all axes, joint by joint.
  [[nodiscard]] std::vector<Real> angles(const Vector<Real>& x) const {
    std::vector<Real> q;
    for (const TurningAxis& axis : axes_) q.push_back(axis.rest);
    for (std::size_t f = 0; f < free_.size(); ++f) q[free_[f]] = x(static_cast<Eigen::Index>(f));
    return q;
  }
  /// The unknowns of the same shape with the angles of passive axes within half a turn of their rest: no
  /// spring counts the turns, unless one at the end point does.
  [[nodiscard]] Vector<Real> unwound(Vector<Real> x) const {
    using std::atan2, std::cos, std::sin;
    if (!setting_.turn.is_free()) return x;
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const TurningAxis& axis = axes_[free_[f]];
      Real& q = x(static_cast<Eigen::Index>(f));
      if (axis.stiffness == Real(0)) q = axis.rest + atan2(sin(q - axis.rest), cos(q - axis.rest));
    }
    return x;
  }
  /// The length of all links.
  [[nodiscard]] Real reach() const {
    Real sum(0);
    for (const Real& length : chain_.length) sum += length;
    return sum;
  }
  /// What springs and loads can turn a joint with: the moment beside which another is small.
  [[nodiscard]] Real moment_scale(const Real& factor) const {
    using std::abs;
    const Real r = reach();
    Real sum = abs(setting_.moment * factor) + setting_.turn.stiffness;
    for (const TurningAxis& axis : axes_) sum += axis.stiffness;
    for (const auto& hold : setting_.holds) sum += hold.restraint.stiffness * r * r;
    for (const auto& slide : setting_.slides) sum += slide.restraint.stiffness * r * r;
    for (const auto& force : setting_.forces)
      sum += (force.multiplied ? abs(factor) : Real(1)) * force.force.cwiseAbs().maxCoeff() * r;
    return sum;
  }
  /// Its links and joints.
  [[nodiscard]] const SpaceChain<Real>& chain() const { return chain_; }

  /// Of the shape, under the loads at a factor, with the forces (multipliers) that hold what is held.
  void expand(const Vector<Real>& x, const Real& factor, const Vector<Real>& multiplier,
              BentExpansion<Real>& at) const {
    const Kinematics k = kinematics(x);
    at.place = k.place;
    at.gradient = at.load = Vector<Real>::Constant(size(), Real(0));
    at.hessian = Matrix<Real>::Constant(size(), size(), Real(0));
    at.held.resize(held());
    at.held_gradient.resize(held(), size());
    at.energy = Real(0);
    springs(x, at);
    std::vector<Place> pull(k.place.size(),
                            Place::Constant(Real(0)));  // on each node, all that has a potential
    for (const auto& force : setting_.forces) {
      const Real share = force.multiplied ? factor : Real(1);
      pull[force.node] += share * force.force;
      if (force.multiplied) at.load += gradient_of(k, force.node, force.force);
      at.energy -= (force.multiplied ? Real(0) : Real(1)) * force.force.dot(k.place[force.node]);
    }
    Eigen::Index row = 0;
    for (const auto& hold : setting_.holds) hold_node(k, hold, multiplier, at, pull, row);
    Place twist = Place::Constant(Real(0));  // on the direction of the last link
    for (const int coordinate : setting_.directions) {
      Place e = Place::Constant(Real(0));
      e(coordinate) = Real(1);
      at.held(row) = k.direction(coordinate) - rest_direction_(coordinate);
      at.held_gradient.row(row) = direction_gradient(k, e).transpose();
      twist += multiplier(row) * e;
      ++row;
    }
    turn_end(x, factor, multiplier, at, row);
    add_pulls(k, pull, twist, at);
  }

  /// The energy of springs less the work of all loads at a factor.
  [[nodiscard]] Real potential(const Vector<Real>& x, const Real& factor) const {
    BentExpansion<Real> at;
    expand(x, factor, Vector<Real>::Constant(held(), Real(0)), at);
    Real V = at.energy;
    for (const auto& force : setting_.forces) {
      if (force.multiplied) V -= factor * force.force.dot(at.place[force.node]);
    }
    return V - factor * setting_.moment * end_turn(x);
  }

 private:
  struct TurningAxis {
    Place direction;  ///< where the joints before are straight; a unit vector
    Real stiffness, rest;
    std::size_t joint;
    bool turns;
  };
  struct Kinematics {
    std::vector<Place> place;  ///< of nodes 0 … n
    std::vector<Place> axis;   ///< of all axes, as they are turned
    Place direction;           ///< of the last link
  };

  [[nodiscard]] Kinematics kinematics(const Vector<Real>& x) const {
    using std::cos, std::sin;
    const std::vector<Real> q = angles(x);
    Kinematics k;
    Place p = Place::Constant(Real(0));
    for (std::size_t s = 0; s < setting_.slides.size(); ++s)
      p(setting_.slides[s].coordinate) += x(static_cast<Eigen::Index>(free_.size() + s));
    k.place.push_back(p);
    Eigen::Matrix<Real, 3, 3> R = Eigen::Matrix<Real, 3, 3>::Constant(Real(0));
    for (int c = 0; c < 3; ++c) R(c, c) = Real(1);
    for (std::size_t a = 0, i = 0; i < chain_.size(); ++i) {
      for (; a < axes_.size() && axes_[a].joint == i; ++a) {
        const Place d = axes_[a].direction;
        k.axis.push_back(R * d);
        const Real c = cos(q[a]), s = sin(q[a]);
        Eigen::Matrix<Real, 3, 3> turn = (Real(1) - c) * (d * d.transpose());
        for (int e = 0; e < 3; ++e) turn(e, e) += c;
        turn(0, 1) -= s * d(2), turn(1, 0) += s * d(2);
        turn(0, 2) += s * d(1), turn(2, 0) -= s * d(1);
        turn(1, 2) -= s * d(0), turn(2, 1) += s * d(0);
        R = (R * turn).eval();
      }
      k.direction = R.col(0);
      p += chain_.length[i] * k.direction;
      k.place.push_back(p);
    }
    return k;
  }

  /// Of force . place of a node.
  [[nodiscard]] Vector<Real> gradient_of(const Kinematics& k, std::size_t node, const Place& force) const {
    Vector<Real> g = Vector<Real>::Constant(size(), Real(0));
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const TurningAxis& axis = axes_[free_[f]];
      if (axis.joint < node)
        g(static_cast<Eigen::Index>(f)) =
            k.axis[free_[f]].dot((k.place[node] - k.place[axis.joint]).cross(force));
    }
    for (std::size_t s = 0; s < setting_.slides.size(); ++s)
      g(static_cast<Eigen::Index>(free_.size() + s)) = force(setting_.slides[s].coordinate);
    return g;
  }
  [[nodiscard]] Vector<Real> direction_gradient(const Kinematics& k, const Place& e) const {
    Vector<Real> g = Vector<Real>::Constant(size(), Real(0));
    for (std::size_t f = 0; f < free_.size(); ++f)
      g(static_cast<Eigen::Index>(f)) = k.axis[free_[f]].dot(k.direction.cross(e));
    return g;
  }

  void springs(const Vector<Real>& x, BentExpansion<Real>& at) const {
    for (std::size_t f = 0; f < free_.size(); ++f) {
      const auto i = static_cast<Eigen::Index>(f);
      const TurningAxis& axis = axes_[free_[f]];
      const Real d = x(i) - axis.rest;
      at.energy += axis.stiffness * d * d / Real(2);
      at.gradient(i) += axis.stiffness * d;
      at.hessian(i, i) += axis.stiffness;
    }
    for (std::size_t s = 0; s < setting_.slides.size(); ++s) {
      const auto i = static_cast<Eigen::Index>(free_.size() + s);
      const Real& stiffness = setting_.slides[s].restraint.stiffness;
      at.energy += stiffness * x(i) * x(i) / Real(2);
      at.gradient(i) += stiffness * x(i);
      at.hessian(i, i) += stiffness;
    }
  }

  void hold_node(const Kinematics& k, const typename SpaceSetting<Real>::Hold& hold,
                 const Vector<Real>& multiplier, BentExpansion<Real>& at, std::vector<Place>& pull,
                 Eigen::Index& row) const {
    Place e = Place::Constant(Real(0));
    e(hold.coordinate) = Real(1);
    const Real off = k.place[hold.node](hold.coordinate) - rest_place_[hold.node](hold.coordinate);
    const Vector<Real> g = gradient_of(k, hold.node, e);
    if (hold.restraint.is_held()) {
      at.held(row) = off;
      at.held_gradient.row(row) = g.transpose();
      pull[hold.node] += multiplier(row) * e;
      ++row;
    } else {
      const Real& stiffness = hold.restraint.stiffness;
      at.energy += stiffness * off * off / Real(2);
      at.hessian += stiffness * (g * g.transpose());
      pull[hold.node] -= stiffness * off * e;
    }
  }

  /// How far the last link has turned from where it rests, in a plane: the sum of all angles.
  [[nodiscard]] Real end_turn(const Vector<Real>& x) const {
    Real off(0);
    for (std::size_t f = 0; f < free_.size(); ++f)
      off += x(static_cast<Eigen::Index>(f)) - axes_[free_[f]].rest;
    return off;
  }
  /// Of that turn.
  void turn_end(const Vector<Real>& x, const Real& factor, const Vector<Real>& multiplier,
                BentExpansion<Real>& at, Eigen::Index row) const {
    const auto turning = static_cast<Eigen::Index>(free_.size());
    const Real off = end_turn(x);
    Real torque = setting_.moment * factor;
    if (setting_.turn.is_held()) {
      at.held(row) = off;
      at.held_gradient.row(row).setConstant(Real(0));
      for (Eigen::Index i = 0; i < turning; ++i) at.held_gradient(row, i) = Real(1);
      torque += multiplier(row);
    } else if (!setting_.turn.is_free()) {
      at.energy += setting_.turn.stiffness * off * off / Real(2);
      torque -= setting_.turn.stiffness * off;
      for (Eigen::Index i = 0; i < turning; ++i) {
        for (Eigen::Index j = 0; j < turning; ++j) at.hessian(i, j) += setting_.turn.stiffness;
      }
    }
    for (Eigen::Index i = 0; i < turning; ++i) {
      at.gradient(i) -= torque;
      at.load(i) += setting_.moment;
    }
  }

  /// What pulls at the nodes and at the last link's direction, in gradient and Hessian.
  void add_pulls(const Kinematics& k, const std::vector<Place>& pull, const Place& twist,
                 BentExpansion<Real>& at) const {
    const std::size_t n = chain_.size();
    for (std::size_t node = 0; node <= n; ++node) at.gradient -= gradient_of(k, node, pull[node]);
    at.gradient -= direction_gradient(k, twist);
    Eigen::Matrix<Real, 3, 3> P = twist * k.direction.transpose();  // sum of pull (place - origin)^T beyond
    Place beyond = Place::Constant(Real(0));
    std::size_t node = n + 1;
    for (std::size_t f = free_.size(); f-- > 0;) {
      const TurningAxis& outer = axes_[free_[f]];
      while (node > outer.joint + 1) {
        --node;
        if (node < n) P += beyond * (k.place[node + 1] - k.place[node]).transpose();
        beyond += pull[node];
      }
      const Eigen::Matrix<Real, 3, 3> about =
          P + beyond * (k.place[outer.joint + 1] - k.place[outer.joint]).transpose();
      const Real trace = about.trace();
      const Place along = about.transpose() * k.axis[free_[f]];
      for (std::size_t g = 0; g <= f; ++g) {
        const Real second = along.dot(k.axis[free_[g]]) - trace * k.axis[free_[g]].dot(k.axis[free_[f]]);
        const auto i = static_cast<Eigen::Index>(g), j = static_cast<Eigen::Index>(f);
        at.hessian(i, j) -= second;
        if (i != j) at.hessian(j, i) -= second;
      }
    }
  }

  SpaceChain<Real> chain_;
  SpaceSetting<Real> setting_;
  std::vector<TurningAxis> axes_;
  std::vector<std::size_t> free_;  ///< axes that turn
  std::vector<Place> rest_place_;
  Place rest_direction_;
};

/// A planar structure as one in space: all axes along z.
/// \throws Error for a follower load, which has no energy
template <Floating Real>
BentStructure<Real> bent_structure(const Structure<Real>& structure) {
  structure.require_sound();
  if (structure.follower()) throw Error("load", "a follower force, which has no energy", "dead loads");
  const std::size_t n = structure.chain.size();
  std::vector<SpaceJoint<Real>> joints;
  for (std::size_t i = 0; i < n; ++i)
    joints.push_back(
        {{{{Real(0), Real(0), Real(1)}, structure.chain.stiffness()[i], structure.chain.rest()[i]}}});
  SpaceSetting<Real> setting;
  if (!structure.base.along.is_held()) setting.slides.push_back({0, 0, structure.base.along});
  if (!structure.base.across.is_held()) setting.slides.push_back({0, 1, structure.base.across});
  const std::vector<bool> implied = implied_across(structure);
  for (std::size_t node = 1; node <= n; ++node) {
    const Restraint<Real> across = structure.across_at(node);
    if (!across.is_free() && !implied[node]) setting.holds.push_back({node, 1, across});
  }
  if (!structure.end_point.along.is_free()) setting.holds.push_back({n, 0, structure.end_point.along});
  for (const Load<Real>& load : structure.loads)
    setting.forces.push_back({load.node, {load.force.x, load.force.y, Real(0)}, load.multiplied});
  setting.turn = end_turn(structure);
  setting.moment = structure.moment;
  setting.base_clamped = structure.base.turn.is_held();
  return BentStructure<Real>(SpaceChain<Real>(structure.chain.length(), std::move(joints)),
                             std::move(setting));
}

/// A chain in space with its forces. \throws Error for a torque, whose work depends on the way
template <Floating Real>
BentStructure<Real> bent_structure(const SpaceStructure<Real>& structure) {
  structure.require_sound();
  if (structure.torque)
    throw Error("loads", "a torque, of which the critical value alone is computed", "forces");
  const std::size_t n = structure.chain.size();
  SpaceSetting<Real> setting;
  const std::vector<bool> implied = implied_across(structure, true, structure.base == SpaceBase::clamped,
                                                   structure.end_point.turn.is_held());
  for (std::size_t node = 1; node <= n; ++node) {
    const Restraint<Real> across = structure.across_at(node);
    if (across.is_free() || implied[node]) continue;
    for (const int coordinate : {1, 2}) setting.holds.push_back({node, coordinate, across});
  }
  if (structure.end_point.turn.is_held()) setting.directions = {1, 2};
  for (const SpaceForce<Real>& load : structure.loads)
    setting.forces.push_back({load.node, {load.force[0], load.force[1], load.force[2]}, load.multiplied});
  setting.base_clamped = structure.base == SpaceBase::clamped;
  return BentStructure<Real>(structure.chain, std::move(setting));
}

}  // namespace plumbline
