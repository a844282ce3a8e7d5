#include "statement/space.hpp"

#include "statement/decimal_toml.hpp"
#include "statement/ends.hpp"

namespace plumbline::statement {
namespace {

std::array<Rational, 3> vector_of(const std::vector<Rational>& values) {
  return {values[0], values[1], values[2]};
}

SpaceJoint<Rational> read_joint(const TypedTable& joint) {
  const toml::array* axes = joint.node("axes").as_array();
  if (axes == nullptr || !axes->is_homogeneous(toml::node_type::array))
    throw Error(joint.place("axes"), as_written(joint.node("axes")), "axes = [[0, 0, 1], …], a vector each");
  const std::vector<Rational> stiffness = joint.numbers("stiffness", axes->size());
  const auto rest = joint.has("rest") ? joint.numbers("rest", axes->size())
                                      : std::vector<Rational>(axes->size(), Rational(0));
  SpaceJoint<Rational> result;
  for (std::size_t a = 0; a < axes->size(); ++a) {
    const auto direction = numbers_of(*axes->get(a)->as_array(), joint.place("axes"));
    if (direction.size() != 3)
      throw Error(joint.place("axes"), std::to_string(direction.size()) + " numbers",
                  "three: along x, y and z");
    result.axes.push_back({vector_of(direction), stiffness[a], rest[a]});
  }
  return result;
}

SpaceChain<Rational> read_space_links(const TypedTable& table) {
  std::vector<SpaceJoint<Rational>> joints;
  for (const TypedTable& joint :
       table.tables("joints", {"axes", "stiffness", "rest"}, "{ axes = [[0, 0, 1]], stiffness = [1] }"))
    joints.push_back(read_joint(joint));
  return SpaceChain<Rational>(table.numbers("lengths"), std::move(joints));
}

void read_ends(const TypedTable& table, SpaceStructure<Rational>& structure) {
  const Support<Rational> jointed = pinned<Rational>();
  Support<Rational> held = jointed;
  held.turn = Restraint<Rational>::held();
  const Support<Rational> base =
      read_end(table, "base", {{"jointed", jointed}, {"bearing", jointed}, {"clamped", held}}, jointed);
  if (!base.along.is_held() || !base.across.is_held())
    throw Error(table.place("base"), "one that moves, of a chain in space", "along and across \"held\"");
  if (!base.turn.is_free() && !base.turn.is_held())
    throw Error(table.place("base"), "a spring that turns beside those of joint 1",
                "the stiffness of joint 1 alone");
  structure.base = base.turn.is_held() ? SpaceBase::clamped : SpaceBase::jointed;
  if (table.has("base") && word_of(table.node("base")) == "bearing") structure.base = SpaceBase::bearing;
  structure.end_point = read_end(
      table, "end_point", {{"guided", guided<Rational>()}, {"free", {}}, {"clamped", clamped<Rational>()}},
      guided<Rational>());
}

TorqueKind torque_kind(const std::string& word) {
  if (word == "axial") return TorqueKind::axial;
  return word == "tangential" ? TorqueKind::tangential : TorqueKind::semitangential;
}

void read_space_load(const TypedTable& load, const std::string& where, SpaceStructure<Rational>& structure) {
  int kinds = 0;
  for (const char* kind : {"force", "weight", "torque"}) kinds += load.has(kind) ? 1 : 0;
  if (kinds != 1) throw Error(where, std::to_string(kinds) + " of force, weight, torque in one load", "one");
  const std::size_t n = structure.chain.size();
  const bool multiplied = !load.flag("fixed", false);
  if (load.has("force")) {
    const std::size_t at = load.has("at") ? read_node(load, "at", n) : n;
    structure.loads.push_back({at, vector_of(load.numbers("force", 3)), multiplied});
    return;
  }
  if (load.has("at"))
    throw Error(load.place("at"), "a weight or a torque at a joint",
                "a weight of all links, a torque at the end point");
  if (load.has("weight")) {
    const auto weight = vector_of(load.numbers("weight", 3));
    for (std::size_t link = 1; link <= n; ++link) structure.add_weight(link, weight, multiplied);
    return;
  }
  if (!multiplied || structure.torque)
    throw Error(load.place("torque"), multiplied ? "a second torque" : "a torque that is fixed",
                "one torque, multiplied");
  structure.torque = torque_kind(load.word("torque", {"axial", "tangential", "semitangential"}));
}

}  // namespace

SpaceStructure<Rational> read_space(const toml::table& toml, const std::string& source) {
  const TypedTable table(toml, source,
                         {"lengths", "joints", "base", "end_point", "supports", "foundation", "loads"});
  SpaceStructure<Rational> structure(read_space_links(table));
  read_ends(table, structure);
  structure.across = read_supports(table, structure.chain.size());
  if (table.has("foundation")) structure.add_foundation(table.not_negative("foundation"));
  if (!table.has("loads")) structure.add_compression();
  for (const TypedTable& load :
       table.tables("loads", {"at", "force", "weight", "fixed", "torque"}, "{ force = [-1, 0, 0] }"))
    read_space_load(load, table.place("loads"), structure);
  structure.require_sound();
  return structure;
}

}  // namespace plumbline::statement
