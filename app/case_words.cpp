#include "app/case_words.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace plumbline::app {
namespace {

/// \param turning  the word of a base whose link 1 turns; empty at the end point
std::string words(const Support<Rational>& support, const std::string& turning) {
  const bool base = !turning.empty();
  std::vector<std::string> parts;
  const Restraint<Rational>& across = support.across;
  if (support.turn.is_held()) {
    parts.push_back(across.is_held() ? "clamped" : "its direction held");
  } else if (base) {
    parts.push_back(turning);
  } else {
    if (across.is_held()) parts.push_back("guided");
    if (across.is_free()) parts.push_back("free");
    if (!support.turn.is_free()) parts.push_back("a spring against turning");
  }
  if ((base || support.turn.is_held()) && across.is_free()) parts.push_back("free to move across");
  if (across.hold == Hold::sprung && !across.is_free()) parts.push_back("a spring across");
  const Restraint<Rational>& along = support.along;
  if (base && along.is_free()) parts.push_back("free to move along");
  if (!base && along.is_held()) parts.push_back("held along");
  if (along.hold == Hold::sprung && !along.is_free()) parts.push_back("a spring along");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : " and ") + part;
  return text;
}

std::string supports(const std::vector<Restraint<Rational>>& across) {
  const auto count =
      std::count_if(across.begin(), across.end(), [](const Restraint<Rational>& r) { return !r.is_free(); });
  if (count == 0) return "";
  return ", " + std::to_string(count) + (count == 1 ? " joint" : " joints") + " held or sprung across";
}

std::string forces(const std::set<std::size_t>& nodes, std::size_t n) {
  if (nodes.empty()) return "";
  if (nodes == std::set<std::size_t>{n}) return ", dead force at the end point";
  return ", dead forces at " + std::to_string(nodes.size()) + (nodes.size() == 1 ? " place" : " places");
}

const char* name_of(TorqueKind kind) {
  if (kind == TorqueKind::axial) return "axial";
  return kind == TorqueKind::tangential ? "tangential" : "semitangential";
}

}  // namespace

bool has_unit_compression(const Structure<Rational>& structure) {
  if (structure.loads.size() != 1 || structure.moment != 0) return false;
  const Load<Rational>& load = structure.loads[0];
  return load.node == structure.chain.size() && load.force.x == -1 && load.force.y == 0 && load.multiplied;
}

std::string case_of(const Structure<Rational>& structure) {
  const std::size_t n = structure.chain.size();
  std::string text = "base " + words(structure.base, structure.chain.passive_joint(0) ? "pinned" : "sprung") +
                     ", end point " + words(structure.end_point, "");
  text += supports(structure.across);
  std::set<std::size_t> dead;
  bool fixed = false, follower = false;
  for (const Load<Rational>& load : structure.loads) {
    fixed = fixed || !load.multiplied;
    follower = follower || load.kind == LoadKind::follower;
    if (load.kind == LoadKind::dead && load.node > 0) dead.insert(load.node);
  }
  if (follower) text += ", follower force";
  text += forces(dead, n);
  if (structure.moment != 0) text += ", moment at the end point";
  if (fixed) text += ", some of it fixed";
  return text;
}

std::string case_of(const SpaceStructure<Rational>& structure) {
  const std::string base = structure.base == SpaceBase::clamped   ? "clamped"
                           : structure.base == SpaceBase::bearing ? "bearing"
                                                                  : "jointed";
  const Support<Rational>& end = structure.end_point;
  std::string text = "in space, base " + base + ", end point " + words(end, "");
  text += supports(structure.across);
  std::set<std::size_t> dead;
  bool fixed = false;
  for (const SpaceForce<Rational>& load : structure.loads) {
    fixed = fixed || !load.multiplied;
    if (load.node > 0) dead.insert(load.node);
  }
  text += forces(dead, structure.chain.size());
  if (structure.torque) text += std::string(", ") + name_of(*structure.torque) + " torque at the end point";
  return text + (fixed ? ", some of it fixed" : "");
}

}  // namespace plumbline::app
