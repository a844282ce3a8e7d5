/// \file
/// Section 5: straight chains in space, by the kinematics of rotations about axes of any direction.

#include <fmt/core.h>

#include <array>
#include <functional>
#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/straight_space.hpp"
#include "verify/claims/claims.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

using Point3 = std::array<Interval, 3>;

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A chain that is straight along x at rest. Joint i turns about its own axis, normal to x: the joints of
/// each of two planes through x bend the chain in that plane.
struct SpatialChain {
  std::vector<Rational> length{2, 3, 1, 4, 2, 1}, stiffness{1, 2, 3, 1, 2, 4};
  std::vector<int> plane{1, 2, 1, 2, 2, 1};
  Interval angle;  ///< between the planes

  [[nodiscard]] std::size_t size() const { return length.size(); }
  [[nodiscard]] Point3 axis(std::size_t i) const {
    if (plane[i] == 1) return {Interval(0), Interval(0), Interval(1)};
    return {Interval(0), -sin(angle), cos(angle)};
  }
  /// Distance of the end point from joint i along the straight chain.
  [[nodiscard]] Interval to_end(std::size_t i) const {
    Rational sum = 0;
    for (std::size_t j = i; j < size(); ++j) sum += length[j];
    return Interval(sum);
  }
};

const Point3 along{Interval(1), Interval(0), Interval(0)};

/// First derivative of the end point by q_i at the straight shape.
Point3 first_derivative(const SpatialChain& chain, std::size_t i) {
  Point3 d = cross(chain.axis(i), along);
  for (Interval& x : d) x *= chain.to_end(i);
  return d;
}

/// Second derivative of the end point's x by q_i and q_j there: of the product of the rotations.
Interval second_derivative(const SpatialChain& chain, std::size_t i, std::size_t j) {
  const auto [first, last] = std::minmax(i, j);
  return cross(chain.axis(first), cross(chain.axis(last), along))[0] * chain.to_end(last);
}

/// K + F d^2 x: the second variation of the potential under the compression F, whose lateral parts vanish at
/// the straight shape.
Matrix<Interval> second_variation(const SpatialChain& chain, const Interval& F) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  Matrix<Interval> H(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j)
      H(i, j) = F * second_derivative(chain, static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    H(i, i) += Interval(chain.stiffness[static_cast<std::size_t>(i)]);
  }
  return H;
}

/// A basis of the small turns that leave the end point on the axis: the first joint of either plane is
/// eliminated.
Matrix<Interval> kept_directions(const SpatialChain& chain) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  const Point3 a = first_derivative(chain, 0), b = first_derivative(chain, 1);  // planes 1 and 2
  const Interval determinant = a[1] * b[2] - a[2] * b[1];
  Matrix<Interval> basis = Matrix<Interval>::Constant(n, n - 2, Interval(0));
  for (Eigen::Index column = 0; column < n - 2; ++column) {
    const Point3 d = first_derivative(chain, static_cast<std::size_t>(column + 2));
    basis(0, column) = -(d[1] * b[2] - d[2] * b[1]) / determinant;
    basis(1, column) = -(a[1] * d[2] - a[2] * d[1]) / determinant;
    basis(column + 2, column) = Interval(1);
  }
  return basis;
}

/// Negative directions of the second variation with the end point kept on the axis; nothing where a pivot may
/// be zero.
std::optional<std::size_t> negative_directions(const SpatialChain& chain, const Interval& F) {
  const Matrix<Interval> basis = kept_directions(chain);
  const Matrix<Interval> H = second_variation(chain, F);
  Matrix<Interval> form = Matrix<Interval>::Constant(basis.cols(), basis.cols(), Interval(0));
  for (Eigen::Index a = 0; a < form.rows(); ++a)
    for (Eigen::Index b = 0; b < form.cols(); ++b)
      for (Eigen::Index i = 0; i < H.rows(); ++i)
        for (Eigen::Index j = 0; j < H.cols(); ++j) form(a, b) += basis(i, a) * H(i, j) * basis(j, b);
  std::size_t negative = 0;
  for (Eigen::Index i = 0; i < form.rows(); ++i) {
    if (form(i, i).contains_zero()) return std::nullopt;
    negative += certainly_negative(form(i, i)) ? 1 : 0;
    for (Eigen::Index j = i + 1; j < form.rows(); ++j) {
      const Interval factor = form(j, i) / form(i, i);
      for (Eigen::Index c = i; c < form.rows(); ++c) form(j, c) -= factor * form(i, c);
    }
  }
  return negative;
}

/// The lowest critical force, to 1e-12.
Interval lowest_force(const SpatialChain& chain) {
  Rational low = 0, high = 10;
  while (high - low > Rational(1, 1000000000000)) {
    const Rational middle = (low * 61 + high * 66) / 127;  // no round number, where a pivot might vanish
    const auto count = negative_directions(chain, Interval(middle));
    if (!count) throw Error("spatial chain", "an open pivot at " + middle.str(), "a decided one");
    (*count == 0 ? low : high) = middle;
  }
  return hull(Interval(low), Interval(high));
}

