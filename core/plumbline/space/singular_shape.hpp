#pragma once
/// \file
/// Shapes at which what holds a structure is dependent, and beside which it is not: two families of shapes
/// cross there, or one ends. No multipliers need exist, and no second derivative tells what is stable.
///
/// Constraints that depend on each other at every shape, such as a support on a clamped link, are no such
/// case: the structure is held by fewer of them. So the ranks at the shape and beside it are compared, on
/// what the constraints that are independent at the shape permit.
///
/// \code{.cpp}
/// // A link and a shorter one about one oblique axis and one across it, the far node held: of the two
/// // coordinates that are held the straight shape knows one alone.
/// const SpaceChain<double> chain({2, 1}, {{{{{1, 1, 1}, 1, 0}}}, {{{{0, 1, 1}, 1, 0}, {{1, 1, 1}, 1, 0}}}});
/// SpaceSetting<double> setting;
/// setting.holds = {{2, 1, Restraint<double>::held()}, {2, 2, Restraint<double>::held()}};
/// const BentStructure<double> model(chain, setting);
/// assert(is_singular(model, model.rest()));
/// \endcode

#include <algorithm>
#include <plumbline/base/bordered_band.hpp>
#include <plumbline/space/bent_structure.hpp>

namespace plumbline {

namespace detail {

/// Rows that span all rows, and the pivots of the elimination that finds them, each row taken as of size one.
template <Number Real>
struct IndependentRows {
  std::vector<Eigen::Index> row;
  std::vector<Real> pivot;
};

/// What an elimination leaves of a row that depends on others is rounding, some units of the size of that row
/// in the last place.
template <Floating Real>
IndependentRows<Real> independent_rows(Matrix<Real> rows) {
  using std::abs;
  const Real rounding = Real(64 * static_cast<double>(rows.cols() + 1)) * epsilon<Real>();
  std::vector<Eigen::Index> open;
  IndependentRows<Real> found;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Real size = rows.row(i).cwiseAbs().maxCoeff();
    if (!(size > Real(0))) continue;
    rows.row(i) /= size;
    open.push_back(i);
  }
  while (!open.empty()) {
    Eigen::Index column = 0;
    const auto largest = [&](Eigen::Index i) { return rows.row(i).cwiseAbs().maxCoeff(); };
    const auto best = std::max_element(
        open.begin(), open.end(), [&](Eigen::Index a, Eigen::Index b) { return largest(a) < largest(b); });
    const Eigen::Index row = *best;
    const Real pivot = rows.row(row).cwiseAbs().maxCoeff(&column);
    if (!(pivot > rounding)) break;
    open.erase(best);
    found.row.push_back(row);
    found.pivot.push_back(pivot);
    for (const Eigen::Index i : open) rows.row(i) -= (rows(i, column) / rows(row, column)) * rows.row(row);
  }
  return found;
}

/// Newton's way along what is clearly held at a shape: a pivot of a thousandth is a constraint that is.
template <Floating Real>
class ClearlyHeld {
 public:
  ClearlyHeld(const BentStructure<Real>& model, const Vector<Real>& x)
      : model_(&model), none_(Vector<Real>::Constant(model.held(), Real(0))) {
    model_->expand(x, Real(0), none_, at_);
    all_ = independent_rows(at_.held_gradient);
    for (std::size_t i = 0; i < all_.row.size(); ++i) {
      if (all_.pivot[i] > Real(1) / Real(1000)) clear_.push_back(all_.row[i]);
    }
  }
  /// All that is independent at the shape.
  [[nodiscard]] const IndependentRows<Real>& all() const { return all_; }
  /// Some motion that is permitted there, its largest component one; zero where there is none.
  [[nodiscard]] Vector<Real> motion() const {
    using std::cos;
    Vector<Real> way(model_->size());
    for (Eigen::Index i = 0; i < way.size(); ++i) way(i) = Real(cos(static_cast<double>(i) + 1.0));
    way -= least_change(way);
    const Real size = way.cwiseAbs().maxCoeff();
    return size > Real(1e6) * epsilon<Real>() ? Vector<Real>(way / size) : Vector<Real>(Real(0) * way);
  }
  /// The shape near x that keeps it, expanded: all that is independent there.
  IndependentRows<Real> beside(Vector<Real> x) {
    for (int step = 0; step < 8; ++step) {
      model_->expand(x, Real(0), none_, at_);
      x -= least_change_for(at_.held);
    }
    model_->expand(x, Real(0), none_, at_);
    return independent_rows(at_.held_gradient);
  }

 private:
  /// The part of a motion that changes what is clearly held.
  [[nodiscard]] Vector<Real> least_change(const Vector<Real>& way) const {
    return least_change_for(at_.held_gradient * way);
  }
  /// The smallest motion that changes what is held, as far as it is so clearly, by that much.
  [[nodiscard]] Vector<Real> least_change_for(const Vector<Real>& change) const {
    const auto count = static_cast<Eigen::Index>(clear_.size());
    if (count == 0) return Vector<Real>::Constant(model_->size(), Real(0));
    Matrix<Real> rows(count, model_->size());
    Vector<Real> right(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index row = clear_[static_cast<std::size_t>(i)];
      const Real size = at_.held_gradient.row(row).cwiseAbs().maxCoeff();
      rows.row(i) = at_.held_gradient.row(row) / size;
      right(i) = change(row) / size;
    }
    const Matrix<Real> gram = rows * rows.transpose();
    return rows.transpose() * gram.partialPivLu().solve(right);
  }

  const BentStructure<Real>* model_;
  Vector<Real> none_;
  BentExpansion<Real> at_;
  IndependentRows<Real> all_;
  std::vector<Eigen::Index> clear_;
};

}  // namespace detail

/// Whether a shape is singular, as far as it is known: Newton's method holds what is held to 1e5 units in the
/// last place, and where the gradients vanish that leaves the shape open by the square root. A pivot grows
/// with the distance from a singular shape; so one is as near as that where a pivot is smaller than that
/// share of its like a given distance beside.
/// \param model  may have more digits than the shape: then ranks are judged in these
/// \param x      unknowns of the model, as they were found in their own digits
template <Floating Wide, Floating Real>
bool is_singular(const BentStructure<Wide>& model, const Vector<Real>& x) {
  using std::sqrt;
  if (model.held() == 0) return false;
  const Wide distance = Wide(1) / Wide(16);
  const Wide near = Wide(sqrt(Real(1e5) * epsilon<Real>()));
  const Vector<Wide> here = x.template cast<Wide>();
  detail::ClearlyHeld<Wide> held(model, here);
  const auto beside = held.beside(here + distance * held.motion());
  for (std::size_t i = 0; i < beside.pivot.size(); ++i) {
    const Wide pivot = i < held.all().pivot.size() ? held.all().pivot[i] : Wide(0);
    if (pivot * distance < near * beside.pivot[i]) return true;
  }
  return false;
}

}  // namespace plumbline
