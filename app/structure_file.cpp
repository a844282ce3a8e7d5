#include "app/structure_file.hpp"

#include <algorithm>
#include <plumbline/structure/beam.hpp>
#include <set>

#include "app/decimal_toml.hpp"
#include "support/files/printable.hpp"

namespace plumbline::app {
namespace {

std::string word(const toml::node& node) {
  return node.value_or(std::string());
}

const toml::table& table_of(const toml::node& node, const std::string& where, const std::string& expected) {
  if (!node.is_table()) throw Error(where, files::shown(word(node)), expected);
  return *node.as_table();
}

void read_support(const toml::table& table, const std::string& key, const std::string& source,
                  Support<Rational>& support) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return;
  const std::string where = files::place(*node, source) + ": " + key;
  const bool base = key == "base";
  if (node->is_table()) {
    files::refuse_unknown_keys(*node->as_table(), {"along", "across", "turn"}, source);
    for (const auto& [name, restraint] :
         {std::pair("along", &support.along), std::pair("across", &support.across),
          std::pair("turn", &support.turn)}) {
      if (const toml::node* said = node->as_table()->get(name))
        *restraint = read_restraint(*said, files::place(*said, source) + ": " + key + "." + name);
    }
    return;
  }
  const std::string kind = word(*node);
  if (kind == "clamped") {
    support.turn = Restraint<Rational>::held();
  } else if (kind == "free" && !base) {
    support = {};
  } else if (!(base ? kind == "pinned" || kind == "sprung" : kind == "guided" || kind == "pinned")) {
    throw Error(where, files::shown(kind),
                std::string(base ? "\"pinned\", \"sprung\" (by the stiffness of joint 1), \"clamped\""
                                 : "\"guided\", \"free\", \"clamped\"") +
                    " or a table with along, across, turn");
  }
}

/// `base = "pinned"` says that joint 1 has no spring, "sprung" that it has one.
void require_base(const toml::table& table, const std::string& source, const Chain<Rational>& chain) {
  const toml::node* node = table.get("base");
  if (node == nullptr || node->is_table()) return;
  const std::string where = files::place(*node, source) + ": base";
  if (word(*node) == "pinned" && !chain.passive_joint(0))
    throw Error(where, "\"pinned\" beside a spring at joint 1", "stiffness 0 there, or \"sprung\"");
  if (word(*node) == "sprung" && chain.passive_joint(0))
    throw Error(where, "\"sprung\" without a spring at joint 1", "its stiffness there, or \"pinned\"");
}

void read_supports(const toml::table& table, const std::string& source, Structure<Rational>& structure) {
  const toml::node* node = table.get("supports");
  if (node == nullptr) return;
  const std::string where = files::place(*node, source) + ": supports";
  if (!node->is_array()) throw Error(where, "no list", "a list of tables { at = JOINT, across = … }");
  structure.across.resize(structure.chain.size() - 1);
  for (const toml::node& item : *node->as_array()) {
    const toml::table& one = table_of(item, where, "a table { at = JOINT, across = … }");
    files::refuse_unknown_keys(one, {"at", "across"}, source);
    if (!one.contains("at") || !one.contains("across"))
      throw Error(where, "one without at or across", "both");
    const std::size_t node_number = read_node(*one.get("at"), where + ", at", structure.chain.size());
    if (node_number == structure.chain.size())
      throw Error(where, "one at the end point", "end_point = { across = … } for that");
    structure.across[node_number - 1] = read_restraint(*one.get("across"), where + ", across");
  }
}

std::vector<Rational> list_of(const toml::table& table, const std::string& key, const std::string& source,
                              std::size_t count) {
  std::vector<Rational> values = number_list(table, key, source);
  if (values.size() != count)
    throw Error(files::place(*table.get(key), source) + ": " + key, std::to_string(values.size()) + " values",
                std::to_string(count));
  return values;
}

/// One number stands for all links.
std::vector<Rational> of_links(const toml::table& table, const std::string& key, const std::string& source,
                               std::size_t links) {
  const toml::node& node = *table.get(key);
  if (node.is_array()) return list_of(table, key, source, links);
  return std::vector<Rational>(links, number_of(node, files::place(node, source) + ": " + key));
}

Point<Rational> direction_of(const toml::table& load, const std::string& source) {
  if (!load.contains("direction")) return {-1, 0};
  const auto d = list_of(load, "direction", source, 2);
  const std::string where = files::place(*load.get("direction"), source) + ": direction";
  const Rational square = d[0] * d[0] + d[1] * d[1];
  if (square != 1) throw Error(where, "a vector whose length is not 1", "a unit vector, such as [-1, 0]");
  return {d[0], d[1]};
}

void read_load(const toml::table& load, const std::string& source, const std::string& where,
               Structure<Rational>& structure) {
  files::refuse_unknown_keys(load, {"at", "force", "follower", "moment", "weight", "direction", "fixed"},
                             source);
  int kinds = 0;
  for (const char* kind : {"force", "follower", "moment", "weight"}) kinds += load.contains(kind) ? 1 : 0;
  if (kinds != 1)
    throw Error(where, std::to_string(kinds) + " of force, follower, moment, weight in one load", "one");
  if (load.contains("direction") && !load.contains("weight"))
    throw Error(where, "a direction without a weight", "the direction in the force itself");
  const std::size_t n = structure.chain.size();
  const std::size_t node = load.contains("at") ? read_node(*load.get("at"), where + ", at", n) : n;
  const bool multiplied = !load["fixed"].value_or(false);
  if (load.contains("force")) {
    const auto f = list_of(load, "force", source, 2);
    structure.loads.push_back({node, {f[0], f[1]}, multiplied, LoadKind::dead});
  } else if (load.contains("follower")) {
    const Rational size = number_of(*load.get("follower"), where + ", follower");
    structure.loads.push_back({node, {-size, 0}, multiplied, LoadKind::follower});
  } else if (load.contains("moment")) {
    if (!multiplied || node != n)
      throw Error(where, "a moment that is fixed, or not at the end point",
                  "one at the end point, multiplied");
    structure.moment += number_of(*load.get("moment"), where + ", moment");
  } else {
    if (load.contains("at"))
      throw Error(where, "a weight at a joint", "a force for that: weight is of links");
    const auto weight = of_links(load, "weight", source, n);
    const Point<Rational> d = direction_of(load, source);
    for (std::size_t link = 1; link <= n; ++link)
      structure.add_weight(link, {weight[link - 1] * d.x, weight[link - 1] * d.y}, multiplied);
  }
}

void read_loads(const toml::table& table, const std::string& source, Structure<Rational>& structure) {
  const toml::node* node = table.get("loads");
  if (node == nullptr) return structure.add_compression();
  const std::string where = files::place(*node, source) + ": loads";
  if (!node->is_array()) throw Error(where, "no list", "a list of tables, such as [{ force = [-1, 0] }]");
  for (const toml::node& item : *node->as_array())
    read_load(table_of(item, where, "a table, such as { force = [-1, 0] }"), source, where, structure);
}

std::string words(const Support<Rational>& support, bool base, const Chain<Rational>& chain) {
  std::vector<std::string> parts;
  const Restraint<Rational>& across = support.across;
  if (support.turn.is_held()) {
    parts.push_back(across.is_held() ? "clamped" : "its direction held");
  } else if (base) {
    parts.push_back(chain.passive_joint(0) ? "pinned" : "sprung");
  } else {
    if (across.is_held()) parts.push_back("guided");
    if (across.is_free()) parts.push_back("free");
    if (!support.turn.is_free()) parts.push_back("a spring against turning");
  }
  if (base && across.is_free()) parts.push_back("free to move across");
  if (!base && support.turn.is_held() && across.is_free()) parts.push_back("free to move across");
  if (across.hold == Hold::sprung && !across.is_free()) parts.push_back("a spring across");
  const Restraint<Rational>& along = support.along;
  if (along.is_held() != base) parts.push_back(along.is_held() ? "held along" : "free to move along");
  if (along.hold == Hold::sprung && !along.is_free()) parts.push_back("a spring along");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : " and ") + part;
  return text;
}

