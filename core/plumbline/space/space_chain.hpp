#pragma once
/// \file
/// A serial chain in space: rigid links, and at each joint one to three axes with a spring each.
///
/// \code{.cpp}
/// // Two links on universal joints that are twice as stiff about z as about y.
/// const SpaceJoint<double> universal{{{{0, 0, 1}, 2, 0}, {{0, 1, 0}, 1, 0}}};
/// const SpaceChain<double> chain({1, 1}, {universal, universal});
/// assert(chain.freedoms() == 4);
/// \endcode

#include <array>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <vector>

namespace plumbline {

/// An axis that a joint turns about, with its spring.
template <Number Real>
struct Axis {
  std::array<Real, 3> direction;  ///< of any length, where the chain is straight: its links lie along x
  Real stiffness;                 ///< per radian; zero is passive
  Real rest{0};                   ///< angle at which the spring is slack
};

/// Axes that are turned about one after the other: each is carried by those before it.
template <Number Real>
struct SpaceJoint {
  std::vector<Axis<Real>> axes;  ///< one to three, the first of them next to the base
};

/// Links and joints, from the base on; joint i carries link i.
template <Number Real>
struct SpaceChain {
  std::vector<Real> length;             ///< L_1 … L_n
  std::vector<SpaceJoint<Real>> joint;  ///< joints 1 … n

  /// \throws Error that names the place
  SpaceChain(std::vector<Real> lengths, std::vector<SpaceJoint<Real>> joints)
      : length(std::move(lengths)), joint(std::move(joints)) {
    if (length.empty() || length.size() != joint.size())
      throw Error("joints", std::to_string(joint.size()) + " of them", "one for each link, one or more");
    for (std::size_t i = 0; i < size(); ++i) {
      const std::string number = std::to_string(i + 1);
      if (!(length[i] > Real(0)))
        throw Error("lengths, entry " + number, "a value that is not positive", "a length");
      if (joint[i].axes.empty() || joint[i].axes.size() > 3)
        throw Error("joint " + number, std::to_string(joint[i].axes.size()) + " axes", "one to three");
      for (const Axis<Real>& axis : joint[i].axes) {
        const auto& d = axis.direction;
        if (d[0] == Real(0) && d[1] == Real(0) && d[2] == Real(0))
          throw Error("joint " + number, "an axis without a direction", "a vector that is not zero");
        if (axis.stiffness < Real(0))
          throw Error("joint " + number, "a negative stiffness", "zero or positive");
      }
    }
  }

  [[nodiscard]] std::size_t size() const { return length.size(); }  ///< links
  /// Axes of all joints.
  [[nodiscard]] std::size_t freedoms() const {
    std::size_t count = 0;
    for (const SpaceJoint<Real>& one : joint) count += one.axes.size();
    return count;
  }
};

/// The same chain in another number type, number by number.
template <Number To, Number From, class Convert>
SpaceChain<To> convert(const SpaceChain<From>& chain, Convert one) {
  std::vector<To> length;
  std::vector<SpaceJoint<To>> joints;
  for (const From& L : chain.length) length.push_back(one(L));
  for (const SpaceJoint<From>& joint : chain.joint) {
    joints.emplace_back();
    for (const Axis<From>& axis : joint.axes)
      joints.back().axes.push_back({{one(axis.direction[0]), one(axis.direction[1]), one(axis.direction[2])},
                                    one(axis.stiffness),
                                    one(axis.rest)});
  }
  return SpaceChain<To>(std::move(length), std::move(joints));
}

}  // namespace plumbline
