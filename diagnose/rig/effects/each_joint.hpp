#pragma once
/// \file
/// Helpers for rows with one value a joint or link.

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// At least two elastic joints, at least two links: with one, the row would repeat that of a single joint.
bool several_elastic(const Place& at);
bool several_links(const Place& at);

/// At least one link: a joint alone has none.
bool has_links(const Place& at);
/// The same text for the same text, for good.
std::string_view kept(std::string text);

/// "a_1" for the first value of stem "a"; the names live as long as the catalogue.
std::string_view numbered(std::string_view stem, std::size_t index);

/// Properties that the parameters of all joints or links share.
struct EachOne {
  std::string_view stem, unit;
  double tolerance, low, high;
  bool elastic = true;  ///< elastic joints alone
};

/// One parameter a joint or link, with its tolerance as prior.
std::vector<ParameterRange> each(const Place& at, const EachOne& one);

/// Calls `change` with the number, from 0, and the value of each elastic joint.
template <class Change>
void for_each_elastic(const Addition& to, Change change) {
  std::size_t p = 0;
  for (std::size_t i = 0; i < to.rig.length.size(); ++i)
    if (to.rig.stiffness[i] > 0) change(i, to.value[p++]);
}

}  // namespace plumbline::diagnose
