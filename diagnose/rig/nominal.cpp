#include "diagnose/rig/nominal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/effect.hpp"
#include "diagnose/rig/run_rig.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

/// Weight of each link.
std::vector<Point<double>> weights(const Experiment& experiment) {
  std::vector<Point<double>> weight;
  for (const double mass : experiment.link_mass)
    weight.push_back({mass * experiment.gravity[0], mass * experiment.gravity[1]});
  return weight;
}

Rig without_effects(const Experiment& experiment) {
  const std::size_t n = experiment.link_length.size();
  Rig rig;
  rig.alone = !experiment.has_links();
  rig.length = experiment.link_length;
  rig.stiffness = experiment.joint_stiffness;
  rig.rest_error.assign(n, 0);
  rig.backlash.assign(n, 0);
  rig.stop.assign(n, std::numeric_limits<double>::infinity());
  rig.stop_stiffness.assign(n, 0);
  rig.travel.resize(n);
  rig.slip.assign(n, std::numeric_limits<double>::infinity());
  rig.hardening.assign(n, 0);
  rig.asymmetry.assign(n, 0);
  rig.knee.assign(n, std::numeric_limits<double>::infinity());
  rig.give.assign(n, 0);
  rig.friction.assign(n, 0);
  rig.sliders.resize(n);
  rig.balance.assign(n, Vector2::Zero());
  rig.command_scale.assign(n, 0);
  rig.gear_coupling.assign(n, 0);
  rig.encoder.resize(n);
  rig.drive.drift.assign(n, 0);
  for (const Point<double>& weight : weights(experiment)) rig.weight.emplace_back(weight.x, weight.y);
  rig.weight.resize(n, Vector2::Zero());
  rig.centre.assign(n, Vector2::Zero());
  if (experiment.arm) rig.arm = ArmRig::nominal(experiment);
  return rig;
}

/// The place that an error about the effect names.
std::string place_of(const Experiment& experiment, std::size_t number, const std::string& key) {
  return fmt::format("experiment \"{}\": nominal.effect[{}].{}", experiment.name, number + 1, key);
}

/// The rows that a nominal model may have: the catalogue's of every model order, and the user's.
std::vector<const Effect*> rows_of(const Experiment& experiment) {
  std::vector<const Effect*> rows;
  for (const Effect& row : catalogue()) {
    rows.push_back(&row);
    if (!row.orders) continue;
    for (const Effect* other : row.orders())
      if (other != &row) rows.push_back(other);
  }
  if (experiment.stated)
    for (const Effect& row : *experiment.stated) rows.push_back(&row);
  return rows;
}

/// An effect by a former id, with the parameters that its row has now.
NominalEffect in_present_terms(NominalEffect own, double gravity) {
  if (current_id(own.id) == own.id) return own;
  std::map<std::string, double> present;
  for (const auto& [name, value] : own.parameters) {
    if (name == "m")
      present["weight"] = value * gravity;
    else if (name == "f")
      present["EI"] = 1 / value;
    else
      present[name.starts_with("F_") ? "b_" + name.substr(2) : name] = value;
  }
  own.parameters = std::move(present);
  own.id = current_id(own.id);
  return own;
}

/// Whether a row has exactly these parameters in this chain.
bool has_parameters(const Effect& row, const NominalEffect& own, const CharacteristicScales& sizes) {
  const std::vector<ParameterRange> ranges = row.parameters({sizes, own.joint > 0 ? own.joint - 1 : 0});
  return ranges.size() == own.parameters.size() &&
         std::all_of(ranges.begin(), ranges.end(), [&](const ParameterRange& one) {
           return own.parameters.contains(std::string(one.name));
         });
}

