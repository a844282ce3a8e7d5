#pragma once
/// \file
/// Helpers for rows with one value a joint or link.

#include <array>

#include "diagnose/rig/effects/places.hpp"
#include "diagnose/rig/sizes.hpp"

namespace plumbline::diagnose {

inline Vector3<double> vector_of(const double* value) {
  return {value[0], value[1], value[2]};
}

/// The same text for the same text, for good.
std::string_view kept(std::string text);

/// "d_x", "d_y" … for the first axes.
std::vector<std::string_view> along_axes(std::string_view stem, std::size_t axes);
/// One parameter of that kind an axis: of the plane, or of space where axes have places there.
std::vector<ParameterRange> each_axis(ParameterKind kind, std::string_view stem, const Place& at);

/// "a_1" for the first value of stem "a"; the names live as long as the catalogue.
std::string_view numbered(std::string_view stem, std::size_t index);

/// Which joints have a value of their own.
enum class Which {
  elastic,   ///< those with a spring
  standing,  ///< those, and those that stand where they are commanded
  all
};

/// Properties that the parameters of all joints or links share.
struct EachOne {
  std::string_view stem, unit;
  double tolerance, low, high;
  Which which = Which::elastic;
};

/// Whether a joint is one of those.
inline bool is_one(Which which, const CharacteristicScales& sizes, std::size_t joint) {
  return which == Which::all || sizes.joint_stiffness[joint] > 0 ||
         (which == Which::standing && sizes.rigid[joint]);
}

/// One parameter a joint or link, with its tolerance as prior.
std::vector<ParameterRange> each(const Place& at, const EachOne& one);

/// Calls `change` with the number, from 0, and the value of each of those joints.
template <class Change>
void for_each(Which which, const Addition& to, Change change) {
  std::size_t p = 0;
  for (std::size_t i = 0; i < to.scales.joint_stiffness.size(); ++i)
    if (is_one(which, to.scales, i)) change(i, to.value[p++]);
}
template <class Change>
void for_each_elastic(const Addition& to, Change change) {
  for_each(Which::elastic, to, change);
}

}  // namespace plumbline::diagnose
