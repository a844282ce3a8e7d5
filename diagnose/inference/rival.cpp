#include "diagnose/inference/rival.hpp"

#include <algorithm>

namespace plumbline::diagnose {

bool covers(const EffectAt& whole, const EffectAt& part) {
  const std::vector<std::string_view>& special = whole.effect->special;
  return whole == part || std::find(special.begin(), special.end(), part.effect->id) != special.end();
}

std::size_t many_valued(const Study& study, const Candidate& candidate) {
  constexpr std::size_t few = 4;
  const auto count = std::count_if(
      candidate.effects.begin(), candidate.effects.end(),
      [&](const EffectAt& at) { return !candidate.has_as_machining(at) && study.ranges(at).size() > few; });
  return static_cast<std::size_t>(count);
}

}  // namespace plumbline::diagnose
