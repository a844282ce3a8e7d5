#include "app/space_file.hpp"

#include <algorithm>

#include "app/decimal_toml.hpp"
#include "app/structure_file.hpp"
#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

std::string place_of(const toml::node& node, const std::string& source, const std::string& key) {
  return files::place(node, source) + ": " + key;
}

std::vector<Rational> vector_of(const toml::node& node, const std::string& where) {
  std::vector<Rational> values;
  const toml::array* list = node.as_array();
  if (list == nullptr) throw Error(where, "no list", "three numbers in brackets");
  for (const toml::node& item : *list) add_joined(values, item.value_or(std::string("?")), where);
  if (values.size() != 3)
    throw Error(where, std::to_string(values.size()) + " numbers", "three: along x, y and z");
  return values;
}

SpaceJoint<Rational> read_joint(const toml::node& node, const std::string& source, std::size_t number) {
  const std::string where = place_of(node, source, "joint " + std::to_string(number));
  if (!node.is_table()) throw Error(where, "no table", "{ axes = [[0, 0, 1]], stiffness = [1] }");
  const toml::table& table = *node.as_table();
  files::refuse_unknown_keys(table, {"axes", "stiffness", "rest"}, source);
  const toml::array* axes = table["axes"].as_array();
  if (axes == nullptr) throw Error(where, "no list of axes", "axes = [[0, 0, 1], …], a vector each");
  const std::vector<Rational> stiffness = number_list(table, "stiffness", source);
  const auto rest = table.contains("rest") ? number_list(table, "rest", source)
                                           : std::vector<Rational>(stiffness.size(), Rational(0));
  if (stiffness.size() != axes->size() || rest.size() != axes->size())
    throw Error(
        where,
        std::to_string(stiffness.size()) + " stiffnesses and " + std::to_string(axes->size()) + " axes",
        "as many");
  SpaceJoint<Rational> joint;
  for (std::size_t a = 0; a < axes->size(); ++a) {
    const auto d = vector_of(*axes->get(a), where + ", axes");
    joint.axes.push_back({{d[0], d[1], d[2]}, stiffness[a], rest[a]});
  }
  return joint;
}

void read_ends(const toml::table& table, const std::string& source, SpaceCase& space) {
  const std::string base = table["base"].value_or(std::string("jointed"));
  if (base != "jointed" && base != "clamped")
    throw Error(place_of(*table.get("base"), source, "base"), files::shown(base),
                "\"jointed\" (in joint 1) or \"clamped\" (link 1 held)");
  space.straight.base_clamped = space.setting.base_clamped = base == "clamped";
  const std::string end = table["end_point"].value_or(std::string("guided"));
  const std::size_t n = space.chain.size();
  if (end == "free") {
    space.straight.end_point = {};
  } else if (end == "guided" || end == "clamped") {
    for (const int coordinate : {1, 2})
      space.setting.holds.push_back({n, coordinate, Restraint<Rational>::held()});
    if (end == "clamped") {
      space.straight.end_point = clamped<Rational>();
      space.setting.directions = {1, 2};
    }
  } else {
    throw Error(place_of(*table.get("end_point"), source, "end_point"), files::shown(end),
                "\"guided\", \"free\" or \"clamped\"");
  }
  space.words = "in space, base " + base + ", end point " + end;
}

void hold_across(SpaceCase& space, std::size_t node, const Restraint<Rational>& restraint) {
  if (restraint.is_free()) return;
  for (const int coordinate : {1, 2}) space.setting.holds.push_back({node, coordinate, restraint});
}

void read_supports(const toml::table& table, const std::string& source, SpaceCase& space) {
  const toml::node* node = table.get("supports");
  if (node == nullptr) return;
  const std::string where = place_of(*node, source, "supports"),
                    expected = "tables { at = JOINT, across = … }";
  if (!node->is_array()) throw Error(where, "no list", expected);
  space.straight.across.resize(space.chain.size() - 1);
  for (const toml::node& item : *node->as_array()) {
    const toml::table* one = item.as_table();
    if (one == nullptr || !one->contains("at") || !one->contains("across"))
      throw Error(where, "something else", expected);
    files::refuse_unknown_keys(*one, {"at", "across"}, source);
    const std::size_t at = read_node(*one->get("at"), where + ", at", space.chain.size());
    if (at == space.chain.size()) throw Error(where, "one at the end point", "end_point for that");
    space.straight.across[at - 1] = read_restraint(*one->get("across"), where + ", across");
    hold_across(space, at, space.straight.across[at - 1]);
  }
  space.words += ", " + std::to_string(node->as_array()->size()) + " supports";
}

void read_foundation(const toml::table& table, const std::string& source, SpaceCase& space) {
  const toml::node* node = table.get("foundation");
  if (node == nullptr) return;
  const Rational bed = number_of(*node, place_of(*node, source, "foundation"));
  const std::size_t n = space.chain.size();
  if (bed < 0)
    throw Error(place_of(*node, source, "foundation"), "a negative value", "a stiffness per length");
  space.straight.across.resize(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    Restraint<Rational>& across = last ? space.straight.end_point.across : space.straight.across[i];
    if (across.is_held()) continue;
    const Rational share =
        bed * (space.chain.length[i] + (last ? Rational(0) : space.chain.length[i + 1])) / 2;
    across = Restraint<Rational>::sprung(across.stiffness + share);
    hold_across(space, i + 1, Restraint<Rational>::sprung(share));
  }
  space.words += ", elastic bed";
}

