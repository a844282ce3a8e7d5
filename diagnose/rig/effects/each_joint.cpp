#include "diagnose/rig/effects/each_joint.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace plumbline::diagnose {

std::string_view kept(std::string text) {
  static std::map<std::string, std::string> all;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return all.try_emplace(text, text).first->second;
}

bool several_elastic(const Place& at) {
  return std::count_if(at.scales.joint_stiffness.begin(), at.scales.joint_stiffness.end(),
                       [](double k) { return k > 0; }) > 1;
}

bool several_links(const Place& at) {
  return at.scales.link_length.size() > 1;
}

bool has_links(const Place& at) {
  return at.scales.links;
}

std::string_view numbered(std::string_view stem, std::size_t index) {
  return kept(std::string(stem) + "_" + std::to_string(index + 1));
}

std::vector<ParameterRange> each(const Place& at, const EachOne& one) {
  std::vector<ParameterRange> all;
  for (std::size_t i = 0; i < at.scales.link_length.size(); ++i) {
    const bool held = one.elastic && !(at.scales.joint_stiffness[i] > 0);
    if (!held)
      all.push_back({numbered(one.stem, i), one.unit, Coordinate::plain, one.tolerance / 2, one.low, one.high,
                     one.tolerance});
  }
  return all;
}

}  // namespace plumbline::diagnose