/// The joints of one plane, the links between them merged.
Chain<Rational> planar_part(const SpatialChain& chain, int plane) {
  std::vector<Rational> length, stiffness;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain.plane[i] == plane) {
      length.emplace_back(0);
      stiffness.push_back(chain.stiffness[i]);
    }
    if (!length.empty()) length.back() += chain.length[i];
  }
  return Chain<Rational>(length, stiffness);
}

Interval degrees(int angle) {
  return Interval(Rational(angle, 180)) * Interval::pi();
}

SpatialChain spatial_chain(const Interval& angle) {
  SpatialChain chain;
  chain.angle = angle;
  return chain;
}

/// The chain with its planes at the angle whose cosine is 3/5, in fractions; its links weigh so much each,
/// and it stands upright.
proofs::StraightSpace in_fractions(const SpatialChain& chain, const Rational& weight) {
  const std::size_t n = chain.size();
  std::vector<SpaceJoint<Rational>> joints;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational y = chain.plane[i] == 1 ? Rational(0) : Rational(-4, 5),
                   z = chain.plane[i] == 1 ? 1 : Rational(3, 5);
    joints.push_back({{{{0, y, z}, chain.stiffness[i]}}});
  }
  SpaceStructure<Rational> structure(SpaceChain<Rational>(chain.length, std::move(joints)));
  structure.add_compression();
  for (std::size_t link = 1; link <= n; ++link) structure.add_weight(link, {-weight, 0, 0}, false);
  return proofs::StraightSpace(structure);
}

Judgement minimum_of_planes(const Printed& printed, int digits) {
  std::vector<Interval> planar;
  for (const int plane : {1, 2}) {
    const auto force =
        proofs::enclose_critical_forces(planar_part(spatial_chain(degrees(90)), plane), 1, 30).front();
    planar.push_back(hull(Interval(force.low), Interval(force.high)));
  }
  const Interval least = certainly_less(planar[0], planar[1]) ? planar[0] : planar[1];
  std::string list;
  std::size_t below = 0, above = 0, alike = 0;
  for (const int angle : {90, 60, 30}) {
    const Interval force = lowest_force(spatial_chain(degrees(angle)));
    (certainly_less(force, least) ? below : certainly_less(least, force) ? above : alike) += 1;
    list += fmt::format("{}{} at {} degrees", list.empty() ? "" : ", ", certified_decimal(force, 6), angle);
  }
  const std::string word = printed.at(0);
  const bool somewhere = (word == "minimum" && alike > 0) || (word == "below the minimum" && below > 0) ||
                         (word == "above the minimum" && above > 0);
  const bool everywhere = somewhere && (alike == 3 || below == 3 || above == 3);
  return {everywhere                       ? Verdict::confirmed
          : somewhere && word == "minimum" ? Verdict::imprecise
                                           : Verdict::refuted,
          everywhere
              ? ""
              : "so for planes at a right angle; at any other they couple, and the chain can buckle below "
                "the minimum: six links have " +
                    list + ", against " + certified_decimal(least, 6) + " of the planar sub-chains",
          {Evidence::by_theorem("Decomposition", "axes in two orthogonal directions do not couple"),
           {EvidenceKind::interval,
            "six links, L = (2, 3, 1, 4, 2, 1), k = (1, 2, 3, 1, 2, 4), joints in planes 1, 2, 1, 2, 2, 1: "
            "negative directions of the second variation of the product of rotations, end point kept on the "
            "axis, bisected in intervals: " +
                list + "; planar sub-chains by exact counts: " + certified_decimal(planar[0], 6) + " and " +
                certified_decimal(planar[1], 6)},
           {EvidenceKind::exact, "the same chain with the cosine 3/5 between the planes, by exact counts: " +
                                     in_fractions(spatial_chain(Interval(0)), 0).in_decimals(1, 6)[0].force}},
          certified_decimal(lowest_force(spatial_chain(degrees(60))), std::min(digits, 11)) +
              " with planes at 60 degrees"};
}

