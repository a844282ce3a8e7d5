#include "diagnose/bench/conversion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {
namespace {

using Names = std::vector<const char*>;

const Names forces{"N", "kgf", "kN", "mN", "lbf", "gf"}, lengths{"m", "mm", "cm", "in"},
    angles_in{"rad", "deg"}, stiffnesses{"N m/rad",  "N mm/rad",   "N cm/rad",  "N m/deg",
                                         "N mm/deg", "kgf cm/rad", "kgf m/rad", "lbf in/rad"};

/// Alternatives to the unit of a quantity.
struct Other {
  std::string name, instead_of;
  double factor;
};

std::vector<Other> others(const Names& names, const Quantity& quantity, const Origin& read) {
  std::vector<Other> all;
  for (const char* name : names) {
    const double factor = parse_unit(name, quantity, "unit").in_si() / read.in_si;
    constexpr double same = 1e-3;
    if (std::abs(factor - 1) > same) all.push_back({name, read.unit, factor});
  }
  return all;
}

/// The unit of a channel in the first run, or of a key; SI where it is not known.
Origin origin(const std::vector<Origin>& all, const std::string& what, const Quantity& quantity) {
  for (const Origin& one : all)
    if (one.what == what) return one;
  return {what, what, quantity.si, 1};
}

Origin origin_of_channel(const Experiment& e, const std::string& channel, const Quantity& quantity) {
  return origin(e.runs.empty() ? std::vector<Origin>() : e.runs.front().origins, channel, quantity);
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

void scale_forces(Run& run, double factor) {
  for (Reading& r : run.readings) r.Fx *= factor, r.Fy *= factor;
}

void scale_positions(Run& run, double factor) {
  for (Reading& r : run.readings) r.x *= factor, r.y *= factor;
}

/// A mapping of two axes.
struct Axes {
  const char* name;
  double xx, xy, yx, yy;
  /// A missing component must not make the other one missing.
  void operator()(double& x, double& y) const {
    if (xy == 0) {
      x *= xx;
      y *= yy;
    } else {
      const double u = xy * y;
      y = yx * x;
      x = u;
    }
  }
  [[nodiscard]] bool mirrors_y() const { return xx == 1 && yy == -1; }
  /// "columns.Fx and columns.Fy with sign = -1".
  [[nodiscard]] std::string remedy(const std::string& x, const std::string& y) const {
    if (xy == 0) {
      const std::string both = xx * yy > 0 ? "columns." + x + " and columns." + y : "";
      return (both.empty() ? "columns." + (xx < 0 ? x : y) : both) + " with sign = -1";
    }
    const auto from = [](const std::string& to, const std::string& source, double sign) {
      return "columns." + to + " with the column of " + source + (sign < 0 ? " and sign = -1" : "");
    };
    return from(x, y, xy) + ", " + from(y, x, yx);
  }
};

constexpr std::array<Axes, 7> axes{{{"of the opposite sign", -1, 0, 0, -1},
                                    {"with y mirrored", 1, 0, 0, -1},
                                    {"with x mirrored", -1, 0, 0, 1},
                                    {"with x and y swapped", 0, 1, 1, 0},
                                    {"turned by 90 degrees", 0, 1, -1, 0},
                                    {"turned by -90 degrees", 0, -1, 1, 0},
                                    {"with x and y swapped and of the opposite sign", 0, -1, -1, 0}}};

void add_forces(const Experiment& e, std::vector<Conversion>& all) {
  const Origin read = origin_of_channel(e, "Fx", quantity::force);
  const auto add = [&](const std::string& name, double factor, const std::string& remedy) {
    all.push_back({"Fx, Fy",
                   name,
                   read.unit,
                   remedy,
                   factor,
                   false,
                   [factor](Run& run) { scale_forces(run, factor); },
                   {}});
  };
  for (const Other& unit : others(forces, quantity::force, read))
    add(unit.name, unit.factor, "columns.Fx.unit and columns.Fy.unit = \"" + unit.name + "\"");
  if (read.in_si == 1)
    add("N that were multiplied by 9.80665 once too often", 1 / 9.80665,
        "columns.Fx.unit and columns.Fy.unit = \"0.101972 N\"");
  for (const Axes& one : axes) {
    all.push_back({"Fx, Fy",
                   std::string("forces ") + one.name,
                   "the force on the end point, in the base frame",
                   one.remedy("Fx", "Fy"),
                   0,
                   one.mirrors_y(),
                   [one](Run& run) {
                     for (Reading& r : run.readings) one(r.Fx, r.Fy);
                   },
                   {}});
  }
}

/// A convention of joint angles.
struct Angles {
  std::string name, remedy_of_q, remedy_of_rest;
  double factor = 0;
  std::function<void(std::vector<double>&)> convert;
};

std::vector<Angles> ways_to_write_angles(const Origin& read) {
  std::vector<Angles> all;
  for (const Other& unit : others(angles_in, quantity::angle, read)) {
    const double factor = unit.factor;
    all.push_back({unit.name == "deg" ? "degrees" : "radians", "columns.q.unit = \"" + unit.name + "\"",
                   "units.rest = \"" + unit.name + "\"", factor,
                   [factor](std::vector<double>& q) { scale(q, factor); }});
  }
  all.push_back({"angles of the opposite sign", "columns.q.sign = -1", "the signs of rest turned", 0,
                 [](std::vector<double>& q) { scale(q, -1); }});
  all.push_back({"absolute angles", "columns.q.absolute = true", "in rest the differences of neighbours", 0,
                 [](std::vector<double>& q) { std::adjacent_difference(q.begin(), q.end(), q.begin()); }});
  all.push_back({"angles in the reverse order", "the columns of columns.q in reverse", "rest in reverse", 0,
                 [](std::vector<double>& q) { std::reverse(q.begin(), q.end()); }});
  return all;
}

/// \param rest, readings  which of them are in this convention
void add_angles(const Experiment& e, bool rest, bool readings, std::vector<Conversion>& all) {
  const Origin read =
      rest ? origin(e.origins, "rest", quantity::angle) : origin_of_channel(e, "q1", quantity::angle);
  for (const Angles& one : ways_to_write_angles(read)) {
    std::string remedy = rest ? one.remedy_of_rest : "";
    if (readings) remedy += (rest ? ", " : "") + one.remedy_of_q;
    all.push_back({rest && readings ? "rest, q"
                   : rest           ? "rest"
                                    : "q",
                   one.name,
                   "relative joint angles, counter-clockwise, from joint 1, in " + read.unit,
                   remedy,
                   one.factor,
                   one.name == "angles of the opposite sign",
                   [=](Run& run) {
                     if (rest) one.convert(run.rest);
                     if (!readings) return;
                     for (Reading& r : run.readings) one.convert(r.q);
                   },
                   {}});
  }
}

/// Whether a joint is bent at rest in every run by more than any error of its zero.
bool is_bent_at_rest(const Experiment& e, std::size_t joint) {
  constexpr double least = 0.15;
  return std::all_of(e.runs.begin(), e.runs.end(),
                     [&](const Run& run) { return std::abs(run.rest[joint]) > least; });
}

bool measures_angles(const Experiment& e) {
  return std::any_of(e.runs.begin(), e.runs.end(),
                     [](const Run& run) { return !run.readings.empty() && !run.readings.front().q.empty(); });
}

/// One joint whose angle has the opposite sign: at rest, in the readings, or both.
void add_turned_joints(const Experiment& e, std::vector<Conversion>& all) {
  const std::size_t joints = e.link_length.size();
  const bool measured = measures_angles(e);
  const auto add = [&](const std::string& what, const std::string& remedy, const auto& turn) {
    all.push_back({what,
                   "an angle of the opposite sign",
                   "relative joint angles, counter-clockwise",
                   remedy,
                   0,
                   false,
                   turn,
                   {}});
  };
  for (std::size_t j = 0; joints > 1 && j < joints; ++j) {
    if (!is_bent_at_rest(e, j)) continue;
    const auto turn_rest = [j](Run& run) { run.rest[j] *= -1; };
    const auto turn_readings = [j](Run& run) {
      for (Reading& r : run.readings)
        if (j < r.q.size()) r.q[j] *= -1;
    };
    const std::string number = std::to_string(j + 1), rest = "rest of joint " + number, q = "q" + number,
                      sign = " with the sign of joint " + number + " turned", column = "the column of " + q;
    add(rest, "rest" + sign, turn_rest);
    if (!measured) continue;
    add(q, column + " with its sign turned", turn_readings);
    add(rest + ", " + q, "rest and " + column + sign, [=](Run& run) { turn_rest(run), turn_readings(run); });
  }
}

void add_positions(const Experiment& e, std::vector<Conversion>& all) {
  for (const Other& unit : others(lengths, quantity::length, origin_of_channel(e, "x", quantity::length))) {
    const double factor = unit.factor;
    all.push_back({"x, y",
                   unit.name,
                   unit.instead_of,
                   "columns.x.unit and columns.y.unit = \"" + unit.name + "\"",
                   factor,
                   false,
                   [factor](Run& run) { scale_positions(run, factor); },
                   {}});
  }
  for (const Axes& one : axes) {
    const auto positions = [one](Run& run) {
      for (Reading& r : run.readings) one(r.x, r.y);
    };
    all.push_back({"x, y",
                   std::string("an end point ") + one.name,
                   "the end point in the base frame",
                   one.remedy("x", "y"),
                   0,
                   one.mirrors_y(),
                   positions,
                   {}});
    all.push_back({"x, y, Fx, Fy",
                   std::string("axes ") + one.name,
                   "the base frame",
                   one.remedy("x", "y") + ", " + one.remedy("Fx", "Fy"),
                   0,
                   one.mirrors_y(),
                   [one, positions](Run& run) {
                     positions(run);
                     for (Reading& r : run.readings) one(r.Fx, r.Fy);
                   },
                   {}});
  }
}

void add_units_of_chain(const Experiment& e, std::vector<Conversion>& all) {
  const Origin stiffness = origin(e.origins, "joint_stiffness", quantity::stiffness);
  for (const Other& unit : others(stiffnesses, quantity::stiffness, stiffness)) {
    all.push_back({"joint_stiffness",
                   unit.name,
                   unit.instead_of,
                   "units.joint_stiffness = \"" + unit.name + "\"",
                   unit.factor,
                   false,
                   {},
                   [factor = unit.factor](Experiment& one) { scale(one.joint_stiffness, factor); }});
  }
  for (const Other& unit :
       others(lengths, quantity::length, origin(e.origins, "link_length", quantity::length))) {
    const std::string remedy = "units.link_length = \"" + unit.name + "\"";
    const double factor = unit.factor;
    all.push_back(
        {"link_length", unit.name, unit.instead_of, remedy, factor, false, {}, [factor](Experiment& one) {
           scale(one.link_length, factor);
         }});
    all.push_back({"link_length, x, y",
                   unit.name,
                   unit.instead_of,
                   remedy + ", columns.x.unit and columns.y.unit = \"" + unit.name + "\"",
                   factor,
                   false,
                   {},
                   [factor](Experiment& one) {
                     scale(one.link_length, factor);
                     for (Run& run : one.runs) scale_positions(run, factor);
                   }});
  }
}

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
      scale(angles, sense);
    };
    if (lengths) reverse(e.link_length);
    if (springs) reverse(e.joint_stiffness);
    if (masses) reverse(e.link_mass);
    for (Run& run : e.runs) {
      if (rest) reverse_angles(run.rest);
      if (!readings) continue;
      for (Reading& r : run.readings) reverse_angles(r.q);
    }
  }

  [[nodiscard]] std::string remedy() const {
    Names keys;
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
    Names what;
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

/// One list alone, all of the chain's, and with them the angles at rest, the measured angles, or both. In a
/// symmetric chain angles alone can be reversed (add_angles).
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
    with_angles.readings = measures_angles(e);
    if (with_angles.readings) all.push_back(with_angles.conversion());
  }
}

}  // namespace

std::vector<Conversion> conversions(const Experiment& experiment) {
  std::vector<Conversion> all;
  add_forces(experiment, all);
  add_angles(experiment, false, true, all);
  add_angles(experiment, true, false, all);
  add_angles(experiment, true, true, all);
  add_turned_joints(experiment, all);
  add_positions(experiment, all);
  add_units_of_chain(experiment, all);
  add_order_of_chain(experiment, all);
  return all;
}

Experiment converted(Experiment experiment, const Conversion& conversion) {
  if (conversion.chain) conversion.chain(experiment);
  if (conversion.run)
    for (Run& run : experiment.runs) conversion.run(run);
  return experiment;
}

}  // namespace plumbline::diagnose
