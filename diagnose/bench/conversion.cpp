#include "diagnose/bench/conversion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/order_of_chain.hpp"
#include "diagnose/bench/unit.hpp"

namespace plumbline::diagnose {
namespace {

using Names = std::vector<const char*>;

const Names torques{"N m", "N mm", "N cm", "kgf cm", "lbf in"}, sliding{"N/m", "N/mm", "kgf/mm", "lbf/in"};
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

/// A decimal point that went astray, beside the other units: "ten times as large".
std::vector<Other> astray(const Origin& read, const std::vector<Other>& beside) {
  constexpr std::array<std::pair<const char*, double>, 4> slips{{{"ten times as large", 0.1},
                                                                 {"a tenth as large", 10},
                                                                 {"a hundred times as large", 0.01},
                                                                 {"a hundredth as large", 100}}};
  std::vector<Other> all;
  for (const auto& [name, factor] : slips) {
    const auto same = [f = factor](const Other& unit) { return std::abs(unit.factor / f - 1) < 1e-3; };
    if (std::none_of(beside.begin(), beside.end(), same)) all.push_back({name, read.unit, factor});
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
  for (Reading& r : run.readings) r[column_Fx] *= factor, r[column_Fy] *= factor;
}

void scale_positions(Run& run, double factor) {
  for (Reading& r : run.readings) r[column_x] *= factor, r[column_y] *= factor;
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
    all.push_back({.what = "Fx, Fy",
                   .looks_like = name,
                   .expected = read.unit,
                   .remedy = "columns.Fx.unit and columns.Fy.unit = \"" + remedy + "\"",
                   .factor = factor,
                   .run = [factor](Run& run) { scale_forces(run, factor); }});
  };
  const std::vector<Other> units = others(forces, quantity::force, read);
  for (const Other& unit : units) add(unit.name, unit.factor, unit.name);
  if (read.in_si == 1) add("N that were multiplied by 9.80665 once too often", 1 / 9.80665, "0.101972 N");
  for (const Other& slip : astray(read, units)) {
    add("numbers " + slip.name, slip.factor, fmt::format("{} {}", slip.factor, read.unit));
    all.back().of_some = true;
  }
  for (const Axes& one : axes) {
    all.push_back({"Fx, Fy",
                   std::string("forces ") + one.name,
                   "the force on the end point, in the base frame",
                   one.remedy("Fx", "Fy"),
                   0,
                   one.mirrors_y(),
                   [one](Run& run) {
                     for (Reading& r : run.readings) one(r[column_Fx], r[column_Fy]);
                   },
                   {}});
  }
}

/// Changes the joint angles that are read.
void each_angles(Run& run, const std::function<void(std::vector<double>&)>& change) {
  for (Reading& reading : run.readings) {
    std::vector<double> angles = reading.angles(run.rest.size());
    change(angles);
    for (std::size_t j = 0; j < angles.size(); ++j) Channel(Channel::Name::q, j).in(reading) = angles[j];
  }
}

/// A convention of joint angles. The remedy of columns has a place for their key.
struct Angles {
  std::string name, remedy_of_columns, remedy_of_rest;
  double factor = 0;
  std::function<void(std::vector<double>&)> convert;
};

std::vector<Angles> ways_to_write_angles(const Origin& read) {
  std::vector<Angles> all;
  for (const Other& unit : others(angles_in, quantity::angle, read)) {
    const double factor = unit.factor;
    all.push_back({unit.name == "deg" ? "degrees" : "radians", "columns.{}.unit = \"" + unit.name + "\"",
                   "units.rest = \"" + unit.name + "\"", factor,
                   [factor](std::vector<double>& q) { scale(q, factor); }});
  }
  all.push_back({"angles of the opposite sign", "columns.{}.sign = -1", "the signs of rest turned", 0,
                 [](std::vector<double>& q) { scale(q, -1); }});
  all.push_back({"absolute angles", "columns.{}.absolute = true", "in rest the differences of neighbours", 0,
                 [](std::vector<double>& q) { std::adjacent_difference(q.begin(), q.end(), q.begin()); }});
  all.push_back({"angles in the reverse order", "the columns of columns.{} in reverse", "rest in reverse", 0,
                 [](std::vector<double>& q) { std::reverse(q.begin(), q.end()); }});
  return all;
}

/// \param rest, readings  which of them are in this convention
void add_angles(const Experiment& e, bool rest, bool readings, std::vector<Conversion>& all) {
  const bool commanded = std::ranges::any_of(e.runs, &Run::commands_joints);
  const std::string key_of_rest = commanded ? "q_command" : "rest";
  const Origin read = !rest       ? origin_of_channel(e, "q1", quantity::angle)
                      : commanded ? origin_of_channel(e, "q_command1", quantity::angle)
                                  : origin(e.origins, "rest", quantity::angle);
  for (const Angles& one : ways_to_write_angles(read)) {
    const auto of_columns = [&](const std::string& key) {
      return fmt::format(fmt::runtime(one.remedy_of_columns), key);
    };
    std::string remedy = !rest ? "" : commanded ? of_columns(key_of_rest) : one.remedy_of_rest;
    if (readings) remedy += (rest ? ", " : "") + of_columns("q");
    all.push_back({rest && readings ? key_of_rest + ", q"
                   : rest           ? key_of_rest
                                    : "q",
                   one.name,
                   "relative joint angles, counter-clockwise, from joint 1, in " + read.unit,
                   remedy,
                   one.factor,
                   one.name == "angles of the opposite sign",
                   [=](Run& run) {
                     if (rest) run.each_rest(one.convert);
                     if (!readings) return;
                     each_angles(run, one.convert);
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
  return std::any_of(e.runs.begin(), e.runs.end(), [](const Run& run) { return run.reads_angles(); });
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
    const auto turn_rest = [j](Run& run) {
      run.each_rest([j](std::vector<double>& rest) { rest[j] *= -1; });
    };
    const auto turn_readings = [j](Run& run) {
      for (Reading& r : run.readings) r[Channel(Channel::Name::q, j).column] *= -1;
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
  const Origin read = origin_of_channel(e, "x", quantity::length);
  const auto add = [&](const std::string& name, double factor, const std::string& remedy) {
    all.push_back({.what = "x, y",
                   .looks_like = name,
                   .expected = read.unit,
                   .remedy = "columns.x.unit and columns.y.unit = \"" + remedy + "\"",
                   .factor = factor,
                   .run = [factor](Run& run) { scale_positions(run, factor); }});
  };
  const std::vector<Other> units = others(lengths, quantity::length, read);
  for (const Other& unit : units) add(unit.name, unit.factor, unit.name);
  for (const Other& slip : astray(read, units)) {
    add("numbers " + slip.name, slip.factor, fmt::format("{} {}", slip.factor, read.unit));
    all.back().of_some = true;
  }
  for (const Axes& one : axes) {
    const auto positions = [one](Run& run) {
      for (Reading& r : run.readings) one(r[column_x], r[column_y]);
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
                     for (Reading& r : run.readings) one(r[column_Fx], r[column_Fy]);
                   },
                   {}});
  }
}

void add_units_of_stiffness(const Experiment& e, const Names& names, const Quantity& quantity,
                            std::vector<Conversion>& all) {
  for (const Other& unit : others(names, quantity, origin(e.origins, "joint_stiffness", quantity))) {
    all.push_back({"joint_stiffness",
                   unit.name,
                   unit.instead_of,
                   "units.joint_stiffness = \"" + unit.name + "\"",
                   unit.factor,
                   false,
                   {},
                   [factor = unit.factor](Experiment& one) { scale(one.joint_stiffness, factor); }});
  }
}

void add_units_of_chain(const Experiment& e, std::vector<Conversion>& all) {
  add_units_of_stiffness(e, stiffnesses, quantity::stiffness, all);
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

/// The units, decimal points and the sign of one channel of a joint alone.
void add_channel_of_joint(const Experiment& e, const Channel& channel, const Names& names,
                          const Quantity& quantity, std::vector<Conversion>& all) {
  const std::string label = channel.label();
  const Origin read = origin_of_channel(e, label, quantity);
  const auto multiply = [channel](double factor) {
    return [=](Run& run) {
      for (Reading& r : run.readings) channel.in(r) *= factor;
    };
  };
  const auto add = [&](const std::string& name, double factor, const std::string& unit, bool of_some) {
    all.push_back({.what = label,
                   .looks_like = name,
                   .expected = read.unit,
                   .remedy = "columns." + label + ".unit = \"" + unit + "\"",
                   .factor = factor,
                   .run = multiply(factor),
                   .of_some = of_some});
  };
  const std::vector<Other> units = others(names, quantity, read);
  for (const Other& unit : units) add(unit.name, unit.factor, unit.name, false);
  for (const Other& slip : astray(read, units))
    add("numbers " + slip.name, slip.factor, fmt::format("{} {}", slip.factor, read.unit), true);
  all.push_back({.what = label,
                 .looks_like = "numbers of the opposite sign",
                 .expected = "a load that acts on the joint where it moves",
                 .remedy = "columns." + label + ".sign = -1",
                 .run = multiply(-1)});
}

std::vector<Conversion> conversions_of_joint(const Experiment& e) {
  const EndKind& end = e.end();
  const bool slides = e.slides(0);
  std::vector<Conversion> all;
  add_channel_of_joint(e, end.load.front(), slides ? forces : torques,
                       slides ? quantity::force : quantity::torque, all);
  add_channel_of_joint(e, end.place.front(), slides ? lengths : angles_in,
                       slides ? quantity::length : quantity::angle, all);
  add_units_of_stiffness(e, slides ? sliding : stiffnesses,
                         slides ? quantity::sliding_stiffness : quantity::stiffness, all);
  return all;
}

}  // namespace

std::vector<Conversion> conversions(const Experiment& experiment) {
  if (!experiment.has_links()) return conversions_of_joint(experiment);
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
