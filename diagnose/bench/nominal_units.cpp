#include "diagnose/bench/nominal_units.hpp"

#include <utility>

namespace plumbline::diagnose {
namespace {

std::vector<double> in_si(std::vector<double> values, const Unit& unit) {
  for (double& value : values) value = in_si(value, unit);
  return values;
}

}  // namespace

std::vector<Origin> NominalUnits::origins(bool nominal) const {
  const auto origin = [](const char* key, const Unit& unit) {
    return Origin{key, "experiment.toml", unit.name, unit.in_si()};
  };
  if (!nominal) return {origin("rest", rest)};
  return {origin("link_length", link_length), origin("joint_stiffness", joint_stiffness),
          origin("link_mass", link_mass), origin("gravity", gravity), origin("rest", rest)};
}

NominalUnits read_nominal_units(const Section& root, bool slides) {
  const Section units = root.table_or_empty("units");
  units.allow_only({"link_length", "joint_stiffness", "link_mass", "gravity", "rest", "radius", "volume"});
  const auto unit = [&](const char* key, const Quantity& quantity) {
    return units.has(key) ? parse_unit(units.text(key, quantity.examples), quantity, units.place(key))
                          : si_unit(quantity);
  };
  return {unit("link_length", quantity::length),
          unit("joint_stiffness", slides ? quantity::sliding_stiffness : quantity::stiffness),
          unit("link_mass", quantity::mass), unit("gravity", quantity::acceleration),
          unit("rest", slides ? quantity::length : quantity::angle)};
}

NominalChain in_si(NominalChain chain, const NominalUnits& units) {
  if (chain.has_links()) chain.link_length = in_si(std::move(chain.link_length), units.link_length);
  chain.joint_stiffness = in_si(std::move(chain.joint_stiffness), units.joint_stiffness);
  chain.link_mass = in_si(std::move(chain.link_mass), units.link_mass);
  chain.rest = in_si(std::move(chain.rest), units.rest);
  for (double& component : chain.gravity) component = in_si(component, units.gravity);
  return chain;
}

}  // namespace plumbline::diagnose
