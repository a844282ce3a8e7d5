#include "diagnose/inference/rival.hpp"

#include <algorithm>

namespace plumbline::diagnose {

bool covers(const EffectAt& whole, const EffectAt& part) {
  const std::vector<std::string_view>& special = whole.effect->special;
  return whole == part || std::find(special.begin(), special.end(), part.effect->id) != special.end();
}

}  // namespace plumbline::diagnose
