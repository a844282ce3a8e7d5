#include "statement/plane.hpp"

#include <algorithm>
#include <array>

#include "statement/ends.hpp"

namespace plumbline::statement {
namespace {

constexpr std::array<std::string_view, 7> structure_keys{"base",  "end_point", "supports", "foundation",
                                                         "loads", "masses",    "beam"};

TypedTable known(const toml::table& table, const std::string& source) {
  std::vector<std::string_view> keys{"lengths", "stiffness", "rest"};
  keys.insert(keys.end(), structure_keys.begin(), structure_keys.end());
  return {table, source, keys, {"link_length", "joint_stiffness", "link_mass", "gravity"}};
}

/// The key as chain files spell it or as experiments do, whichever stands there.
std::string_view spelling(const TypedTable& table, std::string_view here, std::string_view in_experiments) {
  if (!table.has(in_experiments)) return here;
  if (table.has(here))
    throw Error(table.place(in_experiments), "both " + std::string(here) + " and this",
                "one of the two, which mean the same");
  return in_experiments;
}

Chain<Rational> read_links(const TypedTable& table) {
  return Chain<Rational>(table.numbers(spelling(table, "lengths", "link_length")),
                         table.numbers(spelling(table, "stiffness", "joint_stiffness")),
                         table.has("rest") ? table.numbers("rest") : std::vector<Rational>());
}

/// `base = "pinned"` says that joint 1 has no spring, "sprung" that it has one.
void read_ends(const TypedTable& table, Structure<Rational>& structure) {
  Support<Rational> held = pinned<Rational>();
  held.turn = Restraint<Rational>::held();
  structure.base =
      read_end(table, "base", {{"pinned", structure.base}, {"sprung", structure.base}, {"clamped", held}},
               structure.base);
  structure.end_point = read_end(
      table, "end_point", {{"guided", guided<Rational>()}, {"free", {}}, {"clamped", clamped<Rational>()}},
      guided<Rational>());
  if (!table.has("base") || table.node("base").is_table()) return;
  const std::string word = word_of(table.node("base"));
  const bool passive = structure.chain.passive_joint(0);
  if (word == "pinned" && !passive)
    throw Error(table.place("base"), "\"pinned\" beside a spring at joint 1",
                "stiffness 0 there, or \"sprung\"");
  if (word == "sprung" && passive)
    throw Error(table.place("base"), "\"sprung\" without a spring at joint 1",
                "its stiffness there, or \"pinned\"");
}

void require_one_end_along(const TypedTable& table, const Structure<Rational>& structure) {
  const bool held_at_base = !structure.base.along.is_free();
  if (held_at_base != structure.end_point.along.is_free())
    throw Error(table.place(held_at_base ? "end_point" : "base"),
                std::string(held_at_base ? "both ends" : "neither end") + " held along the chain",
                "one of the two");
}

void read_weight(const TypedTable& load, bool multiplied, PlaneChain& chain) {
  if (load.has("at"))
    throw Error(load.place("at"), "a weight at a joint", "a force for that: weight is of links");
  const std::size_t n = chain.structure.chain.size();
  auto weight = load.node("weight").is_array() ? load.numbers("weight", n)
                                               : std::vector<Rational>(n, load.number("weight"));
  Point<Rational> down{-1, 0};
  if (load.has("direction")) {
    const auto d = load.numbers("direction", 2);
    down = {d[0], d[1]};
    if (down.x * down.x + down.y * down.y != 1)
      throw Error(load.place("direction"), "a vector whose length is not 1",
                  "a unit vector, such as [-1, 0]");
  }
  for (std::size_t link = 1; link <= n; ++link)
    chain.structure.add_weight(link, {weight[link - 1] * down.x, weight[link - 1] * down.y}, multiplied);
  if (!chain.beam) return;
  for (Rational& each : weight) each *= -down.x;
  chain.beam->weights.push_back({std::move(weight), multiplied});
}

void read_load(const TypedTable& load, const std::string& where, PlaneChain& chain) {
  Structure<Rational>& structure = chain.structure;
  int kinds = 0;
  for (const char* kind : {"force", "follower", "moment", "weight"}) kinds += load.has(kind) ? 1 : 0;
  if (kinds != 1)
    throw Error(where, std::to_string(kinds) + " of force, follower, moment, weight in one load", "one");
  if (load.has("direction") && !load.has("weight"))
    throw Error(load.place("direction"), "a direction without a weight", "the direction in the force itself");
  const std::size_t n = structure.chain.size();
  const std::size_t node = load.has("at") ? read_node(load, "at", n) : n;
  const bool multiplied = !load.flag("fixed", false);
  if (load.has("force")) {
    const auto f = load.numbers("force", 2);
    structure.loads.push_back({node, {f[0], f[1]}, multiplied, LoadKind::dead});
  } else if (load.has("follower")) {
    structure.loads.push_back({node, {-load.number("follower"), 0}, multiplied, LoadKind::follower});
  } else if (load.has("moment")) {
    if (!multiplied || node != n)
      throw Error(load.place("moment"), "a moment that is fixed, or not at the end point",
                  "one at the end point, multiplied");
    structure.moment += load.number("moment");
  } else {
    read_weight(load, multiplied, chain);
  }
}

void read_loads(const TypedTable& table, PlaneChain& chain) {
  if (!table.has("loads")) return chain.structure.add_compression();
  for (const TypedTable& load :
       table.tables("loads", {"at", "force", "follower", "moment", "weight", "direction", "fixed"},
                    "{ force = [-1, 0] }"))
    read_load(load, table.place("loads"), chain);
}

/// Those of all nodes, or of the far ends of the links alone.
std::vector<Rational> read_masses(const TypedTable& table, std::size_t n) {
  if (!table.has("masses")) return {};
  std::vector<Rational> masses = table.numbers("masses");
  if (masses.size() == n) masses.insert(masses.begin(), Rational(0));
  if (masses.size() != n + 1)
    throw Error(table.place("masses"), std::to_string(masses.size()) + " values",
                std::to_string(n) + ", at the far ends of the links, or one more, the base's first");
  for (const Rational& mass : masses) {
    if (mass < 0) throw Error(table.place("masses"), "a negative value", "zero or positive masses");
  }
  return masses;
}

}  // namespace

PlaneChain read_plane(const toml::table& toml, const std::string& source) {
  const TypedTable table = known(toml, source);
  Beam beam;
  const bool is_beam = table.has("beam");
  PlaneChain chain{is_beam ? read_beam(table, beam) : Structure<Rational>(read_links(table)),
                   std::none_of(structure_keys.begin(), structure_keys.end(),
                                [&](std::string_view key) { return table.has(key); }),
                   is_beam ? std::optional(beam) : std::nullopt};
  Structure<Rational>& structure = chain.structure;
  if (!is_beam) read_ends(table, structure);
  require_one_end_along(table, structure);
  structure.across = read_supports(table, structure.chain.size());
  if (table.has("foundation")) structure.add_foundation(table.not_negative("foundation"));
  if (is_beam && table.has("foundation")) chain.beam->bed = table.not_negative("foundation");
  read_loads(table, chain);
  structure.mass = read_masses(table, structure.chain.size());
  structure.require_sound();
  return chain;
}

}  // namespace plumbline::statement