/// The row that the effect names; of several, one that has its parameters, and is possible there.
/// \throws Error for an id or joint that no row has
const Effect& row_of(const Experiment& experiment, const CharacteristicScales& sizes, std::size_t number,
                     const NominalEffect& own) {
  const std::size_t n = experiment.link_length.size();
  bool known = false;
  const Effect* named = nullptr;
  const auto fit = [&](const Effect& row) {
    return 2 * has_parameters(row, own, sizes) + row.possible({sizes, own.joint > 0 ? own.joint - 1 : 0});
  };
  for (const Effect* row : rows_of(experiment)) {
    if (row->id != own.id) continue;
    known = true;
    if (row->at_joint != (own.joint > 0) || own.joint > n) continue;
    if (named == nullptr || fit(*row) > fit(*named)) named = row;
  }
  if (named != nullptr) return *named;
  if (!known)
    throw Error(place_of(experiment, number, "id"), files::shown(own.id),
                "an id of the effect catalogue, or user:NAME of the file that --effects names");
  throw Error(place_of(experiment, number, "joint"), own.joint > 0 ? std::to_string(own.joint) : "none",
              own.joint > n   ? fmt::format("a joint or link from 1 to {}", n)
              : own.joint > 0 ? "none: " + own.id + " is not at one joint"
                              : "the joint or link that has it, from 1");
}

/// The effect's parameters in the order of its row, which bounds their signs.
/// \throws Error for a missing, unknown or wrongly signed parameter
std::vector<double> values_of(const Experiment& experiment, std::size_t number, const NominalEffect& own,
                              const Effect& row, const Place& at) {
  std::vector<double> values;
  std::string names;
  for (const ParameterRange& range : row.parameters(at)) {
    names += (names.empty() ? "" : ", ") + std::string(range.name);
    const auto found = own.parameters.find(std::string(range.name));
    const std::string place = place_of(experiment, number, "parameters." + std::string(range.name));
    if (found == own.parameters.end()) throw Error(place, "no such key", "a number");
    const bool above =
        range.coordinate == Coordinate::logarithm || range.coordinate == Coordinate::reciprocal;
    if (above ? !(found->second > 0) : found->second < 0 && range.low >= 0 && !range.anywhere)
      throw Error(place, fmt::format("{}", found->second), above ? "a positive number" : "zero or more");
    values.push_back(found->second);
  }
  if (values.size() != own.parameters.size())
    throw Error(place_of(experiment, number, "parameters"), "further keys", names + " alone");
  return values;
}

/// \throws Error for values that no rig can have
void require_physical(const Experiment& experiment, const Rig& rig) {
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw Error("experiment \"" + experiment.name + "\": nominal.effect", found, expected);
  };
  for (std::size_t i = 0; i < rig.length.size(); ++i) {
    if (!(rig.length[i] > 0))
      refuse(fmt::format("a link {} of length {:.4g}", i + 1, rig.length[i]), "positive lengths");
    if (!(rig.stiffness[i] >= 0))
      refuse(fmt::format("a joint {} of stiffness {:.4g}", i + 1, rig.stiffness[i]),
             "stiffnesses that are not negative");
    if (slider_count(rig, i) > most_nominal_sliders)
      refuse(fmt::format("{} sliders at joint {}", slider_count(rig, i), i + 1),
             fmt::format("{} at most", most_nominal_sliders));
  }
  if (const std::size_t arms = arm_times(rig).size(); arms > most_nominal_arms)
    refuse(fmt::format("{} Maxwell arms", arms), fmt::format("{} at most", most_nominal_arms));
}

}  // namespace

NominalModel<double> nominal_model(const Experiment& experiment, const std::vector<double>& rest) {
  return NominalModel<double>(Chain<double>(experiment.link_length, experiment.joint_stiffness, rest),
                              weights(experiment));
}

Rig nominal_rig(const Experiment& experiment) {
  Rig rig = without_effects(experiment);
  if (experiment.plain()) return rig;
  rig.laws = experiment.laws;
  const CharacteristicScales sizes = characteristic_scales(experiment);
  for (std::size_t e = 0; e < experiment.effects.size(); ++e) {
    const NominalEffect own = in_present_terms(experiment.effects[e], sizes.gravity);
    const Effect& row = row_of(experiment, sizes, e, own);
    const std::size_t joint = row.at_joint ? own.joint - 1 : 0;
    const std::vector<double> values = values_of(experiment, e, own, row, {sizes, joint});
    row.add({rig, joint, sizes, experiment.bench.down(), values.data()});
  }
  require_physical(experiment, rig);
  return rig;
}

}  // namespace plumbline::diagnose
