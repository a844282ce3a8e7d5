#include "diagnose/bench/read_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <plumbline/base/error.hpp>
#include <utility>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

/// The words of a kind: the key of its values, and that of its moment arms.
struct Words {
  Load::Kind kind;
  const char* values;
  const char* arms;
  const Quantity* of_arms;
};

/// By their numbers.
constexpr std::array all_words{Words{Load::Kind::tendon, "tendon", "radius", &quantity::length},
                               Words{Load::Kind::pressure, "pressure", "volume", &quantity::volume},
                               Words{Load::Kind::force, "force", nullptr, nullptr}};

/// \throws Error for a key of another kind of load
void refuse_others(const Section& load, const Words& own) {
  using Kind = Load::Kind;
  for (const auto& [key, kind] : {std::pair("radius", Kind::tendon), std::pair("volume", Kind::pressure),
                                  std::pair("link", Kind::force), std::pair("at", Kind::force)})
    if (load.has(key) && kind != own.kind)
      load.refuse(key, fmt::format("nothing beside {}: it is of a {}", own.values,
                                   all_words.at(static_cast<std::size_t>(kind)).values));
}

/// \throws Error where the table has none of the kinds, several, or a key of another kind
const Words& words_of(const Section& load) {
  load.allow_only({"tendon", "pressure", "force", "radius", "volume", "link", "at"});
  const Words* found = nullptr;
  for (const Words& one : all_words) {
    if (!load.has(one.values)) continue;
    if (found)
      load.refuse(one.values, fmt::format("nothing beside {}: a load is one of them", found->values));
    found = &one;
  }
  if (!found) throw Error(load.place("tendon"), "a load without a kind", "one of tendon, pressure and force");
  refuse_others(load, *found);
  return *found;
}

/// Adds the columns of the load's values to the covariates.
void add_values(const Section& section, const Words& words, const Load& load, SampleFormat& format) {
  const std::string expected =
      load.values() == 2 ? "a list of two names of columns, along x and along y" : "the name of its column";
  const std::vector<std::string> names = section.texts(words.values, expected);
  if (names.size() != load.values()) section.refuse(words.values, expected);
  const std::string place = section.place(words.values);
  for (const std::string& name : names) {
    if (std::ranges::any_of(format.columns, [&](const Column& one) {
          return one.says == Says::covariate && one.channel == name;
        }))
      throw Error(place, "\"" + files::shown(name) + "\" again", "a name that no other load has");
    add_covariate(format, name, place, &load.quantity());
  }
}

std::vector<double> moment_arms(const Section& load, const Words& words, std::size_t joints,
                                const Unit& unit) {
  std::vector<double> arms = load.numbers(words.arms, 0);
  if (arms.size() != joints)
    throw Error(load.place(words.arms), fmt::format("{} values", arms.size()),
                fmt::format("{}, one for each joint; 0 where it does not pass", joints));
  if (std::all_of(arms.begin(), arms.end(), [](double arm) { return arm == 0; }))
    throw Error(load.place(words.arms), "0 at every joint", "one that is not 0");
  for (double& arm : arms) arm = in_si(arm, unit);
  return arms;
}

/// Where a force acts: at the far end of the last link where nothing else is said.
void read_place(const Section& section, std::size_t links, Load& load) {
  const std::size_t link = section.has("link") ? section.count("link") : links;
  if (link > links)
    throw Error(section.place("link"), std::to_string(link), fmt::format("a link from 1 to {}", links));
  load.link = link - 1;
  const std::string share = "a share of the link's length, from 0 to 1";
  if (section.has("at")) load.at = section.number("at", share);
  if (!(load.at >= 0 && load.at <= 1)) section.refuse("at", share);
}

Load read_load(const Section& section, std::size_t joints, const Section& units, SampleFormat& format) {
  const Words& words = words_of(section);
  Load load{words.kind, format.covariates()};
  add_values(section, words, load, format);
  if (!words.arms) {
    read_place(section, joints, load);
    return load;
  }
  const Quantity& quantity = *words.of_arms;
  const Unit unit = units.has(words.arms) ? parse_unit(units.text(words.arms, quantity.examples), quantity,
                                                       units.place(words.arms))
                                          : si_unit(quantity);
  load.moment_arm = moment_arms(section, words, joints, unit);
  return load;
}

}  // namespace

std::vector<Load> read_loads(const Section& root, const NominalChain& chain, SampleFormat& format) {
  if (!root.has("load")) return {};
  if (!chain.has_links())
    root.refuse("load", "nothing: a joint alone has its torque or force; loads act along a planar chain");
  const Section units = root.table_or_empty("units");
  std::vector<Load> loads;
  for (const Section& section : root.tables("load"))
    loads.push_back(read_load(section, chain.joint_stiffness.size(), units, format));
  format.any_order = true;
  return loads;
}

}  // namespace plumbline::diagnose
