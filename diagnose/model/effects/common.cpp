/// \file
/// Effects that all joints or links share: one factor or offset for all, or a value of each within its
/// tolerance.

#include <algorithm>
#include <array>

#include "diagnose/beliefs.hpp"
#include "diagnose/model/effects/rows.hpp"

namespace plumbline::diagnose {
namespace {

using beliefs::stiffness_tolerance, beliefs::length_tolerance, beliefs::angle_tolerance;

bool several_elastic(const Place& at) {
  return std::count_if(at.sizes.joint_stiffness.begin(), at.sizes.joint_stiffness.end(),
                       [](double k) { return k > 0; }) > 1;
}

bool several_links(const Place& at) {
  return at.sizes.link_length.size() > 1;
}

/// "a_1" … "a_30": parameter names live as long as the catalogue.
std::string_view numbered(char letter, std::size_t joint) {
  constexpr std::size_t most = 1000;
  static const auto names = [] {
    std::array<std::vector<std::string>, 26> all;
    for (std::size_t l = 0; l < all.size(); ++l)
      for (std::size_t i = 1; i <= most; ++i)
        all[l].push_back(std::string(1, static_cast<char>('a' + l)) + "_" + std::to_string(i));
    return all;
  }();
  return names[static_cast<std::size_t>(letter - 'a')].at(joint);
}

/// One value a joint (passive ones have none of their own where `elastic`), small by its tolerance.
std::vector<ParameterRange> each(const Place& at, bool elastic, char letter, std::string_view unit,
                                 double tolerance, double low, double high) {
  std::vector<ParameterRange> all;
  for (std::size_t i = 0; i < at.sizes.link_length.size(); ++i) {
    const bool held = elastic && !(at.sizes.joint_stiffness[i] > 0);
    if (!held)
      all.push_back({numbered(letter, i), unit, Coordinate::plain, tolerance / 2, low, high, tolerance});
  }
  return all;
}

/// Calls `change` with each joint that has a value, and the value.
template <class Change>
void for_each(const Addition& to, bool elastic, Change change) {
  std::size_t p = 0;
  for (std::size_t i = 0; i < to.rig.length.size(); ++i)
    if (!elastic || to.rig.stiffness[i] > 0) change(i, to.value[p++]);
}

}  // namespace

std::vector<Effect> common_effects() {
  return {
      {.id = "stiffness_scale",
       .words = "all stiffnesses wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.1, -0.95, 9)}; },
       .add =
           [](const Addition& to) {
             for (double& k : to.rig.stiffness) k *= 1 + to.value[0];
           },
       .possible = several_elastic},
      {.id = "length_scale",
       .words = "all lengths wrong by one factor",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "ratio", 0.01, -0.3, 0.3)}; },
       .add =
           [](const Addition& to) {
             for (double& L : to.rig.length) L *= 1 + to.value[0];
           },
       .possible = several_links},
      {.id = "rest_offset",
       .words = "all rest angles off by the same angle",
       .parameters = [](const Place&) { return std::vector{both_ways("a", "rad", 0.03, -0.6, 0.6)}; },
       .add =
           [](const Addition& to) {
             for (double& error : to.rig.rest_error) error += to.value[0];
           },
       .possible = several_elastic},
      {.id = "stiffness_spread",
       .words = "stiffnesses that differ from joint to joint within their tolerance",
       .parameters =
           [](const Place& at) { return each(at, true, 'a', "ratio", stiffness_tolerance, -0.8, 2); },
       .add =
           [](const Addition& to) {
             for_each(to, true, [&](std::size_t i, double a) { to.rig.stiffness[i] *= 1 + a; });
           },
       .possible = several_elastic},
      {.id = "length_spread",
       .words = "lengths that differ from link to link within their tolerance",
       .parameters =
           [](const Place& at) { return each(at, false, 'a', "ratio", length_tolerance, -0.2, 0.2); },
       .add =
           [](const Addition& to) {
             for_each(to, false, [&](std::size_t j, double a) { to.rig.length[j] *= 1 + a; });
           },
       .possible = several_links},
      {.id = "rest_spread",
       .words = "rest angles that differ from joint to joint within their tolerance",
       .parameters = [](const Place& at) { return each(at, true, 'a', "rad", angle_tolerance, -0.3, 0.3); },
       .add =
           [](const Addition& to) {
             for_each(to, true, [&](std::size_t i, double a) { to.rig.rest_error[i] += a; });
           },
       .possible = several_elastic},
      {.id = "play",
       .words = "play in every joint",
       .parameters = [](const Place& at) { return each(at, true, 'b', "rad", angle_tolerance, 0, 0.4); },
       .add =
           [](const Addition& to) {
             for_each(to, true, [&](std::size_t i, double b) { to.rig.backlash[i] += b; });
           },
       .possible = several_elastic,
       .starts =
           [](const Place& at, const Exercise& nominal) {
             Starts starts{{}, 2};
             for (const double share : {0.05, 0.2}) {
               starts.from.emplace_back();
               for (std::size_t i = 0; i < at.sizes.joint_stiffness.size(); ++i)
                 if (at.sizes.joint_stiffness[i] > 0)
                   starts.from.back().push_back(share * nominal.deflection[i]);
             }
             return starts;
           }},
  };
}

}  // namespace plumbline::diagnose
