#include "diagnose/bench/read_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>
#include <span>

#include "diagnose/bench/median.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Name = Channel::Name;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z

/// Makes the columns of a table of poses.
class Columns {
 public:
  Columns(const Experiment& experiment, const Section& units)
      : joints_(experiment.arm->arm.size()),
        place_(unit(units, "place", quantity::length)),
        angle_(unit(units, "angle", quantity::angle)),
        force_(unit(units, "force", quantity::force)),
        moment_(unit(units, "torque", quantity::torque)),
        mass_(unit(units, "mass", quantity::mass)) {
    units.allow_only({"place", "angle", "force", "torque", "mass"});
    add("t", quantity::time, si_unit(quantity::time), Says::time);
    for (const char* stem : {"q_command", "q"})
      for (std::size_t j = 0; j < joints_; ++j) add_coordinate(stem, j, experiment.arm->arm.links[j].kind);
    for (std::size_t j = 0; j < joints_; ++j)
      add("torque" + std::to_string(j + 1), quantity::torque, moment_, Says::channel, "torque")
          .reads.emplace(Name::drive, j, joints_);
    for (std::size_t p = 0; p < experiment.arm_bench.points.size(); ++p)
      add_point(experiment.arm_bench.points[p].name, p);
    for (std::size_t s = 0; s < experiment.arm_bench.sensors.size(); ++s) add_sensor(experiment.arm_bench, s);
    for (const char* name : {"Fx", "Fy", "Fz"}) add(name, quantity::force, force_, Says::wrench);
    for (const char* name : {"Mx", "My", "Mz"}) add(name, quantity::torque, moment_, Says::wrench);
    add("weight", quantity::mass, mass_, Says::other);
    all_.push_back(own_column("temperature", nullptr));
    require_distinct();
  }

  [[nodiscard]] std::vector<Column> all() && { return std::move(all_); }

 private:
  static Unit unit(const Section& units, const char* key, const Quantity& quantity) {
    return units.has(key) ? parse_unit(units.text(key, quantity.examples), quantity, units.place(key))
                          : si_unit(quantity);
  }

  Column& add(const std::string& name, const Quantity& quantity, const Unit& unit, Says says,
              const std::string& group = "") {
    Column column = own_column(name, &quantity);
    column.unit = column.usual_unit = unit;
    column.says = says, column.group = group;
    return all_.emplace_back(std::move(column));
  }

  void add_coordinate(const std::string& stem, std::size_t joint, JointKind kind) {
    const bool slides = kind == JointKind::prismatic, commands = stem == "q_command";
    Column& column = add(stem + std::to_string(joint + 1), slides ? quantity::length : quantity::angle,
                         slides ? place_ : angle_, commands ? Says::command : Says::channel, stem);
    if (!commands) column.reads.emplace(Name::q, joint);
  }

  void add_point(const std::string& name, std::size_t point) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      add(name + "_" + "xyz"[axis], quantity::length, place_, Says::channel, name)
          .reads.emplace(Name::place, 3 * point + axis, joints_);
    for (std::size_t axis = 0; axis < 3; ++axis)
      add(name + "_r" + "xyz"[axis], quantity::angle, angle_, Says::channel, name + "_r")
          .reads.emplace(Name::turn, 3 * point + axis, joints_);
    for (const char part : {'w', 'x', 'y', 'z'}) {
      Column column = own_column(name + "_q" + part, nullptr);
      column.says = Says::other, column.group = name + "_q";
      all_.push_back(std::move(column));
    }
  }

  void add_sensor(const ArmBench& bench, std::size_t number) {
    const ArmSensor& sensor = bench.sensors[number];
    for (std::size_t i = 0; i < sensor.kind->numbers; ++i) {
      const Channel channel = sensor.channel(number, i, joints_, bench.points.size());
      const Quantity& reads = quantity_of(channel.sensor());
      const bool length = &reads == &quantity::length, angle = &reads == &quantity::angle;
      add(sensor.name + std::string(sensor.kind->column[i]), reads,
          length  ? place_
          : angle ? angle_
                  : si_unit(reads),
          Says::channel)
          .reads = channel;
    }
  }

  void require_distinct() const {
    std::set<std::string> names;
    for (const Column& column : all_)
      if (!names.insert(column.name).second)
        throw Error("arm", "two columns \"" + files::shown(column.name) + "\"",
                    "names of points and sensors by which each column has its own");
  }

  std::size_t joints_;
  Unit place_, angle_, force_, moment_, mass_;
  std::vector<Column> all_;
};

bool has_column(const std::vector<SamplePart>& parts, const Column& column) {
  return std::ranges::any_of(parts, [&](const SamplePart& part) {
    return column.number > 0 || column.constant || std::ranges::count(part.table.header, column.name) > 0;
  });
}

/// Angles on the motors' side are commands.
void command_by_angles(SampleFormat& format) {
  const auto first = std::ranges::find(format.columns, "q", &Column::group);
  for (Column& column : format.columns) {
    if (column.says != Says::command) continue;
    const auto own = first + (&column - &*std::ranges::find(format.columns, Says::command, &Column::says));
    Column angle = *own;
    angle.says = Says::command, angle.group = column.group, angle.reads.reset();
    column = std::move(angle);
  }
  std::erase_if(format.columns, [](const Column& one) { return one.group == "q"; });
}

