#include "diagnose/motion/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::motion {
namespace {

using diagnose::Coordinate, diagnose::ParameterRange;

/// Of a number whose zero is the nominal model: of either sign, and not negative.
ParameterRange both_ways(std::string_view name, std::string_view unit, double scale, double low,
                         double high) {
  return {name, unit, Coordinate::plain, scale, low, high};
}
ParameterRange one_way(std::string_view name, std::string_view unit, double scale, double high) {
  return both_ways(name, unit, scale, 0, high);
}

/// Root mean square about the mean.
double deviation(const std::vector<double>& values) {
  double sum = 0, squares = 0;
  for (const double x : values) sum += x, squares += x * x;
  const auto n = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / n - std::pow(sum / n, 2)));
}

Row row(std::string_view id, std::string_view words, std::vector<Parameter> parameters,
        bool refines = false) {
  return {std::string(id), std::string(words), std::move(parameters), refines};
}

/// A number that the model states, and that is another.
Row wrong(const Stated& number, double nominal) {
  const double scale = nominal == 0 ? number.typical : 0.2 * std::abs(nominal), far = 1e3 * number.typical;
  return row(number.id, number.words,
             {{both_ways("delta", number.unit, scale, number.signed_ ? -far : -nominal, far),
               {number.term},
               number.signed_ ? 0 : scale}});
}

std::vector<Row> rows_of_command(const Sizes& sizes) {
  return {
      row("command_delay", "a delay between command and motion",
          {{one_way("t_d", "s", 0.02, 0.5), {Term::command_delay}, 0.015}}),
      row("drive_lag", "a lag of the drive", {{one_way("tau", "s", 0.02, 0.5), {Term::drive_lag}, 0.01}}),
      row("dead_band", "a dead band of the servo",
          {{one_way("d", "rad", 0.01, sizes.angle), {Term::dead_band}, 0.01}}),
      row("duty_limit", "a lower limit of the duty",
          {{one_way("missing", "ratio", 0.3, 0.95),
            {Term::duty_missing},
            1 - 0.8 * std::min(1.0, sizes.duty)}}),
      row("speed_limit", "a limit of the servo's speed",
          {{one_way("slowness", "s/rad", 0.3 / sizes.speed, 10 / sizes.speed),
            {Term::command_slowness},
            0.7 / sizes.speed}}),
      row("clock_rate", "a clock whose seconds are others",
          {{both_ways("e", "ratio", 0.02, -0.2, 0.2), {Term::clock_rate}, 0}}),
      row("command_offset", "an offset between command and position",
          {{both_ways("offset", "rad", 0.02, -sizes.angle, sizes.angle), {Term::command_offset}, 0}}),
      row("command_scale", "a scale of the command",
          {{both_ways("e", "ratio", 0.02, -0.2, 0.2), {Term::command_scale}, 0}}),
      row("encoder_scale", "a scale of the encoder",
          {{both_ways("e", "ratio", 0.02, -0.2, 0.2), {Term::encoder_scale}, 0}}),
  };
}

std::vector<Row> rows_of_friction(const Sizes& sizes) {
  const double torque = 0.1 * sizes.torque;
  std::vector<Row> rows{
      row("stribeck_friction", "dry friction that falls with speed",
          {{one_way("tau_s", "N m", torque, 10 * sizes.torque), {Term::dry_rising}, torque},
           {{"v_s", "rad/s", Coordinate::plain, 0.3 * sizes.speed, 0.01 * sizes.speed, 10 * sizes.speed},
            {Term::rising_speed},
            0.2 * sizes.speed}}),
      row("quadratic_drag", "friction with the square of speed",
          {{one_way("d", "N m s^2/rad^2", torque / (sizes.speed * sizes.speed), 1e3 * torque),
            {Term::drag},
            0.1 * torque / (sizes.speed * sizes.speed)}}),
      row("load_friction", "a loss of the gear that grows with its load",
          {{one_way("c", "ratio", 0.2, 0.99), {Term::loss_driving, Term::loss_driven}, 0.1}}),
      row("directional_loss", "a loss of the gear that grows with its load, another one driving and driven",
          {{one_way("c_driving", "ratio", 0.2, 0.99), {Term::loss_driving}, 0.1},
           {one_way("c_driven", "ratio", 0.2, 0.99), {Term::loss_driven}, 0.2}},
          true),
      row("one_way_friction", "dry friction that differs by direction",
          {{both_ways("delta", "N m", torque, -sizes.torque, sizes.torque), {Term::direction}, 0}}),
  };
  if (sizes.warmer > 0)
    rows.push_back(row("friction_warming", "friction that changes with temperature",
                       {{both_ways("c", "1/K", 0.01, -1, 1), {Term::friction_warming}, 0}}));
  return rows;
}

