#include "diagnose/draft/joint_columns.hpp"

#include <algorithm>

namespace plumbline::diagnose {

std::vector<std::size_t> joint_columns(const std::vector<ColumnWords>& words, Kind kind, bool commanded,
                                       std::size_t joints) {
  std::vector<std::size_t> numbered(joints, words.size()), all;
  for (std::size_t c = 0; c < words.size(); ++c) {
    if (words[c].kind != kind || words[c].commanded != commanded) continue;
    all.push_back(c);
    const std::size_t joint = words[c].joint;
    if (joint > 0 && joint <= joints && numbered[joint - 1] == words.size()) numbered[joint - 1] = c;
  }
  const bool each = std::find(numbered.begin(), numbered.end(), words.size()) == numbered.end();
  if (each) return numbered;
  return all.size() == joints ? all : std::vector<std::size_t>();
}

}  // namespace plumbline::diagnose
