#include "diagnose/bench/conversion.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

namespace plumbline::diagnose {
namespace {

struct Unit {
  const char* name;
  double in_si;
};

constexpr double degree = std::numbers::pi / 180;
constexpr std::array<Unit, 5> forces{
    {{"kgf", 9.80665}, {"kN", 1e3}, {"mN", 1e-3}, {"lbf", 4.4482216}, {"gf", 9.80665e-3}}};
constexpr std::array<Unit, 3> lengths{{{"mm", 1e-3}, {"cm", 1e-2}, {"inches", 0.0254}}};
constexpr std::array<Unit, 5> stiffnesses{{{"N mm/rad", 1e-3},
                                           {"N cm/rad", 1e-2},
                                           {"N m/deg", 1 / degree},
                                           {"N mm/deg", 1e-3 / degree},
                                           {"kgf cm/rad", 9.80665e-2}}};

/// How far the best common factor may be from a unit's and still be taken for it: 5 % where stiffnesses and
/// gains may err as much (nine times too stiff is not kgf), a quarter where nothing errs by so much.
double tolerance_of(double factor) {
  return factor > 20 || factor < 1.0 / 20 ? 0.25 : 0.05;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

/// A way to lay two axes over two others.
struct Axes {
  const char* name;
  double xx, xy, yx, yy;
  /// One component alone must not go missing with the other.
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
};

constexpr std::array<Axes, 7> axes{{{"of the opposite sign", -1, 0, 0, -1},
                                    {"with y mirrored", 1, 0, 0, -1},
                                    {"with x mirrored", -1, 0, 0, 1},
                                    {"with x and y swapped", 0, 1, 1, 0},
                                    {"turned by 90 degrees", 0, 1, -1, 0},
                                    {"turned by -90 degrees", 0, -1, 1, 0},
                                    {"with x and y swapped and of the opposite sign", 0, -1, -1, 0}}};

/// A way to write joint angles.
struct Angles {
  const char* name;
  void (*convert)(std::vector<double>&);
  double tolerance;
};

void relative(std::vector<double>& angle) {
  std::adjacent_difference(angle.begin(), angle.end(), angle.begin());
}

const std::array<Angles, 4> angles{{
    {"degrees", [](std::vector<double>& q) { scale(q, degree); }, 0.25},
    {"angles of the opposite sign", [](std::vector<double>& q) { scale(q, -1); }, 0},
    {"absolute angles", relative, 0},
    {"angles in the reverse order", [](std::vector<double>& q) { std::reverse(q.begin(), q.end()); }, 0},
}};

void add_forces(std::vector<Conversion>& all) {
  for (const Unit& unit : forces) {
    all.push_back({"Fx, Fy",
                   unit.name,
                   "N",
                   tolerance_of(unit.in_si),
                   [unit](Run& run) {
                     for (Reading& r : run.readings) r.Fx *= unit.in_si, r.Fy *= unit.in_si;
                   },
                   {}});
  }
  for (const Axes& one : axes) {
    all.push_back({"Fx, Fy",
                   std::string("forces ") + one.name,
                   "the force on the end point, in the base frame",
                   0,
                   [one](Run& run) {
                     for (Reading& r : run.readings) one(r.Fx, r.Fy);
                   },
                   {}});
  }
}

void add_angles(std::vector<Conversion>& all) {
  const char* expected = "relative joint angles, counter-clockwise, from joint 1, in rad";
  for (const Angles& one : angles) {
    const auto readings = [one](Run& run) {
      for (Reading& r : run.readings) one.convert(r.q);
    };
    const auto rest = [one](Run& run) { one.convert(run.rest); };
    all.push_back({"q", one.name, expected, one.tolerance, readings, {}});
    all.push_back({"rest", one.name, expected, one.tolerance, rest, {}});
    all.push_back({"rest, q",
                   one.name,
                   expected,
                   one.tolerance,
                   [readings, rest](Run& run) { readings(run), rest(run); },
                   {}});
  }
}

void add_positions(std::vector<Conversion>& all) {
  for (const Unit& unit : lengths) {
    all.push_back({"x, y",
                   unit.name,
                   "m",
                   tolerance_of(unit.in_si),
                   [unit](Run& run) {
                     for (Reading& r : run.readings) r.x *= unit.in_si, r.y *= unit.in_si;
                   },
                   {}});
  }
  for (const Axes& one : axes) {
    const auto positions = [one](Run& run) {
      for (Reading& r : run.readings) one(r.x, r.y);
    };
    all.push_back({"x, y",
                   std::string("an end point ") + one.name,
                   "the end point in the base frame",
                   0,
                   positions,
                   {}});
    all.push_back({"x, y, Fx, Fy",
                   std::string("axes ") + one.name,
                   "the base frame",
                   0,
                   [one, positions](Run& run) {
                     positions(run);
                     for (Reading& r : run.readings) one(r.Fx, r.Fy);
                   },
                   {}});
  }
}

void add_chain(std::vector<Conversion>& all) {
  for (const Unit& unit : stiffnesses) {
    all.push_back(
        {"joint_stiffness", unit.name, "N m/rad", tolerance_of(unit.in_si), {}, [unit](Experiment& e) {
           scale(e.joint_stiffness, unit.in_si);
         }});
  }
  for (const Unit& unit : lengths) {
    all.push_back({"link_length", unit.name, "m", tolerance_of(unit.in_si), {}, [unit](Experiment& e) {
                     scale(e.link_length, unit.in_si);
                   }});
    all.push_back({"link_length, x, y", unit.name, "m", tolerance_of(unit.in_si), {}, [unit](Experiment& e) {
                     scale(e.link_length, unit.in_si);
                     for (Run& run : e.runs)
                       for (Reading& r : run.readings) r.x *= unit.in_si, r.y *= unit.in_si;
                   }});
  }
  const auto reverse = [](std::vector<double>& values) { std::reverse(values.begin(), values.end()); };
  const char* from_base = "joints and links from the base on";
  all.push_back(
      {"joint_stiffness", "a list from the end point on", from_base, 0, {}, [reverse](Experiment& e) {
         reverse(e.joint_stiffness);
       }});
  all.push_back({"link_length, joint_stiffness",
                 "lists from the end point on",
                 from_base,
                 0,
                 {},
                 [reverse](Experiment& e) {
                   reverse(e.link_length), reverse(e.joint_stiffness), reverse(e.link_mass);
                 }});
}

}  // namespace

const std::vector<Conversion>& conversions() {
  static const std::vector<Conversion> all = [] {
    std::vector<Conversion> list;
    add_forces(list);
    add_angles(list);
    add_positions(list);
    add_chain(list);
    return list;
  }();
  return all;
}

Experiment converted(Experiment experiment, const Conversion& conversion) {
  if (conversion.chain) conversion.chain(experiment);
  if (conversion.run)
    for (Run& run : experiment.runs) conversion.run(run);
  return experiment;
}

}  // namespace plumbline::diagnose
