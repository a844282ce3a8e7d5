#include "simulator/effect.hpp"

namespace plumbline::simulator {

Effect Effect::scaled(double factor) const {
  Effect other = *this;
  for (std::size_t p = 0; p < values.size(); ++p)
    if (kind->amplitude[p])
      other.values[p] = significant(values[p] * (kind->inverse ? 1 / factor : factor), 4);
  return other;
}

Effect draw_effect(const Kind& kind, const Scene& scene, Random& random) {
  std::vector<std::size_t> places;
  for (std::size_t j = 0; j < (kind.at_joint ? scene.plan.size() : 1); ++j)
    if (kind.possible(scene, j)) places.push_back(j);
  if (places.empty()) return {nullptr, 0, {}};
  const std::size_t joint = random.one_of(places);
  return {&kind, joint, kind.draw(scene, joint, random)};
}

Physics physics_with(const Plan& plan, const std::vector<Effect>& effects) {
  Physics is = physics_of(plan);
  for (const Effect& effect : effects) effect.kind->add(is, plan, effect.joint, effect.values);
  return is;
}

}  // namespace plumbline::simulator