/// Torques that depend on the angle of the motor, with so many periods to a turn of the joint.
std::vector<Row> rows_of_angle(const Sizes& sizes, const std::vector<double>& periods) {
  const auto waves = [](std::string_view unit, double scale, double high, Term sine, Term cosine, double n) {
    return std::vector<Parameter>{{both_ways("sine", unit, scale, -high, high), {sine}, scale / 2, n},
                                  {both_ways("cosine", unit, scale, -high, high), {cosine}, scale / 2, n}};
  };
  std::vector<Row> rows;
  for (const double n : periods) {
    const double torque = 0.1 * sizes.torque;
    rows.push_back(row(fmt::format("cogging({:g})", n),
                       fmt::format("a torque with {:g} periods to a turn (cogging)", n),
                       waves("N m", torque, 100 * torque, Term::cogging_sine, Term::cogging_cosine, n)));
    rows.push_back(row(fmt::format("torque_ripple({:g})", n),
                       fmt::format("a motor whose torque ripples, {:g} periods to a turn", n),
                       waves("ratio", 0.1, 1, Term::ripple_sine, Term::ripple_cosine, n)));
  }
  return rows;
}

/// They move apart where the rotor has an inertia alone.
std::vector<Row> rows_of_gear(const Sizes& sizes) {
  const double compliance = 0.05 * sizes.angle / sizes.torque;
  return {
      row("backlash", "play of the gear", {{one_way("play", "rad", 0.02, sizes.angle), {Term::play}, 0.02}}),
      row("elastic_gear", "a gear that gives way",
          {{one_way("compliance", "rad/(N m)", compliance, 20 * compliance),
            {Term::gear_compliance},
            compliance},
           {one_way("damping", "N m s/rad", 0.1 * std::sqrt(sizes.inertia / compliance),
                    10 * std::sqrt(sizes.inertia / compliance)),
            {Term::gear_damping},
            0.05 * std::sqrt(sizes.inertia / compliance)}}),
  };
}

/// \param end  of the angles that are read, on the side of the contact
Row contact(std::string_view id, std::string_view words, Term stiffness, Term from, const Sizes& sizes,
            double end) {
  const double middle = (sizes.highest + sizes.lowest) / 2, scale = sizes.torque / sizes.angle;
  return row(id, words,
             {{one_way("k", "N m/rad", scale, 1e3 * scale), {stiffness}, scale},
              {both_ways("from", "rad", sizes.angle, std::min(middle, end), std::max(middle, end)),
               {from},
               (middle + end) / 2}});
}

std::vector<Row> rows_of_load(const Sizes& sizes) {
  std::vector<Row> rows{
      row("load_mass", "another mass of the load",
          {{both_ways("e", "ratio", 0.1, -0.95, 10), {Term::load_mass}, 0}}),
      row("torque_offset", "a torque that always acts",
          {{both_ways("tau_0", "N m", 0.1 * sizes.torque, -10 * sizes.torque, 10 * sizes.torque),
            {Term::torque_offset},
            0}}),
      row("spring", "a spring or cable along the way",
          {{both_ways("k", "N m/rad", 0.1 * sizes.torque, -10 * sizes.torque, 100 * sizes.torque),
            {Term::spring},
            0}}),
  };
  rows.push_back(contact("contact_above", "a spring, cable or stop that acts from an angle on, upward",
                         Term::contact_above, Term::above_from, sizes, sizes.highest));
  rows.push_back(contact("contact_below", "a spring, cable or stop that acts from an angle on, downward",
                         Term::contact_below, Term::below_from, sizes, sizes.lowest));
  if (sizes.base_acceleration > 0)
    rows.push_back(row("base_motion", "a base that moves",
                       {{both_ways("share", "ratio", 1, -10, 10), {Term::base_motion}, 0}}));
  if (sizes.unpowered)
    rows.push_back(row("brake", "a brake while the drive is off",
                       {{one_way("d", "N m s/rad", 0.1 * sizes.torque / sizes.speed, 1e3 * sizes.torque),
                         {Term::brake},
                         0.03 * sizes.torque / sizes.speed}}));
  return rows;
}

/// Errors of readings: beside another channel alone a late position is no late command.
std::vector<Row> rows_of_readings(const Sizes& sizes) {
  const auto late = [](const ReadingError& error) {
    return row(error.id, error.words, {{one_way("t_d", "s", 0.01, 0.2), {error.term}, 0.005}});
  };
  std::vector<Row> rows;
  for (std::size_t c = 0; c < channel_count; ++c) {
    const double size = sizes.beside[c];
    if (size == 0) continue;
    const ChannelKind& kind = channel_kinds[c];
    rows.push_back(row(kind.scale.id, kind.scale.words,
                       {{both_ways("e", "ratio", 0.1, -0.95, 10), {kind.scale.term}, 0}}));
    rows.push_back(
        row(kind.zero.id, kind.zero.words,
            {{both_ways("zero", kind.unit, 0.1 * size, -10 * size, 10 * size), {kind.zero.term}, 0}}));
    rows.push_back(late(kind.delay));
  }
  if (!rows.empty())
    rows.push_back(late({"position_delay", "a late reading of position", Term::position_delay}));
  return rows;
}

}  // namespace

