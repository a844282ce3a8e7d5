#pragma once
/// \file
/// A branch of equilibria around one of its points, as power series in the length s along the tangent there.
///
/// All equations of a chain are polynomials in angles, sines and cosines, so their Taylor coefficients follow
/// one after the other from one factored matrix. With an order that grows like the digits, a series is exact
/// to rounding over a fixed part of its radius of convergence, and any point there costs one evaluation.

#include <plumbline/loaded/loaded_model.hpp>
#include <plumbline/loaded/loading.hpp>

namespace plumbline {

/// An equilibrium on a branch.
template <Number Real>
struct BranchPoint {
  Real load;                        ///< along the loading's ray
  Vector<Real> theta;               ///< absolute angles, n
  Point<Real> force;                ///< on the end point
  Point<Real> end_point;            ///< where it is
  Real energy;                      ///< stored energy
  std::size_t negative_directions;  ///< in the sense of the control
  Real stiffness;                   ///< tangent stiffness along the loading's direction; infinite where the
                                    ///< end point stands still (a fold in deflection)
  Variation<Real> tangent;          ///< of unit length in the branch's own measure
};

/// The coefficients of s^0 … s^order of everything that a point of a branch is described by.
template <Floating Real>
class BranchSeries {
 public:
  /// Quantities beside the angles. The tangent stiffness is push'/way', force and way of the end point along
  /// the loading's direction; `bend` has the sign of its derivative.
  enum Quantity : std::uint8_t { Fx, Fy, load, place_x, place_y, energy, push, way, bend, quantities };

  BranchSeries() : BranchSeries(sufficient_order()) {}
  /// Of powers up to s^order.
  explicit BranchSeries(Eigen::Index order) : order_(order) {}

  /// Order 0.
  void begin(const Variation<Real>& here, const Point<Real>& place) {
    angles_ = here.theta.size();
    const Eigen::Index rows = (angles_ + quantities + width - 1) / width * width;
    if (coefficient_.rows() != rows || coefficient_.cols() != order_ + 1) {
      coefficient_ = Matrix<Real>::Constant(rows, order_ + 1, Real(0));
      value_.resize(rows);
      slope_.resize(rows);
    }
    set(0, here, place);
  }

  /// Order k.
  void set(Eigen::Index k, const Variation<Real>& term, const Point<Real>& place) {
    coefficient_.col(k).head(angles_) = term.theta;
    entry(Fx, k) = term.force.x;
    entry(Fy, k) = term.force.y;
    entry(load, k) = term.load;
    entry(place_x, k) = place.x;
    entry(place_y, k) = place.y;
  }

  /// The other quantities, when all orders are set. Since these are equilibria dE/ds = F . dp/ds, and that is
  /// push · way', beside the work of a force that the load comes on top of.
  void complete(const Real& energy_here, const Loading<Real>& loading) {
    const Point<Real>& d = loading.direction;
    const bool held = loading.control == Control::end_point;
    const auto along = [&](Quantity x, Eigen::Index k) -> Real {
      return d.x * coefficient(x, k) + d.y * coefficient(Quantity(x + 1), k);
    };
    for (Eigen::Index k = 0; k <= order_; ++k) {
      entry(push, k) = held ? along(Fx, k) : coefficient(load, k);
      entry(way, k) = held ? coefficient(load, k) : along(place_x, k);
    }
    rates_.resize(order_ + 1, 5);
    auto push0 = rates_.col(0), push1 = rates_.col(1), push2 = rates_.col(2), way1 = rates_.col(3),
         way2 = rates_.col(4);
    push0 = coefficient_.row(angles_ + push);
    for (Eigen::Index k = 0; k < order_; ++k) {
      const Real next(static_cast<int>(k + 1));
      push1(k) = next * coefficient(push, k + 1);
      way1(k) = next * coefficient(way, k + 1);
    }
    for (Eigen::Index k = 0; k + 1 < order_; ++k) {
      const Real next(static_cast<int>(k + 1));
      push2(k) = next * push1(k + 1);
      way2(k) = next * way1(k + 1);
    }
    entry(energy, 0) = energy_here;
    for (Eigen::Index k = 0; k < order_; ++k) {
      const auto product = [k](const auto& p, const auto& q) -> Real {  // of order k
        return p.head(k + 1).dot(q.head(k + 1).reverse());
      };
      const Real work = product(way1, push0);
      entry(energy, k + 1) = work / Real(static_cast<int>(k + 1));
      if (!held)
        entry(energy, k + 1) +=
            loading.start.x * coefficient(place_x, k + 1) + loading.start.y * coefficient(place_y, k + 1);
      if (k + 1 < order_) entry(bend, k) = product(push2, way1) - product(way2, push1);
    }
  }

