#include "diagnose/exchange/series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::exchange {
namespace {

const std::string serial = "a serial chain, one joint after the other";

/// Axes turned by less count as parallel.
constexpr double parallel = 3e-3;

}  // namespace

JointNumbers::JointNumbers(const ReadModel& model) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) sorted_.emplace_back(model.joints[j].name, j);
  std::sort(sorted_.begin(), sorted_.end());
}

std::size_t JointNumbers::of(const std::string& name) const {
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(name, std::size_t{0}));
  return found != sorted_.end() && found->first == name ? found->second : sorted_.size();
}

std::string JointNumbers::twice() const {
  const auto same = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  return same == sorted_.end() ? "" : same->first;
}

std::vector<std::string> planar_part(const ReadModel& model) {
  const JointNumbers numbers(model);
  const std::size_t count = model.joints.size();
  constexpr std::size_t most = 5000;  // beyond, the search takes longer than anybody waits for advice
  if (count > most) return {};
  const auto follows = [&](std::size_t j, std::size_t on) {
    const ReadJoint &a = model.joints[on], &b = model.joints[j];
    const Eigen::Vector3d axis = a.axis.normalized();
    constexpr double apart = 1e-6;  // m
    return a.motion == JointMotion::hinge && axis.cross(b.axis.normalized()).norm() < parallel &&
           (a.anchor - b.anchor).cross(axis).norm() > apart;
  };
  // The nearest hinge below each that it may follow, whatever is held between them.
  std::vector<std::size_t> before(count, count), length(count, 0);
  for (std::size_t j = 0; j < count; ++j) {
    if (model.joints[j].motion != JointMotion::hinge) continue;
    std::size_t on = numbers.of(model.joints[j].carrier), steps = 0;
    while (on < count && !follows(j, on) && ++steps <= count) on = numbers.of(model.joints[on].carrier);
    if (steps > count) return {};  // joints that carry each other
    before[j] = on;
  }
  std::size_t last = count;
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t one = j; one < count && length[j] <= count; one = before[one]) ++length[j];
    if (length[j] > count) return {};
    if (model.joints[j].motion == JointMotion::hinge && (last == count || length[j] > length[last])) last = j;
  }
  std::vector<std::string> names;
  if (last == count || length[last] < 2) return names;
  for (; last < count; last = before[last]) names.insert(names.begin(), model.joints[last].name);
  return names;
}

std::string how_to_keep(const ReadModel& model) {
  const std::vector<std::string> part = planar_part(model);
  if (part.empty()) return "";
  constexpr std::size_t most = 8;  // names that an error has room for
  if (part.size() > most) return "; plumbline chain --joints NAMES keeps some joints, the others held";
  return fmt::format("; plumbline chain --joints {} keeps a part that is one, the others held",
                     fmt::join(part, ","));
}

Series::Series(const ReadModel& model, const std::string& source, const std::vector<std::string>& kept)
    : model_(model), numbers_(model) {
  if (const std::string name = numbers_.twice(); !name.empty())
    throw Error(source, "two joints " + name, "a name for each");
  choose(kept, source);
  follow(source);
}

void Series::choose(const std::vector<std::string>& kept, const std::string& source) {
  const std::size_t count = model_.joints.size();
  kept_.assign(count, false);
  for (const std::string& name : kept) {
    if (numbers_.of(name) == count) {
      std::vector<std::string> names;
      for (const ReadJoint& joint : model_.joints) names.push_back(joint.name);
      throw Error(source, "no joint " + files::shown(name),
                  fmt::format("some of {}", fmt::join(names, ", ")));
    }
    kept_[numbers_.of(name)] = true;
  }
  if (!kept.empty()) return;
  std::vector<bool> carries(count, false);
  for (const ReadJoint& joint : model_.joints)
    if (const std::size_t on = numbers_.of(joint.carrier); on != count) carries[on] = true;
  for (std::size_t j = 0; j < count; ++j)
    kept_[j] = model_.joints[j].motion != JointMotion::free || carries[j];
}

void Series::follow(const std::string& source) {
  const std::size_t count = model_.joints.size(), none = count;
  carrier_.assign(count, none);
  std::vector<std::size_t> after(count + 1, none);  // by what carries it; the base is the last
  for (std::size_t j = 0; j < count; ++j) {
    std::size_t on = numbers_.of(model_.joints[j].carrier);
    for (std::size_t steps = 0; on != none && !kept_[on]; on = numbers_.of(model_.joints[on].carrier))
      if (++steps > count) throw Error(source, "joints that carry each other", serial);
    carrier_[j] = on;
    if (!kept_[j]) continue;
    std::size_t& next = after[on];
    if (next != none)
      throw Error(source,
                  fmt::format("joints {} and {} at {}", model_.joints[next].name, model_.joints[j].name,
                              on == none ? "the base" : "joint " + model_.joints[on].name),
                  serial + how_to_keep(model_));
    next = j;
  }
  for (std::size_t j = after[count]; j != none; j = after[j]) order_.push_back(j);
  if (order_.empty()) throw Error(source, "no joint at the base", serial);
  if (static_cast<std::ptrdiff_t>(order_.size()) != std::count(kept_.begin(), kept_.end(), true))
    throw Error(source, "no joint after joint " + model_.joints[order_.back()].name, serial);
}

std::vector<ReadJoint> Series::joints() const {
  std::vector<ReadJoint> all;
  const std::size_t none = model_.joints.size();
  std::vector<std::size_t> place(none, none);
  for (const std::size_t j : order_) {
    place[j] = all.size();
    all.push_back(model_.joints[j]);
  }
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    if (kept_[j] || carrier_[j] == none) continue;
    add_mass(all[place[carrier_[j]]], model_.joints[j].mass, model_.joints[j].middle);
  }
  return all;
}

std::vector<std::string> Series::held() const {
  std::vector<std::string> names;
  for (std::size_t j = 0; j < kept_.size(); ++j)
    if (!kept_[j]) names.push_back(model_.joints[j].name);
  return names;
}

bool Series::at_the_end(const std::string& joint) const {
  std::size_t j = numbers_.of(joint);
  if (j < kept_.size() && !kept_[j]) j = carrier_[j];
  return j == order_.back();
}

}  // namespace plumbline::exchange