void add_force(SpaceCase& space, std::size_t node, const std::vector<Rational>& f, bool multiplied) {
  space.setting.forces.push_back({node, {f[0], f[1], f[2]}, multiplied});
  space.axial = space.axial && f[1] == 0 && f[2] == 0;
  auto& N = multiplied ? space.straight.compression.multiplied : space.straight.compression.fixed;
  for (std::size_t link = 0; link < node; ++link) N[link] -= f[0];
}

TorqueKind torque_kind(const toml::node& node, const std::string& where) {
  const std::string kind = node.value_or(std::string());
  if (kind == "axial") return TorqueKind::axial;
  if (kind == "tangential") return TorqueKind::tangential;
  if (kind == "semitangential") return TorqueKind::semitangential;
  throw Error(where + ", torque", files::shown(kind), "\"axial\", \"tangential\" or \"semitangential\"");
}

void read_loads(const toml::table& table, const std::string& source, SpaceCase& space) {
  const std::size_t n = space.chain.size();
  space.straight.compression = {std::vector<Rational>(n), std::vector<Rational>(n)};
  const toml::node* node = table.get("loads");
  if (node == nullptr) {
    space.words += ", dead force at the end point";
    return add_force(space, n, {-1, 0, 0}, true);
  }
  const std::string where = place_of(*node, source, "loads");
  if (!node->is_array()) throw Error(where, "no list", "a list of tables, such as [{ force = [-1, 0, 0] }]");
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) throw Error(where, "no table", "{ force = [-1, 0, 0] }");
    const toml::table& load = *item.as_table();
    files::refuse_unknown_keys(load, {"at", "force", "weight", "fixed", "torque"}, source);
    if (load.contains("torque")) {
      if (node->as_array()->size() > 1) throw Error(where, "a torque beside other loads", "a torque alone");
      space.torque = torque_kind(*load.get("torque"), where);
      space.words += ", " + load["torque"].value_or(std::string()) + " torque at the end point";
      return;
    }
    if (load.contains("force") == load.contains("weight"))
      throw Error(where, "not one of force and weight", "one");
    const bool multiplied = !load["fixed"].value_or(false);
    if (load.contains("weight")) {
      auto half = vector_of(*load.get("weight"), where + ", weight");
      for (Rational& x : half) x /= 2;
      for (std::size_t link = 1; link <= n; ++link) {
        if (link > 1) add_force(space, link - 1, half, multiplied);
        add_force(space, link, half, multiplied);
      }
      continue;
    }
    const std::size_t at = load.contains("at") ? read_node(*load.get("at"), where + ", at", n) : n;
    add_force(space, at, vector_of(*load.get("force"), where + ", force"), multiplied);
  }
  space.words += ", " + std::to_string(node->as_array()->size()) + " loads";
}

}  // namespace

bool is_space_chain(const std::string& text, const std::string& source) {
  return text.find("joints") != std::string::npos && parse_decimal_toml(text, source).contains("joints");
}

SpaceCase parse_space_chain(const std::string& text, const std::string& source) {
  const toml::table table = parse_decimal_toml(text, source);
  files::refuse_unknown_keys(
      table, {"lengths", "joints", "base", "end_point", "supports", "foundation", "loads"}, source);
  const toml::array* list = table["joints"].as_array();
  if (list == nullptr) throw Error(source, "no list joints", "one of tables with axes and stiffness");
  std::vector<SpaceJoint<Rational>> joints;
  for (const toml::node& node : *list) joints.push_back(read_joint(node, source, joints.size() + 1));
  SpaceCase space{[&] {
                    const auto lengths = number_list(table, "lengths", source);
                    try {
                      return SpaceChain<Rational>(lengths, joints);
                    } catch (const Error& error) {
                      throw Error(source + ": " + error.what());
                    }
                  }(),
                  {},
                  {},
                  {},
                  true,
                  {}};
  read_ends(table, source, space);
  read_supports(table, source, space);
  read_foundation(table, source, space);
  read_loads(table, source, space);
  return space;
}

BentStructure<double> bent_structure(const SpaceCase& space) {
  const auto one = [](const Rational& x) { return from_rational<double>(x); };
  SpaceSetting<double> setting;
  for (const auto& hold : space.setting.holds)
    setting.holds.push_back(
        {hold.node, hold.coordinate, {hold.restraint.hold, one(hold.restraint.stiffness)}});
  for (const auto& force : space.setting.forces)
    setting.forces.push_back(
        {force.node, {one(force.force(0)), one(force.force(1)), one(force.force(2))}, force.multiplied});
  setting.directions = space.setting.directions;
  setting.base_clamped = space.setting.base_clamped;
  return BentStructure<double>(convert<double>(space.chain, one), std::move(setting));
}

}  // namespace plumbline::app
