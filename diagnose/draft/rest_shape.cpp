#include "diagnose/draft/rest_shape.hpp"

#include <cmath>

namespace plumbline::diagnose {

using Values = std::vector<double>;

std::array<double, 2> end_point(const NominalChain& chain, const Values& rest) {
  std::array<double, 2> end{0, 0};
  double direction = 0;
  for (std::size_t j = 0; j < chain.link_length.size(); ++j) {
    direction += j < rest.size() ? rest[j] : 0;
    end[0] += chain.link_length[j] * std::cos(direction);
    end[1] += chain.link_length[j] * std::sin(direction);
  }
  return end;
}

std::optional<Values> reaching(const NominalChain& chain, const Values& near, std::array<double, 2> end) {
  const double distance = std::hypot(end[0], end[1]), direction = std::atan2(end[1], end[0]);
  if (chain.link_length.size() == 1) return Values{direction};
  if (chain.link_length.size() != 2) return {};
  const double a = chain.link_length[0], b = chain.link_length[1];
  const double cosine = (distance * distance - a * a - b * b) / (2 * a * b);
  if (std::abs(cosine) > 1) return {};
  std::optional<Values> best;
  const auto away = [&](const Values& q) { return std::hypot(q[0] - near[0], q[1] - near[1]); };
  for (const double sign : {1.0, -1.0}) {
    const double elbow = sign * std::acos(cosine);
    const Values q{direction - std::atan2(b * std::sin(elbow), a + b * std::cos(elbow)), elbow};
    if (!best || away(q) < away(*best)) best = q;
  }
  return best;
}

}  // namespace plumbline::diagnose