RodEnd rod_end(const toml::table& table, const std::string& key, const std::string& source,
               RodEnd otherwise) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return otherwise;
  const std::string kind = word(*node);
  if (kind == "pinned" || (kind == "guided" && key == "end_point")) return RodEnd::pinned;
  if (kind == "clamped") return RodEnd::clamped;
  if (kind == "free" && key == "end_point") return RodEnd::free;
  throw Error(files::place(*node, source) + ": " + key, files::shown(kind),
              key == "base" ? "\"pinned\" or \"clamped\", for a beam"
                            : "\"pinned\", \"clamped\" or \"free\", for a beam");
}

Rational positive(const toml::table& table, const std::string& key, const std::string& where) {
  const toml::node* node = table.get(key);
  if (node == nullptr) throw Error(where, "no " + key, "EI, or E and I; length; links");
  const Rational value = number_of(*node, where + "." + key);
  if (value <= 0) throw Error(where + "." + key, files::shown(word(*node)), "a positive number");
  return value;
}

}  // namespace

Restraint<Rational> read_restraint(const toml::node& node, const std::string& where) {
  if (word(node) == "free") return {};
  if (word(node) == "held") return Restraint<Rational>::held();
  try {
    const Rational stiffness = number_of(node, where);
    if (stiffness >= 0) return Restraint<Rational>::sprung(stiffness);
  } catch (const Error&) {
  }
  throw Error(where, files::shown(word(node)), "\"free\", \"held\" or the stiffness of a spring");
}

