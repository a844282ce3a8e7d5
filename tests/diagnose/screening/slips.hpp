#pragma once
/// \file
/// The slips that a lab makes when it writes numbers down, planted into an experiment.

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose::test {

using Spoil = std::function<void(Experiment&)>;

/// A planted wrong convention: the name that the question must contain, and its construction.
struct Slip {
  std::string expected;  ///< "Fx, Fy like kgf"
  Spoil spoil;
  bool of_angles = false;  ///< of measured joint angles: not every experiment has them
};

inline Spoil each_reading(const std::function<void(Reading&)>& change) {
  return [change](Experiment& experiment) {
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) change(reading);
  };
}

inline Spoil each_rest(const std::function<void(std::vector<double>&)>& change) {
  return [change](Experiment& experiment) {
    for (Run& run : experiment.runs) change(run.rest);
  };
}

/// Changes the joint angles that a reading has.
inline void each_angles(Reading& reading, const std::function<void(std::vector<double>&)>& change) {
  const auto first = reading.value.begin() + std::min<std::ptrdiff_t>(column_q, std::ssize(reading.value));
  std::vector<double> angles(first, reading.value.end());
  if (angles.empty()) return;
  change(angles);
  std::copy(angles.begin(), angles.end(), first);
}

inline void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

inline std::vector<Slip> slips_of_units() {
  constexpr double degree = 57.29577951308232;
  std::vector<Slip> all;
  for (const auto& [name, si] : {std::pair{"kgf", 9.80665},
                                 {"lbf", 4.4482216},
                                 {"kN", 1e3},
                                 {"mN", 1e-3},
                                 {"gf", 9.80665e-3},
                                 {"N that were multiplied by 9.80665 once too often", 1 / 9.80665}}) {
    const double unit = si;
    all.push_back({std::string("Fx, Fy like ") + name, [unit](Experiment& e) {
                     each_reading([unit](Reading& r) { r[column_Fx] /= unit, r[column_Fy] /= unit; })(e);
                     e.noise[Channel::Name::Fx] /= unit, e.noise[Channel::Name::Fy] /= unit;
                   }});
  }
  for (const auto& [name, si] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}}) {
    const double unit = si;
    all.push_back({std::string("x, y like ") + name, [unit](Experiment& e) {
                     each_reading([unit](Reading& r) { r[column_x] /= unit, r[column_y] /= unit; })(e);
                     e.noise[Channel::Name::x] /= unit, e.noise[Channel::Name::y] /= unit;
                   }});
    all.push_back(
        {std::string("link_length like ") + name, [unit](Experiment& e) { scale(e.link_length, 1 / unit); }});
    all.push_back({std::string("link_length, x, y like ") + name, [unit](Experiment& e) {
                     scale(e.link_length, 1 / unit);
                     each_reading([unit](Reading& r) { r[column_x] /= unit, r[column_y] /= unit; })(e);
                     e.noise[Channel::Name::x] /= unit, e.noise[Channel::Name::y] /= unit;
                   }});
  }
  for (const auto& [name, si] : {std::pair{"N mm/rad", 1e-3},
                                 {"N cm/rad", 1e-2},
                                 {"N m/deg", degree},
                                 {"N mm/deg", degree / 1e3},
                                 {"kgf cm/rad", 0.0980665},
                                 {"kgf m/rad", 9.80665},
                                 {"lbf in/rad", 0.1129848}}) {
    const double unit = si;
    all.push_back({std::string("joint_stiffness like ") + name,
                   [unit](Experiment& e) { scale(e.joint_stiffness, 1 / unit); }});
  }
  all.push_back({"rest like degrees", each_rest([](std::vector<double>& rest) { scale(rest, degree); })});
  all.push_back({"q like degrees", each_reading([](Reading& r) {
                   each_angles(r, [](std::vector<double>& q) { scale(q, degree); });
                 }),
                 true});
  return all;
}

inline std::vector<Slip> slips_of_axes() {
  const auto forces = [](Experiment& e) {
    std::swap(e.noise[Channel::Name::Fx], e.noise[Channel::Name::Fy]);
    each_reading([](Reading& r) { std::swap(r[column_Fx], r[column_Fy]); })(e);
  };
  const auto positions = [](Experiment& e) {
    std::swap(e.noise[Channel::Name::x], e.noise[Channel::Name::y]);
    each_reading([](Reading& r) { std::swap(r[column_x], r[column_y]); })(e);
  };
  return {
      {"Fx, Fy like forces of the opposite sign",
       each_reading([](Reading& r) { r[column_Fx] = -r[column_Fx], r[column_Fy] = -r[column_Fy]; })},
      {"Fx, Fy like forces with x mirrored", each_reading([](Reading& r) { r[column_Fx] = -r[column_Fx]; })},
      {"Fx, Fy like forces with y mirrored", each_reading([](Reading& r) { r[column_Fy] = -r[column_Fy]; })},
      {"Fx, Fy like forces with x and y swapped", forces},
      {"x, y like an end point with x and y swapped", positions},
      {"x, y like an end point with y mirrored",
       each_reading([](Reading& r) { r[column_y] = -r[column_y]; })},
      {"x, y, Fx, Fy like axes with x and y swapped", [=](Experiment& e) { forces(e), positions(e); }},
      {"x, y, Fx, Fy like axes with x mirrored",
       each_reading([](Reading& r) { r[column_x] = -r[column_x], r[column_Fx] = -r[column_Fx]; })},
      {"x, y, Fx, Fy like axes with y mirrored",
       each_reading([](Reading& r) { r[column_y] = -r[column_y], r[column_Fy] = -r[column_Fy]; })},
  };
}

inline std::vector<Slip> slips_of_joints() {
  using List = std::vector<double>;
  const auto absolute = [](List& q) {
    for (std::size_t i = 1; i < q.size(); ++i) q[i] += q[i - 1];
  };
  const auto opposite = [](List& q) { scale(q, -1); };
  const auto reversed = [](List& q) { std::reverse(q.begin(), q.end()); };
  const auto of_q = [](const std::function<void(List&)>& change) {
    return each_reading([change](Reading& r) { each_angles(r, change); });
  };
  return {
      {"rest like angles of the opposite sign", each_rest(opposite)},
      {"rest like absolute angles", each_rest(absolute)},
      {"rest like angles in the reverse order", each_rest(reversed)},
      {"q like angles of the opposite sign", of_q(opposite), true},
      {"q like absolute angles", of_q(absolute), true},
      {"q like angles in the reverse order", of_q(reversed), true},
      {"joint_stiffness like a list from the end point on",
       [=](Experiment& e) { reversed(e.joint_stiffness); }},
  };
}

}  // namespace plumbline::diagnose::test
