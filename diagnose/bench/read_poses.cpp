#include "diagnose/bench/read_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/field.hpp"
#include "diagnose/bench/median.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

using ColumnNames = std::vector<std::string>;

ColumnNames counted(const std::string& stem, std::size_t count) {
  ColumnNames all;
  for (std::size_t i = 1; i <= count; ++i) all.push_back(stem + std::to_string(i));
  return all;
}

ColumnNames suffixed(const std::string& stem, const ColumnNames& suffixes) {
  ColumnNames all;
  for (const std::string& one : suffixes) all.push_back(stem + one);
  return all;
}

const ColumnNames of_wrench{"Fx", "Fy", "Fz", "Mx", "My", "Mz"};

class PoseReader {
 public:
  PoseReader(const SampleTable& table, const std::string& source, const PoseFormat& format,
             const Experiment& experiment, std::size_t before)
      : table_(table),
        source_(source),
        format_(format),
        experiment_(experiment),
        before_(before),
        joints_(experiment.arm->arm.size()) {
    for (std::size_t c = 0; c < table.header.size(); ++c)
      if (!place_.try_emplace(table.header[c], c).second)
        throw Error(header(), "two columns '" + files::shown(table.header[c]) + "'", "names that differ");
    require_known();
    commands_ = counted(format.motor_side && has_any(counted("q", joints_)) ? "q" : "q_command", joints_);
    require_all(commands_, true);
    angles_ = has_any(counted("q", joints_)) && commands_.front() != "q1";
    if (angles_) require_all(counted("q", joints_), true);
    torques_ = has_any(counted("torque", joints_));
    if (torques_) require_all(counted("torque", joints_), true);
    for (const MeasuredPoint& point : experiment.arm_bench.points) look_for(point.name);
    if (place_.contains("weight") && has_any(of_wrench))
      throw Error(header(), "columns of a weight and of a wrench", "one of them");
  }

  [[nodiscard]] Reading reading(std::size_t row) const {
    Reading one{no_value, {no_value, no_value, 0, 0}};
    one.t = place_.contains("t") ? number("t", row) : static_cast<double>(before_ + row);
    if (std::isnan(one.t)) throw Error(where(row) + ", t", "an empty field", "the time of the reading");
    one.rest = coordinates(commands_, row);
    for (std::size_t j = 0; j < joints_; ++j)
      if (std::isnan(one.rest[j]))
        throw Error(where(row) + ", " + commands_[j], "an empty field", "the commanded angle of every joint");
    const std::vector<double> angles = coordinates(counted("q", joints_), row);
    for (std::size_t j = 0; j < joints_; ++j) {
      if (angles_) Channel(Channel::Name::q, j).in(one) = angles[j];
      Channel(Channel::Name::drive, j, joints_).in(one) =
          in(format_.units.moment, "torque" + std::to_string(j + 1), row);
    }
    add_points(row, one);
    add_load(row, one);
    if (place_.contains("temperature")) one.covariates.push_back(temperature(row));
    return one;
  }

  /// Where the numbers of orientations, read as x, y, z, w, are those of the arm, and as they are not.
  void require_order_of_quaternions() const {
    std::vector<double> as_read, other;
    for (std::size_t p = 0; p < quaternion_.size(); ++p) {
      if (!quaternion_[p]) continue;
      for (std::size_t row = 0; row < table_.rows.size(); ++row) {
        const std::array<double, 4> q = quaternion(p, row);
        if (std::isnan(q[0])) continue;
        const Eigen::Matrix3d told = nominal_frame(p, row);
        as_read.push_back(angle_between(told, Eigen::Quaterniond(q[0], q[1], q[2], q[3])));
        other.push_back(angle_between(told, Eigen::Quaterniond(q[3], q[0], q[1], q[2])));
      }
    }
    constexpr double far = 0.5, near = 0.2;  // rad
    if (as_read.empty() || median(as_read) < far || median(other) > near) return;
    throw Error(header(),
                "quaternions that agree with the arm where their first number is x and their last is w",
                "columns named after what they hold: _qw, _qx, _qy, _qz");
  }

