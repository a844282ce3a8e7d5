#pragma once
/// \file
/// The planar serial chain: rigid links, linear torsion springs at the joints.
///
/// \code{.cpp}
/// const Chain<double> arch({0.3, 0.25}, {2.0, 1.5}, {0.4, -0.9});  // lengths, stiffnesses, rest angles
/// assert(arch.size() == 2 && arch.stiffness()[1] == 1.5);
///
/// // a chain of decimals that are meant exactly, and what becomes of it in doubles
/// const Chain<Rational> exact({Rational(1, 10), 1}, {0, 1});
/// assert(exact.passive_joint(0) && mode_count(exact) == 1);
/// assert(from_rational<double>(exact).length()[0] == 0.1);
/// \endcode

#include <algorithm>
#include <cstddef>
#include <plumbline/base/error.hpp>
#include <plumbline/base/interval.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <utility>
#include <vector>

namespace plumbline {

/// A serial chain of n links. Joint i carries link i; joint 1 sits on the base, the load acts on the free end
/// of link n. A stiffness of zero is a passive joint.
///
/// Units are the caller's, as long as they agree: [k] = force · length, per radian.
template <Number Real>
class Chain {
 public:
  /// \param length     L_1 … L_n, each positive and finite
  /// \param stiffness  k_1 … k_n, each non-negative and finite
  /// \param rest       joint angles of the unloaded shape, in radians; all zero (straight) when left out
  /// \throws Error that names the list and the place in it
  explicit Chain(std::vector<Real> length, std::vector<Real> stiffness, std::vector<Real> rest = {})
      : length_(std::move(length)), stiffness_(std::move(stiffness)), rest_(std::move(rest)) {
    if (length_.empty()) throw Error("lengths", "no link", "at least one");
    if (rest_.empty()) rest_.assign(length_.size(), Real(0));
    require_count("stiffness", stiffness_);
    require_count("rest", rest_);
    for (std::size_t i = 0; i < size(); ++i) {
      require_finite("lengths", i, length_[i]);
      require_finite("stiffness", i, stiffness_[i]);
      require_finite("rest", i, rest_[i]);
      if (!positive(length_[i]))
        throw Error(entry("lengths", i), "a value that is not positive", "a positive length");
      if (negative(stiffness_[i]))
        throw Error(entry("stiffness", i), "a negative value", "zero (passive) or positive");
    }
  }

  /// Number of links, n.
  [[nodiscard]] std::size_t size() const { return length_.size(); }
  /// L_1 … L_n.
  [[nodiscard]] const std::vector<Real>& length() const { return length_; }
  /// k_1 … k_n.
  [[nodiscard]] const std::vector<Real>& stiffness() const { return stiffness_; }
  /// Joint angles of the unloaded shape.
  [[nodiscard]] const std::vector<Real>& rest() const { return rest_; }

  /// Whether joint i (from 0) has no spring.
  [[nodiscard]] bool passive_joint(std::size_t i) const { return !positive(stiffness_[i]); }
  /// How many joints have no spring.
  [[nodiscard]] std::size_t passive_joints() const {
    return static_cast<std::size_t>(
        std::count_if(stiffness_.begin(), stiffness_.end(), [](const Real& k) { return !positive(k); }));
  }

 private:
  static bool positive(const Real& x) {
    if constexpr (Ordered<Real>) {
      return x > 0;
    } else {
      return certainly_positive(x);
    }
  }
  static bool negative(const Real& x) {
    if constexpr (Ordered<Real>) {
      return x < 0;
    } else {
      return certainly_negative(x);
    }
  }
  static std::string entry(const char* list, std::size_t i) {
    return std::string(list) + ", entry " + std::to_string(i + 1);
  }
  static void require_finite(const char* list, std::size_t i, const Real& x) {
    if (!is_finite(x)) throw Error(entry(list, i), "a value that is not finite", "a finite number");
  }
  void require_count(const std::string& list, const std::vector<Real>& values) const {
    if (values.size() != size()) {
      throw Error(list, std::to_string(values.size()) + " values", "one per link, " + std::to_string(size()));
    }
  }

  std::vector<Real> length_, stiffness_, rest_;
};

/// The same chain in another number type, entry by entry.
template <Number To, Number From, class Convert>
Chain<To> convert(const Chain<From>& chain, Convert convert_one) {
  const auto all = [&](const std::vector<From>& values) {
    std::vector<To> result;
    result.reserve(values.size());
    for (const From& value : values) result.push_back(convert_one(value));
    return result;
  };
  return Chain<To>(all(chain.length()), all(chain.stiffness()), all(chain.rest()));
}

/// An exact chain, rounded entry by entry to the nearest number of another type, or enclosed.
template <Number To>
Chain<To> from_rational(const Chain<Rational>& chain) {
  return convert<To>(chain, [](const Rational& value) {
    if constexpr (std::same_as<To, Interval>) {
      return Interval(value);
    } else {
      return from_rational<To>(value);
    }
  });
}

/// The number of buckling modes of the straight chain, n - 1.
/// \throws Error where there is none (n = 1) or the chain is a mechanism (two passive joints or more, which
///         move without any energy: det B = 0)
template <Number Real>
std::size_t mode_count(const Chain<Real>& chain) {
  if (chain.size() == 1)
    throw Error("chain", "one link", "two links or more: a single link has no buckling mode");
  if (chain.passive_joints() > 1) {
    throw Error("stiffness", std::to_string(chain.passive_joints()) + " passive joints",
                "at most one: with two the chain is a mechanism");
  }
  return chain.size() - 1;
}

/// z_i = L_i + … + L_n: the distance from joint i of the straight chain to its end point.
template <Number Real>
std::vector<Real> distance_to_end(const Chain<Real>& chain) {
  std::vector<Real> z(chain.size());
  Real sum(0);
  for (std::size_t i = chain.size(); i-- > 0;) z[i] = sum = sum + chain.length()[i];
  return z;
}

}  // namespace plumbline
