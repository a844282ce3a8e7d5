#include "diagnose/bench/order_of_chain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plumbline::diagnose {
namespace {

void reverse(std::vector<double>& list) {
  std::reverse(list.begin(), list.end());
}

/// Whether a list differs when it is reversed, with its values multiplied by 1 or -1.
bool has_ends(const std::vector<double>& list, double sense = 1) {
  return !std::equal(list.begin(), list.end(), list.rbegin(),
                     [sense](double a, double b) { return a == sense * b; });
}

/// Lists that begin at the end point, and the sense of their angles.
struct FromEnd {
  bool lengths = false, springs = false, masses = false, rest = false, readings = false;
  /// -1 for angles of a link against the next one towards the end point, seen from there; 1 for angles
  /// against the previous one, whatever its number.
  double sense = 1;

  [[nodiscard]] int count() const { return lengths + springs + masses + rest + readings; }

  void operator()(Experiment& e) const {
    const auto reverse_angles = [this](std::vector<double>& angles) {
      reverse(angles);
      for (double& angle : angles) angle *= sense;
    };
    if (lengths) reverse(e.link_length);
    if (springs) reverse(e.joint_stiffness);
    if (masses) reverse(e.link_mass);
    for (Run& run : e.runs) {
      if (rest) run.each_rest(reverse_angles);
      if (!readings) continue;
      for (Reading& r : run.readings) {
        std::vector<double> angles = r.angles(run.rest.size());
        reverse_angles(angles);
        for (std::size_t j = 0; j < angles.size(); ++j) Channel(Channel::Name::q, j).in(r) = angles[j];
      }
    }
  }

  [[nodiscard]] std::string remedy() const {
    std::vector<const char*> keys;
    if (lengths) keys.push_back("link_length");
    if (springs) keys.push_back("joint_stiffness");
    if (masses) keys.push_back("link_mass");
    if (rest) keys.push_back("rest");
    std::string all = fmt::format("{} in reverse", fmt::join(keys, ", "));
    if (rest && sense < 0) all += ", the signs of rest turned";
    if (readings) all += ", the columns of columns.q in reverse";
    if (readings && sense < 0) all += ", columns.q.sign = -1";
    return all;
  }

  /// Link masses follow the lengths; they are named where the lengths are symmetric.
  [[nodiscard]] Conversion conversion() const {
    std::vector<const char*> what;
    if (lengths || masses) what.push_back(lengths ? "link_length" : "link_mass");
    if (springs) what.push_back("joint_stiffness");
    if (rest) what.push_back("rest");
    if (readings) what.push_back("q");
    const std::string lists = count() > 1 ? "lists from the end point on" : "a list from the end point on",
                      from_base = "joints and links from the base on";
    return {fmt::format("{}", fmt::join(what, ", ")),
            sense < 0 ? "angles of the opposite sign in " + lists : lists,
            sense < 0 ? from_base + ", angles counter-clockwise" : from_base,
            remedy(),
            0,
            false,
            {},
            *this};
  }
};

}  // namespace

void add_order_of_chain(const Experiment& e, std::vector<Conversion>& all) {
  const FromEnd chain{has_ends(e.link_length), has_ends(e.joint_stiffness), has_ends(e.link_mass)};
  const bool weighs = chain.masses && e.gravity != std::array<double, 2>{0, 0};
  if (chain.springs) all.push_back(FromEnd{.springs = true}.conversion());
  if (chain.lengths) all.push_back(FromEnd{.lengths = true}.conversion());
  if (chain.lengths + chain.springs + weighs > 1) all.push_back(chain.conversion());
  if (!chain.lengths && !chain.springs && !weighs) return;
  for (const double sense : {1.0, -1.0}) {
    FromEnd with_angles = chain;
    with_angles.sense = sense;
    with_angles.rest = std::any_of(e.runs.begin(), e.runs.end(),
                                   [sense](const Run& run) { return has_ends(run.rest, sense); });
    if (with_angles.rest) all.push_back(with_angles.conversion());
    with_angles.readings = std::ranges::any_of(e.runs, &Run::reads_angles);
    if (with_angles.readings) all.push_back(with_angles.conversion());
  }
}

}  // namespace plumbline::diagnose
