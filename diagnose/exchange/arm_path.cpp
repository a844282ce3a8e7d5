#include "diagnose/exchange/arm_path.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>
#include <utility>

#include "diagnose/exchange/planar_chain.hpp"
#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

constexpr std::size_t names_in_an_error = 8;

/// Whether it is an object of its own, held by nothing.
bool lies_about(const ReadJoint& joint) {
  return joint.motion == JointMotion::free && joint.carrier.empty();
}

std::string listed(const ReadModel& model, const std::vector<std::size_t>& frames) {
  std::vector<std::string> names;
  for (const std::size_t f : frames) names.push_back(model.frames[f].name);
  const std::size_t most = std::min(names.size(), names_in_an_error);
  const std::string more = names.size() > most ? ", …" : "";
  names.resize(most);
  return fmt::format("{}{}", fmt::join(names, ", "), more);
}

}  // namespace

ArmPath::ArmPath(const ReadModel& model, std::string source, const ArmEnds& ends)
    : model_(model), source_(std::move(source)), numbers_(model) {
  if (const std::string name = numbers_.twice(); !name.empty())
    throw Error(source_, "two joints " + name, "a name for each");
  if (model.joints.empty()) throw Error(source_, "no joint", "an arm of hinges and slides");
  for (std::size_t f = 0; f < model.frames.size(); ++f)
    if (const ReadFrame& one = model.frames[f]; one.is_body() && !bodies_.emplace(one.name, f).second)
      throw Error(source_, "two bodies " + one.name, "a name for each");
  tip_ = ends.tip.empty() ? only_tip() : frame(ends.tip);
  base_ = ends.base.empty() ? root_of(tip_) : frame(ends.base);
  follow();
}

std::size_t ArmPath::frame(const std::string& name) const {
  std::vector<std::size_t> found, all;
  for (std::size_t f = 0; f < model_.frames.size(); ++f) {
    if (model_.frames[f].name == name) found.push_back(f);
    all.push_back(f);
  }
  if (found.empty())
    throw Error(source_, "no body or frame " + files::shown(name), "one of " + listed(model_, all));
  if (found.size() > 1)
    throw Error(source_,
                fmt::format("a {} and a {} named {}", model_.frames[found[0]].kind,
                            model_.frames[found[1]].kind, files::shown(name)),
                "a name for each");
  return found.front();
}

/// Frames that are named as ends; without any, bodies that carry none. What lies about is none.
std::vector<std::size_t> ArmPath::possible_tips() const {
  std::set<std::string> carry;
  for (const ReadFrame& one : model_.frames)
    if (one.is_body()) carry.insert(one.on);
  std::vector<std::size_t> named, last;
  for (std::size_t f = 0; f < model_.frames.size(); ++f) {
    const ReadFrame& one = model_.frames[f];
    const std::size_t joint = numbers_.of(one.carrier);
    if (joint == model_.joints.size() || lies_about(model_.joints[joint])) continue;
    if (names_an_end(one.name)) named.push_back(f);
    if (one.is_body() && !carry.contains(one.name)) last.push_back(f);
  }
  return named.empty() ? last : named;
}

std::size_t ArmPath::only_tip() const {
  const std::vector<std::size_t> all = possible_tips();
  std::vector<std::size_t> farthest;
  std::size_t most = 0;
  for (const std::size_t f : all) {
    const std::size_t count = joints_to(model_.frames[f].carrier).size();
    if (count < most) continue;
    if (count > most) farthest.clear();
    most = count;
    farthest.push_back(f);
  }
  if (farthest.empty()) throw Error(source_, "nothing that a joint moves and that may be a tip", "an arm");
  if (farthest.size() > 1)
    throw Error(source_, fmt::format("{} possible tips of an arm", all.size()),
                "one by its name: " + listed(model_, all));
  return farthest.front();
}

/// Where a root is the world as such, what stands fixed in it.
std::size_t ArmPath::root_of(std::size_t frame) const {
  std::size_t last = frame, before = frame;
  for (std::size_t steps = 0; steps <= model_.frames.size(); ++steps) {
    const auto on = bodies_.find(model_.frames[last].on);
    if (on == bodies_.end()) break;
    before = std::exchange(last, on->second);
  }
  const bool stands = model_.frames[before].carrier.empty();
  return model_.frames[last].name == "world" && stands ? before : last;
}

/// The joints that move what a joint moves, from the root of the model on.
std::vector<std::size_t> ArmPath::joints_to(const std::string& carrier) const {
  std::vector<std::size_t> all;
  const std::size_t none = model_.joints.size();
  for (std::size_t j = numbers_.of(carrier); j != none; j = numbers_.of(model_.joints[j].carrier)) {
    if (all.size() > none) throw Error(source_, "joints that carry each other", "a tree of bodies");
    all.push_back(j);
  }
  std::reverse(all.begin(), all.end());
  return all;
}

void ArmPath::follow() {
  const std::vector<std::size_t> held = joints_to(base().carrier), all = joints_to(tip().carrier);
  const auto ends = [&] {
    return fmt::format("{} {} and {} {}", base().kind, base().name, tip().kind, tip().name);
  };
  if (held.size() > all.size() || !std::equal(held.begin(), held.end(), all.begin()))
    throw Error(source_, ends() + ", of which none carries the other", "a tip that hangs from the base");
  joints_.assign(all.begin() + static_cast<std::ptrdiff_t>(held.size()), all.end());
  if (joints_.empty()) throw Error(source_, "no joint between " + ends(), "an arm of hinges and slides");
}

std::size_t ArmPath::link_of(const std::string& joint) const {
  const std::vector<std::size_t> all = joints_to(joint), held = joints_to(base().carrier);
  if (held.size() > all.size() || !std::equal(held.begin(), held.end(), all.begin())) return elsewhere;
  std::size_t link = 0;
  while (link < joints_.size() && held.size() + link < all.size() && all[held.size() + link] == joints_[link])
    ++link;
  return link;
}

std::string ArmPath::link_name(std::size_t i) const {
  const std::string& joint = model_.joints[joints_[i]].name;
  for (const ReadFrame& one : model_.frames) {
    if (!one.is_body() || one.carrier != joint) continue;
    const auto on = bodies_.find(one.on);
    if (on == bodies_.end() || model_.frames[on->second].carrier != joint) return one.name;
  }
  return joint;
}

}  // namespace plumbline::exchange
