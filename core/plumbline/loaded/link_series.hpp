#pragma once
/// \file
/// The links of a chain along a branch, as power series.

#include <cstring>
#include <plumbline/base/lanes.hpp>
#include <plumbline/base/widest.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <type_traits>
#include <utility>

namespace plumbline {

/// Coefficients of s^0, s^1, … of the links' x = L cos theta and y = L sin theta. From x' = -y theta' and
/// y' = x theta', with turn_k = k theta_k,
///
///     k x_k = -sum_{j=1}^{k} turn_j y_{k-j} ,   k y_k = sum_{j=1}^{k} turn_j x_{k-j} .
template <Number Real>
class LinkSeries {
 public:
  /// Order 0, and room up to an order.
  /// \param gradient  a row (-y, x) a link
  /// \param carried   constant force on each link beside that of the branch; none where it is empty
  void begin(const Eigen::Matrix<Real, Eigen::Dynamic, 2>& gradient, Eigen::Index order,
             const std::vector<Point<Real>>& carried) {
    carried_ = &carried;
    links_ = gradient.rows();
    const Eigen::Index blocks = (links_ + width - 1) / width;
    for (Matrix<Real>* one : {&turn_, &x_, &y_}) {
      if (one->rows() != width * (order + 1) || one->cols() != blocks)
        *one = Matrix<Real>::Constant(width * (order + 1), blocks, Real(0));
    }
    moment_.resize(width * blocks);
    for (Eigen::Index i = 0; i < links_; ++i) {
      entry(x_, 0, i) = gradient(i, 1);
      entry(y_, 0, i) = -gradient(i, 0);
    }
  }

  /// What the orders below k contribute to order k.
  /// \param branch  has the coefficients of the force
  /// \param moment  of y Fx - x Fy, a link each, F with what the link carries
  /// \param x, y    of the sums over all links
  template <class Branch>
  void lower_orders(Eigen::Index k, const Branch& branch, Vector<Real>& moment, Real& x, Real& y) {
    if constexpr (in_lanes) {
      detail::in_widest([&] { sum_lower_orders(k, branch, x, y); });
    } else {
      sum_lower_orders(k, branch, x, y);
    }
    moment = moment_.head(links_);
    for (std::size_t j = 0; j < carried_->size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      moment(i) += entry(y_, k, i) * (*carried_)[j].x - entry(x_, k, i) * (*carried_)[j].y;
    }
  }

  /// Completes order k by the links' own turn of that order, theta_k.
  /// \return coefficients of the sums of x and y over all links
  std::pair<Real, Real> turn(Eigen::Index k, const Vector<Real>& theta) {
    Real x(0), y(0);
    for (Eigen::Index i = 0; i < links_; ++i) {
      entry(turn_, k, i) = Real(static_cast<int>(k)) * theta(i);
      x += entry(x_, k, i) -= entry(y_, 0, i) * theta(i);
      y += entry(y_, k, i) += entry(x_, 0, i) * theta(i);
    }
    return {x, y};
  }

 private:
  static constexpr bool in_lanes = std::same_as<Real, double>;
  static constexpr Eigen::Index width = in_lanes ? detail::lane_count : 1;
  /// One number of `width` links.
  using Links = std::conditional_t<in_lanes, detail::Lanes, Real>;

  static Links load(const Real* from) {
    if constexpr (in_lanes) {
      Links links;
      std::memcpy(&links, from, sizeof links);
      return links;
    } else {
      return *from;
    }
  }
  static void store(const Links& links, Real* to) {
    if constexpr (in_lanes) {
      std::memcpy(to, &links, sizeof links);
    } else {
      *to = links;
    }
  }
  static Real sum(const Links& links) {
    if constexpr (in_lanes) {
      return detail::suffix_sums(links)[0];
    } else {
      return links;
    }
  }

  /// lower_orders() but for what the links carry, `width` links at a time.
  template <class Branch>
  void sum_lower_orders(Eigen::Index k, const Branch& branch, Real& x, Real& y) {
    const Real share = Real(1) / Real(static_cast<int>(k));
    const Links none = Links{} + Real(0);
    Links sum_x = none, sum_y = none;
    for (Eigen::Index block = 0; block < x_.cols(); ++block) {
      const Eigen::Index first = block * x_.rows();
      Real *const xs = x_.data() + first, *const ys = y_.data() + first;
      const Real* const turns = turn_.data() + first;
      Links fall = none, rise = none, by_fx = none, by_fy = none;
      for (Eigen::Index j = 1; j < k; ++j) {
        const Links before_x = load(xs + width * (k - j)), before_y = load(ys + width * (k - j)),
                    turned = load(turns + width * j);
        fall += turned * before_y;
        rise += turned * before_x;
        by_fx += before_y * branch.force_x(j);
        by_fy += before_x * branch.force_y(j);
      }
      const Links dx = fall * -share, dy = rise * share;
      store(dx, xs + width * k);
      store(dy, ys + width * k);
      sum_x += dx;
      sum_y += dy;
      store((by_fx + dy * branch.force_x(0)) - (by_fy + dx * branch.force_y(0)),
            moment_.data() + width * block);
    }
    x = sum(sum_x);
    y = sum(sum_y);
  }

  static Real& entry(Matrix<Real>& of, Eigen::Index order, Eigen::Index link) {
    return of(width * order + link % width, link / width);
  }

  Eigen::Index links_ = 0;
  const std::vector<Point<Real>>* carried_ = nullptr;
  Matrix<Real> turn_, x_, y_;  ///< a column for every `width` links: their orders one after the other
  Vector<Real> moment_;
};

}  // namespace plumbline