  /// The highest power.
  [[nodiscard]] Eigen::Index order() const { return order_; }
  /// Of s^k in a quantity.
  [[nodiscard]] const Real& coefficient(Quantity q, Eigen::Index k) const {
    return coefficient_(angles_ + q, k);
  }
  /// Of s^k in F_x.
  [[nodiscard]] const Real& force_x(Eigen::Index k) const { return coefficient(Fx, k); }
  /// Of s^k in F_y.
  [[nodiscard]] const Real& force_y(Eigen::Index k) const { return coefficient(Fy, k); }

  /// Goes to a place of the branch. By Horner's scheme, several rows at once.
  void go_to(const Real& s) {
    using Rows = Eigen::Array<Real, width, 1>;
    for (Eigen::Index row = 0; row < coefficient_.rows(); row += width) {
      Rows value = Rows::Constant(Real(0)), slope = value;
      for (Eigen::Index k = order_; k >= 0; --k) {
        slope = slope * s + value;
        value = value * s + coefficient_.col(k).template segment<width>(row).array();
      }
      value_.template segment<width>(row) = value;
      slope_.template segment<width>(row) = slope;
    }
  }
  /// What is there, and its derivative by s.
  [[nodiscard]] const Real& value(Quantity q) const { return value_(angles_ + q); }
  /// Derivative of a quantity by s, where the series was evaluated last.
  [[nodiscard]] const Real& slope(Quantity q) const { return slope_(angles_ + q); }

  /// Tangent stiffness at s, also where force and way both turn back, as they do on a branch that leaves a
  /// symmetric one: there it is the ratio of their second derivatives.
  [[nodiscard]] Real stiffness(const Real& s) {
    go_to(s);
    using std::abs, std::sqrt;
    const Real force = curvature(push, s), distance = curvature(way, s);
    const Real near = sqrt(sqrt(epsilon<Real>()));
    const bool turns = abs(slope(push)) < near * abs(force) && abs(slope(way)) < near * abs(distance);
    return turns ? force / distance : slope(push) / slope(way);
  }

  /// The place as a point; its type is left open, and its tangent has any length.
  [[nodiscard]] BranchPoint<Real> point() const {
    return {value(load),
            value_.head(angles_),
            {value(Fx), value(Fy)},
            {value(place_x), value(place_y)},
            value(energy),
            0,
            slope(push) / slope(way),
            {slope_.head(angles_), {slope(Fx), slope(Fy)}, slope(load)}};
  }

  /// Length over which the series is exact to rounding: its last terms are at most 4 eps there.
  Real reach{0};

 private:
  /// Terms beyond it are below rounding over three tenths of the radius of convergence: 0.3^order = eps.
  static Eigen::Index sufficient_order() {
    using std::ceil, std::log;
    return static_cast<Eigen::Index>(ceil(log(epsilon<Real>()) / log(Real(3) / Real(10))));
  }

  /// Second derivative.
  [[nodiscard]] Real curvature(Quantity q, const Real& s) const {
    Real sum(0);
    for (Eigen::Index k = order_; k > 1; --k)
      sum = sum * s + Real(static_cast<int>(k * (k - 1))) * coefficient(q, k);
    return sum;
  }

  Real& entry(Quantity q, Eigen::Index k) { return coefficient_(angles_ + q, k); }

  static constexpr Eigen::Index width = std::same_as<Real, double> ? 8 : 1;
  Eigen::Index angles_ = 0, order_;
  Matrix<Real> coefficient_;  ///< a column an order
  Vector<Real> value_, slope_;
  Matrix<Real> rates_;  ///< of push and way, and of their rates
};

}  // namespace plumbline