/// Tells orientations from the nominal ones.
class Orientations {
 public:
  Orientations(const Experiment& experiment, Samples& samples) : experiment_(experiment), samples_(samples) {}

  void tell() {
    require_order();
    for (std::size_t row = 0; row < samples_.readings.size(); ++row)
      for (std::size_t p = 0; p < points(); ++p) tell(p, row);
  }

 private:
  [[nodiscard]] std::size_t points() const { return experiment_.arm_bench.points.size(); }

  [[nodiscard]] Quaternion quaternion(std::size_t point, std::size_t row) const {
    Quaternion q;
    std::copy_n(samples_.further[row].begin() + static_cast<std::ptrdiff_t>(4 * point), 4, q.begin());
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    constexpr double written_to = 0.01;
    if (std::abs(square - 1) > written_to)
      throw Error(samples_.where[row] + ", " + experiment_.arm_bench.points[point].name + "_qw",
                  fmt::format("a quaternion of length {:.4g}", std::sqrt(square)), "length 1");
    return q;
  }

  [[nodiscard]] Eigen::Matrix3d nominal_frame(std::size_t point, std::size_t row) const {
    return nominal_pose(experiment_.arm->arm, experiment_.arm_bench.points[point].at,
                        samples_.readings[row].rest)
        .linear();
  }

  static Vector3<double> turned(const Eigen::Matrix3d& told, const Eigen::Quaterniond& seen) {
    return rotation_vector<double>(told.transpose() * seen.normalized().toRotationMatrix());
  }

  /// \throws Error where the numbers, read as x, y, z, w, are those of the arm, and as they are not
  void require_order() const {
    std::vector<double> as_read, other;
    for (std::size_t p = 0; p < points(); ++p)
      for (std::size_t row = 0; row < samples_.readings.size(); ++row) {
        const Quaternion q = quaternion(p, row);
        if (std::isnan(q[0])) continue;
        const Eigen::Matrix3d told = nominal_frame(p, row);
        as_read.push_back(turned(told, Eigen::Quaterniond(q[0], q[1], q[2], q[3])).norm());
        other.push_back(turned(told, Eigen::Quaterniond(q[3], q[0], q[1], q[2])).norm());
      }
    constexpr double far = 0.5, near = 0.2;  // rad
    if (as_read.empty() || median(as_read) < far || median(other) > near) return;
    throw Error(samples_.where.front(),
                "quaternions that agree with the arm where their first number is x and their last is w",
                "columns named after what they hold: _qw, _qx, _qy, _qz");
  }

  void tell(std::size_t point, std::size_t row) {
    Reading& reading = samples_.readings[row];
    const std::ptrdiff_t first = Channel(Name::turn, 3 * point, reading.rest.size()).column;
    Vector3<double> vector(reading[first], reading[first + 1], reading[first + 2]);
    const Quaternion q = quaternion(point, row);
    if (vector.allFinite() && !std::isnan(q[0]))
      throw Error(
          samples_.where[row],
          "two orientations of point '" + files::shown(experiment_.arm_bench.points[point].name) + "'",
          "one");
    if (vector.allFinite())
      vector = turned(nominal_frame(point, row), Eigen::Quaterniond(rotation_by(vector)));
    else if (!std::isnan(q[0]))
      vector = turned(nominal_frame(point, row), Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
    for (int axis = 0; axis < 3; ++axis) reading[first + axis] = vector(axis);
  }

  const Experiment& experiment_;
  Samples& samples_;
};

void hang(const std::vector<double>& weights, const Vector3<double>& gravity, Samples& samples) {
  for (std::size_t row = 0; row < samples.readings.size(); ++row) {
    std::vector<double>& wrench = samples.readings[row].wrench;
    if (!wrench.empty())
      throw Error(samples.where[row], "columns of a weight and of a wrench", "one of them");
    if (std::isnan(weights[row]))
      throw Error(samples.where[row], "an empty load", "the load of every reading");
    const Vector3<double> force = weights[row] * gravity;
    wrench = {force.x(), force.y(), force.z(), 0, 0, 0};
  }
}

}  // namespace

PoseFormat pose_format(const Experiment& experiment, const Section& units, bool motor_side) {
  SampleFormat table;
  table.columns = Columns(experiment, units).all();
  table.any_order = table.all_known = table.commanded = table.free_end = true;
  return {std::move(table), motor_side};
}

Samples read_poses(std::vector<SamplePart> parts, const PoseFormat& format, const Experiment& experiment) {
  const std::vector<Column>& columns = format.table.columns;
  const bool by_motors =
                 format.motor_side && has_column(parts, *std::ranges::find(columns, "q", &Column::group)),
             is_warm = has_column(parts, columns.back()),
             hangs = has_column(parts, *std::ranges::find(columns, "weight", &Column::channel));
  for (SamplePart& part : parts) {
    if (by_motors) command_by_angles(part.format);
    if (!is_warm) part.format.columns.pop_back();
  }
  Samples samples = read_samples(parts, Control::force);
  Orientations(experiment, samples).tell();
  std::vector<double> weights;
  for (const std::vector<double>& further : samples.further) weights.push_back(further.back());
  if (hangs) hang(weights, experiment.arm->arm.gravity, samples);
  return samples;
}

}  // namespace plumbline::diagnose
