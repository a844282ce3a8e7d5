#include "trial/simulator/effect.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::simulator {

std::string Kind::name(const Plan& plan, std::size_t parameter) const {
  if (parameter < names.size()) return std::string(names[parameter]);
  const std::size_t after = parameter - names.size(), which = after / each.size();
  const auto counted = [](std::size_t index) { return "_" + std::to_string(index + 1); };
  const std::string of(each[after % each.size()]);
  return of + (by_run ? counted(which / plan.size()) + counted(which % plan.size()) : counted(which));
}

bool Kind::scales(std::size_t parameter) const {
  if (parameter < names.size()) return amplitude[parameter];
  return amplitude[names.size() + (parameter - names.size()) % each.size()];
}

const Kind& kind(std::string_view id, bool at_joint) {
  for (const Kind& one : catalogue())
    if (one.id == id && one.at_joint == at_joint) return one;
  throw Error(std::string(id), at_joint ? "no such effect at a joint" : "no such effect",
              "one of the catalogue");
}

Effect Effect::scaled(double factor) const {
  Effect other = *this;
  for (std::size_t p = 0; p < values.size(); ++p)
    if (kind->scales(p)) other.values[p] = significant(values[p] * (kind->inverse ? 1 / factor : factor), 4);
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