 private:
  enum class Turn { none, vector, quaternion };

  [[nodiscard]] std::string header() const {
    return table_.header_line == 0 ? source_ : source_ + ":" + std::to_string(table_.header_line);
  }
  [[nodiscard]] std::string where(std::size_t row) const { return table_.place_of(row, source_); }
  [[nodiscard]] bool has_any(const ColumnNames& names) const {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& one) { return place_.contains(one); });
  }
  /// \returns whether they are there
  bool require_all(const ColumnNames& names, bool needed) const {
    if (!needed && !has_any(names)) return false;
    for (const std::string& name : names)
      if (!place_.contains(name))
        throw Error(
            header(), "no column '" + files::shown(name) + "'",
            fmt::format("columns '{}' to '{}'", files::shown(names.front()), files::shown(names.back())));
    return true;
  }

  void look_for(const std::string& point) {
    const ColumnNames xyz{"x", "y", "z"};
    const bool place = require_all(suffixed(point + "_", xyz), false),
               vector = require_all(suffixed(point + "_r", xyz), false),
               quaternion = require_all(suffixed(point + "_q", {"w", "x", "y", "z"}), false);
    if (vector && quaternion)
      throw Error(header(), "two orientations of point '" + files::shown(point) + "'", "one");
    placed_.push_back(place);
    turn_.push_back(vector ? Turn::vector : quaternion ? Turn::quaternion : Turn::none);
    quaternion_.push_back(quaternion);
  }

  void require_known() const {
    ColumnNames known{"t", "weight", "temperature"};
    const auto add = [&](const ColumnNames& more) { known.insert(known.end(), more.begin(), more.end()); };
    add(of_wrench), add(format_.ignored);
    for (const char* stem : {"q_command", "q", "torque"}) add(counted(stem, joints_));
    for (const MeasuredPoint& point : experiment_.arm_bench.points)
      add(suffixed(point.name + "_", {"x", "y", "z", "rx", "ry", "rz", "qw", "qx", "qy", "qz"}));
    for (const auto& [name, place] : place_)
      if (std::find(known.begin(), known.end(), name) == known.end())
        throw Error(
            header(), "a column '" + files::shown(name) + "'",
            fmt::format(
                "t, q_command1 to q_command{}, q1 …, torque1 …, a point's {}_x, _y, _z, _rx …, _qw …, "
                "Fx … Mz or weight, temperature; or columns.ignore = [\"{}\"]",
                joints_, experiment_.arm_bench.points.front().name, files::shown(name)));
  }

  [[nodiscard]] double number(const std::string& name, std::size_t row) const {
    const std::string& text = table_.rows[row].fields[place_.at(name)];
    const std::optional<std::string> decimal = decimal_in(text, format_.csv);
    if (!decimal) refuse_field(text, format_.csv, where(row) + ", " + files::shown(name));
    return nearest_double(*decimal);
  }

  [[nodiscard]] double temperature(std::size_t row) const {
    const double value = number("temperature", row);
    if (std::isnan(value))
      throw Error(where(row) + ", temperature", "an empty field", "the temperature of every reading");
    return value;
  }

  [[nodiscard]] double in(const Unit& unit, const std::string& name, std::size_t row) const {
    return place_.contains(name) ? number(name, row) * unit.in_si() : no_value;
  }

  [[nodiscard]] std::vector<double> coordinates(const ColumnNames& names, std::size_t row) const {
    std::vector<double> all;
    for (std::size_t j = 0; j < joints_; ++j) {
      const bool slides = experiment_.arm->arm.links[j].kind == JointKind::prismatic;
      all.push_back(in(slides ? format_.units.place : format_.units.angle, names[j], row));
    }
    return all;
  }

  [[nodiscard]] std::array<double, 4> quaternion(std::size_t point, std::size_t row) const {
    std::array<double, 4> q{};
    const ColumnNames names = suffixed(experiment_.arm_bench.points[point].name + "_q", {"w", "x", "y", "z"});
    double square = 0;
    for (std::size_t i = 0; i < 4; ++i) q[i] = number(names[i], row), square += q[i] * q[i];
    constexpr double written_to = 0.01;
    if (std::abs(square - 1) > written_to)
      throw Error(where(row) + ", " + files::shown(names.front()),
                  fmt::format("a quaternion of length {:.4g}", std::sqrt(square)), "length 1");
    return q;
  }

  [[nodiscard]] Eigen::Matrix3d nominal_frame(std::size_t point, std::size_t row) const {
    return nominal_pose(experiment_.arm->arm, experiment_.arm_bench.points[point].at,
                        coordinates(commands_, row))
        .linear();
  }

  static double angle_between(const Eigen::Matrix3d& told, const Eigen::Quaterniond& seen) {
    return rotation_vector<double>(told.transpose() * seen.normalized().toRotationMatrix()).norm();
  }

  /// From the nominal orientation at the command.
  [[nodiscard]] Vector3<double> turned(std::size_t point, std::size_t row) const {
    Eigen::Matrix3d seen;
    if (turn_[point] == Turn::quaternion) {
      const std::array<double, 4> q = quaternion(point, row);
      if (std::isnan(q[0])) return Vector3<double>::Constant(no_value);
      seen = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
    } else {
      Vector3<double> vector;
      const ColumnNames names = suffixed(experiment_.arm_bench.points[point].name + "_r", {"x", "y", "z"});
      for (std::size_t i = 0; i < 3; ++i)
        vector(static_cast<Eigen::Index>(i)) = in(format_.units.angle, names[i], row);
      if (!vector.allFinite()) return Vector3<double>::Constant(no_value);
      seen = rotation_by(vector);
    }
    return rotation_vector<double>(nominal_frame(point, row).transpose() * seen);
  }

  void add_points(std::size_t row, Reading& one) const {
    for (std::size_t p = 0; p < placed_.size(); ++p) {
      const std::string stem = experiment_.arm_bench.points[p].name + "_";
      for (std::size_t axis = 0; axis < 3; ++axis)
        Channel(Channel::Name::place, 3 * p + axis, joints_).in(one) =
            in(format_.units.place, stem + "xyz"[axis], row);
      const Vector3<double> turn =
          turn_[p] == Turn::none ? Vector3<double>(no_value, no_value, no_value) : turned(p, row);
      for (std::size_t axis = 0; axis < 3; ++axis)
        Channel(Channel::Name::turn, 3 * p + axis, joints_).in(one) = turn(static_cast<Eigen::Index>(axis));
    }
  }

  void add_load(std::size_t row, Reading& one) const {
    if (place_.contains("weight")) {
      const Vector3<double> force = in(format_.units.mass, "weight", row) * experiment_.arm->arm.gravity;
      one.wrench = {force.x(), force.y(), force.z(), 0, 0, 0};
    } else if (has_any(of_wrench)) {
      for (std::size_t i = 0; i < 6; ++i) {
        const bool there = place_.contains(of_wrench[i]);
        one.wrench.push_back(there ? in(i < 3 ? format_.units.force : format_.units.moment, of_wrench[i], row)
                                   : 0);
      }
    }
    for (const double component : one.wrench)
      if (std::isnan(component)) throw Error(where(row), "an empty load", "the load of every reading");
  }

  const SampleTable& table_;
  const std::string& source_;
  const PoseFormat& format_;
  const Experiment& experiment_;
  std::size_t before_;
  std::size_t joints_;
  std::map<std::string, std::size_t> place_;
  ColumnNames commands_;
  bool angles_ = false, torques_ = false;
  std::vector<bool> placed_, quaternion_;
  std::vector<Turn> turn_;
};

}  // namespace

std::vector<Reading> read_poses(const SampleTable& table, const std::string& source, const PoseFormat& format,
                                const Experiment& experiment, std::size_t before) {
  const PoseReader reader(table, source, format, experiment, before);
  reader.require_order_of_quaternions();
  std::vector<Reading> readings;
  for (std::size_t row = 0; row < table.rows.size(); ++row) readings.push_back(reader.reading(row));
  return readings;
}

}  // namespace plumbline::diagnose