std::size_t read_node(const toml::node& node, const std::string& where, std::size_t n) {
  if (word(node) == "end_point") return n;
  const std::string expected = "\"end_point\" or the number of a joint from 2 to " + std::to_string(n);
  const Rational joint = [&] {
    try {
      return number_of(node, where);
    } catch (const Error&) {
      throw Error(where, files::shown(word(node)), expected);
    }
  }();
  if (mp::denominator(joint) != 1 || joint < 2 || joint > n)
    throw Error(where, files::shown(word(node)), expected);
  return joint.convert_to<std::size_t>() - 1;
}

Structure<Rational> read_beam(const toml::table& table, const std::string& source, Beam& beam) {
  const toml::node& node = *table.get("beam");
  const std::string where = files::place(node, source) + ": beam";
  const toml::table& said = table_of(node, where, "{ EI = 1, length = 1, links = 20 }");
  files::refuse_unknown_keys(said, {"E", "I", "EI", "length", "links"}, source);
  for (const char* key : {"lengths", "stiffness", "link_length", "joint_stiffness", "rest"}) {
    if (table.contains(key))
      throw Error(where, std::string("beside ") + key, "one of the two: a beam has its own");
  }
  if (said.contains("EI") == (said.contains("E") || said.contains("I")))
    throw Error(where, "not one of EI and E with I", "EI, or both E and I");
  beam.EI = said.contains("EI") ? positive(said, "EI", where)
                                : positive(said, "E", where) * positive(said, "I", where);
  const Rational length = positive(said, "length", where), links = positive(said, "links", where);
  if (mp::denominator(links) != 1 || links > 1000000)
    throw Error(where + ".links", files::shown(word(*said.get("links"))), "a whole number up to a million");
  beam.bar = length / links;
  return rod<Rational>(beam.EI, length, links.convert_to<std::size_t>(),
                       rod_end(table, "base", source, RodEnd::pinned),
                       rod_end(table, "end_point", source, RodEnd::pinned));
}

void read_structure(const toml::table& table, const std::string& source, Structure<Rational>& structure) {
  if (!table.contains("beam")) {  // whose ends are springs: half a bar each
    read_support(table, "base", source, structure.base);
    require_base(table, source, structure.chain);
    read_support(table, "end_point", source, structure.end_point);
  }
  read_supports(table, source, structure);
  if (const toml::node* bed = table.get("foundation")) {
    const std::string where = files::place(*bed, source) + ": foundation";
    const Rational stiffness = number_of(*bed, where);
    if (stiffness < 0) throw Error(where, "a negative value", "force per deflection and length of the chain");
    structure.add_foundation(stiffness);
  }
  read_loads(table, source, structure);
  if (table.contains("masses")) structure.mass = number_list(table, "masses", source);
  try {
    structure.require_sound();
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
}

bool has_unit_compression(const Structure<Rational>& structure) {
  if (structure.loads.size() != 1 || structure.moment != 0) return false;
  const Load<Rational>& load = structure.loads[0];
  return load.node == structure.chain.size() && load.force.x == -1 && load.force.y == 0 && load.multiplied;
}

std::string case_of(const Structure<Rational>& structure) {
  const std::size_t n = structure.chain.size();
  std::string text = "base " + words(structure.base, true, structure.chain) + ", end point " +
                     words(structure.end_point, false, structure.chain);
  const auto supports = std::count_if(structure.across.begin(), structure.across.end(),
                                      [](const Restraint<Rational>& r) { return !r.is_free(); });
  if (supports > 0)
    text +=
        ", " + std::to_string(supports) + (supports == 1 ? " joint" : " joints") + " held or sprung across";
  std::set<std::size_t> dead;
  bool fixed = false, follower = false;
  for (const Load<Rational>& load : structure.loads) {
    (load.kind == LoadKind::follower) ? void(follower = true) : void(dead.insert(load.node));
    fixed = fixed || !load.multiplied;
  }
  if (follower) text += ", follower force";
  if (dead == std::set<std::size_t>{n})
    text += ", dead force at the end point";
  else if (!dead.empty())
    text += ", dead forces at " + std::to_string(dead.size()) + (dead.size() == 1 ? " place" : " places");
  if (structure.moment != 0) text += ", moment at the end point";
  if (fixed) text += ", some of it fixed";
  return text;
}

}  // namespace plumbline::app