Sizes::Sizes(const std::vector<MotionLog>& logs, const Drive<double>& nominal) {
  double asked = 0;  // duties, squared
  double squares = 0, turns = 0, stamps = 0, volts = 0;
  std::array<double, channel_count> read{};
  for (const MotionLog& log : logs) {
    const std::size_t last = log.time.size() - 1;
    angle = std::max(angle, deviation(log.position));
    const auto [low, high] = std::minmax_element(log.position.begin(), log.position.end());
    const bool first = &log == &logs.front();
    highest = first ? *high : std::max(highest, *high), lowest = first ? *low : std::min(lowest, *low);
    gain += log.gain / static_cast<double>(logs.size());
    for (const double x : log.warmer) warmer = std::max(warmer, std::abs(x));
    for (const double x : log.base_acceleration) base_acceleration = std::max(base_acceleration, std::abs(x));
    inertia = std::max(inertia, log.inertia);
    torque = std::max(torque, log.gravity);
    for (const ChannelReadings& one : log.beside)
      for (const double x : one.value)
        beside[static_cast<std::size_t>(one.channel)] += x * x, ++read[static_cast<std::size_t>(one.channel)];
    for (std::size_t k = 0; k <= last; ++k) {
      volts += log.supply[k], ++stamps;
      unpowered = unpowered || !log.powered[k];
      if (!log.powered[k]) continue;
      const double own = log.gain * std::abs(log.command[k] - log.position[k]);
      duty = std::max(duty, own);
      asked += std::pow(std::min(1.0, own), 2);
    }
    // Over tenths of a second, so that the quantum of the encoder is no speed.
    for (std::size_t k = 0, from = 0; k <= last; ++k)
      if (const double past = log.time[k] - log.time[from]; past >= 0.1) {
        squares += std::pow(log.position[k] - log.position[from], 2) / past, turns += past, from = k;
      }
  }
  supply = volts / stamps;
  for (std::size_t c = 0; c < channel_count; ++c)
    if (read[c] > 0) beside[c] = std::sqrt(beside[c] / read[c]);
  speed = turns > 0 ? std::sqrt(squares / turns) : 0;
  if (torque == 0 && angle > 0)
    torque = std::max(inertia * speed * speed / angle,
                      nominal[Term::stall_torque] * supply * std::sqrt(asked / stamps));
}

std::set<Term> terms_of(const Row& row) {
  std::set<Term> terms;
  for (const Parameter& one : row.parameters) terms.insert(one.terms.begin(), one.terms.end());
  return terms;
}

std::vector<Stated> stated_numbers(const Sizes& sizes) {
  const double damping = 0.1 * sizes.torque / std::max(sizes.speed, 1e-6);
  return {
      {Term::stall_torque, "stall_torque", "another torque of the motor", "N m/V",
       5 * sizes.torque / std::max(sizes.supply, 1e-6), false},
      {Term::back_emf, "back_emf", "another back EMF", "N m s/rad", damping, false},
      {Term::armature, "armature", "another inertia of the rotor (armature)", "kg m^2", 0.5 * sizes.inertia,
       false},
      {Term::zero, "encoder_zero", "another zero of the encoder", "rad", 0.02, true},
      {Term::dry, "joint_friction", "dry friction in the joint", "N m", 0.05 * sizes.torque, false},
      {Term::viscous, "viscous_friction", "viscous friction in the joint", "N m s/rad", damping, false},
      {Term::derivative_gain, "derivative_gain", "another derivative part of the servo", "s/rad",
       0.1 * std::min(1.0, sizes.duty) / std::max(sizes.speed, 1e-6), false},
      {Term::integral_gain, "integral_gain", "another integral part of the servo", "1/(rad s)",
       0.5 * sizes.gain, false},
      {Term::gravity_forward, "gravity_forward", "another feed-forward of gravity", "ratio", 0.3, true},
  };
}

std::vector<Row> catalogue(const Sizes& sizes, const Drive<double>& nominal, const std::vector<Term>& unknown,
                           const std::vector<double>& periods) {
  std::vector<Row> rows;
  for (const Stated& number : stated_numbers(sizes))
    if (std::find(unknown.begin(), unknown.end(), number.term) == unknown.end())
      rows.push_back(wrong(number, nominal[number.term]));
  for (const std::vector<Row>& some :
       {rows_of_command(sizes), rows_of_friction(sizes), rows_of_angle(sizes, periods), rows_of_load(sizes),
        rows_of_readings(sizes)})
    rows.insert(rows.end(), some.begin(), some.end());
  const bool has_rotor = nominal.has(Term::armature) ||
                         std::find(unknown.begin(), unknown.end(), Term::armature) != unknown.end();
  if (has_rotor)
    for (const Row& one : rows_of_gear(sizes)) rows.push_back(one);
  return rows;
}

}  // namespace plumbline::motion
