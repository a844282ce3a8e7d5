#include "diagnose/rig/effects/each_joint.hpp"

#include <map>
#include <mutex>

namespace plumbline::diagnose {

std::string_view kept(std::string text) {
  static std::map<std::string, std::string> all;
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  return all.try_emplace(text, text).first->second;
}

std::vector<std::string_view> along_axes(std::string_view stem, std::size_t axes) {
  std::vector<std::string_view> names;
  for (const char* axis : {"_x", "_y", "_z"})
    if (names.size() < axes) names.push_back(kept(std::string(stem) + axis));
  return names;
}

std::vector<ParameterRange> each_axis(ParameterKind kind, std::string_view stem, const Place& at) {
  return some_of(kind, along_axes(stem, at.scales.axes))(at);
}

std::string_view numbered(std::string_view stem, std::size_t index) {
  return kept(std::string(stem) + "_" + std::to_string(index + 1));
}

std::vector<ParameterRange> each(const Place& at, const EachOne& one) {
  std::vector<ParameterRange> all;
  for (std::size_t i = 0; i < at.scales.link_length.size(); ++i) {
    if (is_one(one.which, at.scales, i))
      all.push_back({numbered(one.stem, i), one.unit, Coordinate::plain, one.tolerance / 2, one.low, one.high,
                     one.tolerance});
  }
  return all;
}

}  // namespace plumbline::diagnose
