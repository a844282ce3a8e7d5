#pragma once
/// \file
/// Rows in which every joint or link has a value of its own.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// At least two elastic joints, two links: what is said of all of them is not said of one.
bool several_elastic(const Place& at);
bool several_links(const Place& at);

/// "a_1" for the first, "a_1_2" for the second of "a_1"; names live as long as the catalogue.
std::string_view numbered(std::string_view stem, std::size_t index);

/// What all joints or links share of such a parameter.
struct EachOne {
  std::string_view stem, unit;
  double tolerance, low, high;
  bool elastic = true;  ///< elastic joints alone
};

/// One value a joint, small by its tolerance.
std::vector<ParameterRange> each(const Place& at, const EachOne& one);

/// Calls `change` with each joint that has a value, from 0, and the value.
template <class Change>
void for_each_elastic(const Addition& to, Change change) {
  std::size_t p = 0;
  for (std::size_t i = 0; i < to.rig.length.size(); ++i)
    if (to.rig.stiffness[i] > 0) change(i, to.value[p++]);
}

}  // namespace plumbline::diagnose