/// Gradient by the joint angles of sum k q^2 / 2 + F x + Fy y + Fz z at any shape: the exact kinematics.
std::vector<Interval> moments(const SpatialChain& chain, const std::vector<Interval>& q,
                              const Point3& force) {
  const std::size_t n = chain.size();
  std::vector<Point3> axes, joints{{Interval(0), Interval(0), Interval(0)}};
  std::array<Point3, 3> frame{
      Point3{Interval(1), Interval(0), Interval(0)}, Point3{Interval(0), Interval(1), Interval(0)},
      Point3{Interval(0), Interval(0), Interval(1)}};  // columns of the rotation so far
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 local = chain.axis(i);
    Point3 axis{Interval(0), Interval(0), Interval(0)};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t r = 0; r < 3; ++r) axis[r] += frame[c][r] * local[c];
    axes.push_back(axis);
    for (Point3& column : frame) {  // Rodrigues: the frame turned about the axis by q_i
      const Point3 side = cross(axis, column), back = cross(axis, side);
      for (std::size_t r = 0; r < 3; ++r)
        column[r] += sin(q[i]) * side[r] + (Interval(1) - cos(q[i])) * back[r];
    }
    Point3 next = joints.back();
    for (std::size_t r = 0; r < 3; ++r) next[r] += Interval(chain.length[i]) * frame[0][r];
    joints.push_back(next);
  }
  std::vector<Interval> gradient;
  for (std::size_t i = 0; i < n; ++i) {
    Point3 arm;
    for (std::size_t r = 0; r < 3; ++r) arm[r] = joints.back()[r] - joints[i][r];
    const Point3 d = cross(axes[i], arm);
    gradient.push_back(Interval(chain.stiffness[i]) * q[i] + force[0] * d[0] + force[1] * d[1] +
                       force[2] * d[2]);
  }
  return gradient;
}

/// Whether moments and linear form part by terms of second order only.
Judgement linear_equation(const Printed& printed, int) {
  const SpatialChain chain = spatial_chain(degrees(60));
  const Interval F(Rational(3, 5));
  const Matrix<Interval> H = second_variation(chain, F);
  const std::vector<int> turn{3, -1, 2, -2, 1, -3};
  const auto remainder = [&](const Rational& small) {
    std::vector<Interval> q;
    for (const int t : turn) q.emplace_back(Rational(t * small));
    // lateral forces of first order
    const Point3 force{F, Interval(small), Interval(Rational(-2 * small))};
    const std::vector<Interval> exact = moments(chain, q, force);
    Interval most(0);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      Interval straight(0);
      for (std::size_t j = 0; j < chain.size(); ++j)
        straight += H(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) * q[j];
      const Point3 d = first_derivative(chain, i);
      straight += force[1] * d[1] + force[2] * d[2];
      most += sqr(exact[i] - straight);
    }
    return sqrt(most);
  };
  const Interval far = remainder(Rational(1, 1000)), near = remainder(Rational(1, 10000));
  const bool second_order = certainly_less(Interval(50) * near, far);
  return judge_word(
      printed.at(0), second_order ? "linear" : "another", "it has other terms of first order",
      {{EvidenceKind::interval,
        fmt::format("six links, planes at 60 degrees, F = 0.6: moments by the exact rotations less "
                    "K q + F d^2x q + lateral forces: {} at turns of 1e-3, {} at 1e-4: second order",
                    certified_decimal(far, 3), certified_decimal(near, 3))}});
}

/// Whether the loss of stability is that of a pencil on the n - 2 free directions: as many forces.
Judgement by_eigenvalues(const Printed& printed, int) {
  bool all = true;
  std::string list;
  for (const int angle : {90, 60, 30}) {
    const SpatialChain chain = spatial_chain(degrees(angle));
    const auto none = negative_directions(chain, Interval(Rational(1, 100))),
               every = negative_directions(chain, Interval(Rational(100)));
    all = all && none == std::size_t{0} && every == chain.size() - 2;
    list += fmt::format("{}{} at {} degrees", list.empty() ? "" : ", ", every.value_or(0), angle);
  }
  const std::size_t size = spatial_chain(Interval(0)).size();
  const Rational weight(1, 50);
  const auto light = in_fractions(spatial_chain(Interval(0)), 0),
             heavy = in_fractions(spatial_chain(Interval(0)), weight);
  all = all && light.modes() == size - 2 && heavy.modes() == size - 2;
  return judge_word(
      printed.at(0), all ? "eigenvalues" : "another", "they are not the eigenvalues of a pencil",
      {{EvidenceKind::interval,
        "K - F M, symmetric, M = -d^2x, on the directions that keep the end point on the axis: no "
        "negative direction at F = 0.01; at F = 100, of four possible, " +
            list + ": so many eigenvalues lie in between"},
       {EvidenceKind::exact, fmt::format("the planes at the cosine 3/5, in fractions: {} positive "
                                         "eigenvalues, the lowest {}; standing upright, "
                                         "each link of weight {}: {}, the lowest {}",
                                         light.modes(), light.in_decimals(1, 6)[0].force, weight.str(),
                                         heavy.modes(), heavy.in_decimals(1, 6)[0].force)}});
}

}  // namespace

Checks claims::spatial_chains() {
  return {
      {"spatial-minimum", minimum_of_planes},
      {"spatial-linear", linear_equation},
      {"spatial-eigenvalues", by_eigenvalues},
  };
}

}  // namespace plumbline::verify
