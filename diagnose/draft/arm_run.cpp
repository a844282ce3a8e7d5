#include "diagnose/draft/arm_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/roll_pitch_yaw.hpp"
#include "diagnose/bench/sample_format.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/joint_columns.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Values = std::vector<double>;

class ArmTableReader {
 public:
  ArmTableReader(const RunSource& source, const DraftModel& model)
      : source_(source), arm_(*model.arm), words_(source.words(model.arm->joint)) {
    run_.id = source.id;
  }

  ArmRun result() {
    run_.sensors = sensor_columns(source_);
    for (const SensorColumns& sensor : run_.sensors)
      for (const std::size_t column : sensor.columns) words_[column].kind = Kind::none;
    if (const auto time = column_of(Kind::time)) put("t", *time, quantity::time, "s");
    find_angles();
    put_sensors();
    find_places();
    find_turns();
    find_loads();
    put_joints("torque", joint_columns(words_, Kind::torque, false, arm_.arm.size()), quantity::torque, "",
               Channel::Name::drive);
    if (const auto warm = column_of(Kind::temperature)) put("temperature", *warm, quantity::angle, "");
    return std::move(run_);
  }

 private:
  void say(const std::string& what, const std::string& value, const std::string& reason) {
    run_.guesses.push_back({what + " of " + source_.name(), value, reason});
  }
  [[nodiscard]] std::string title(std::size_t column) const { return source_.shown_title(column); }

  [[nodiscard]] std::optional<std::size_t> column_of(Kind kind) const {
    for (std::size_t c = 0; c < words_.size(); ++c)
      if (words_[c].kind == kind && !words_[c].commanded) return c;
    return {};
  }

  /// In SI, by the unit of the title, else by another.
  [[nodiscard]] Values values(std::size_t column, const Quantity& quantity,
                              const std::string& otherwise) const {
    const std::string& unit = words_[column].unit.empty() ? otherwise : words_[column].unit;
    const double in_si = unit.empty() ? 1 : parse_unit(unit, quantity, title(column)).in_si();
    Values all = source_.numbers(column);
    for (double& value : all) value *= words_[column].sign * in_si;
    return all;
  }

  void put(const std::string& name, std::size_t column, const Quantity& quantity, const std::string& unit,
           std::optional<Channel::Name> reads = {}) {
    run_.columns.push_back({name, values(column, quantity, unit), reads});
    run_.used.push_back(column);
    say(name, title(column) + (words_[column].unit.empty() ? "" : ", in " + words_[column].unit), "its name");
  }

  void put_joints(const std::string& stem, const std::vector<std::size_t>& columns, const Quantity& quantity,
                  const std::string& unit, std::optional<Channel::Name> reads = {}) {
    for (std::size_t j = 0; j < columns.size(); ++j)
      put(stem + std::to_string(j + 1), columns[j], slides(j) ? quantity::length : quantity,
          slides(j) ? "" : unit, reads);
  }

  [[nodiscard]] bool slides(std::size_t joint) const {
    return arm_.arm.links[joint].kind == JointKind::prismatic;
  }

  /// Where nothing is commanded, the angles that were reached are where the arm was told to be.
  void find_angles() {
    std::vector<std::size_t> commands = joint_columns(words_, Kind::angle, true, arm_.arm.size()),
                             reached = joint_columns(words_, Kind::angle, false, arm_.arm.size());
    if (commands.empty() && reached.empty()) refuse();
    const std::string unit = unit_of_angles(commands, reached);
    if (commands.empty()) {
      std::swap(commands, reached);
      say("q_command", "the joint angles that stand there", "no others are commanded");
    }
    put_joints("q_command", commands, quantity::angle, unit);
    put_joints("q", reached, quantity::angle, unit, Channel::Name::q);
    const std::size_t first = run_.columns.size() - commands.size() - reached.size();
    run_.commands.resize(source_.readings());
    for (std::size_t j = 0; j < commands.size(); ++j)
      for (std::size_t i = 0; i < run_.commands.size(); ++i)
        run_.commands[i].push_back(run_.columns[first + j].values[i]);
  }

  [[noreturn]] void refuse() const {
    std::vector<std::string> titles;
    for (std::size_t c = 0; c < words_.size(); ++c) titles.push_back(title(c));
    throw Error(
        source_.name(),
        fmt::format("the columns {}", files::shown(fmt::format("{}", fmt::join(titles, ", ")))),
        fmt::format(
            "a commanded or a reached angle of each of the {} joints {}: --columns q_command1=COLUMN:UNIT,…",
            arm_.joint.size(), fmt::join(arm_.joint, ", ")));
  }

  std::string unit_of_angles(const std::vector<std::size_t>& commands,
                             const std::vector<std::size_t>& reached) {
    double most = 0;
    for (const auto* columns : {&commands, &reached})
      for (std::size_t j = 0; j < columns->size(); ++j) {
        if (slides(j)) continue;
        if (!words_[(*columns)[j]].unit.empty()) return words_[(*columns)[j]].unit;
        for (const double value : finite(source_.numbers((*columns)[j])))
          most = std::max(most, std::abs(value));
      }
    constexpr double once_around = 6.4;
    if (most <= once_around) return "";
    say("unit of q", "deg", fmt::format("angles up to {:.4g} are more than once around in rad", most));
    return "deg";
  }

  /// Lengths that are longer than the arm can be are in mm, angles of more than a quarter turn in degrees.
  void put_sensors() {
    double reach = 0;
    for (std::size_t j = 0; j < arm_.arm.size(); ++j) reach += arm_.arm.far_end(j).translation().norm();
    constexpr double far = 20, quarter = 1.571;  // times the reach; rad
    for (const SensorColumns& sensor : run_.sensors)
      for (std::size_t i = 0; i < sensor.columns.size(); ++i) {
        const std::size_t column = sensor.columns[i];
        double most = 0;
        for (const double value : finite(source_.numbers(column))) most = std::max(most, std::abs(value));
        const Quantity& of = quantity_of(kind_of(sensor.kind->reads).sensor);
        const bool small = &of == &quantity::length && most > far * reach,
                   turned = &of == &quantity::angle && most > quarter;
        put(sensor.name + std::string(sensor.kind->column[i]), column, of,
            small    ? "mm"
            : turned ? "deg"
                     : "",
            sensor.kind->reads);
      }
  }

  /// A camera sees two coordinates.
  void find_places() {
    const std::array columns{column_of(Kind::x), column_of(Kind::y), column_of(Kind::z)};
    if (std::count(columns.begin(), columns.end(), std::nullopt) > 1) return;
    const Eigen::Vector3d unread = Eigen::Vector3d::Constant(NAN);
    run_.places.assign(source_.readings(), unread);
    std::vector<std::string> names;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!columns[axis]) continue;
      const Values all = source_.numbers(*columns[axis]);
      for (std::size_t i = 0; i < all.size(); ++i)
        run_.places[i](static_cast<Eigen::Index>(axis)) = words_[*columns[axis]].sign * all[i];
      if (run_.unit_of_place.empty()) run_.unit_of_place = words_[*columns[axis]].unit;
      names.push_back(title(*columns[axis]));
      run_.used.push_back(*columns[axis]);
    }
    say("place of the tip", fmt::format("{}", fmt::join(names, ", ")), "their names");
  }

  /// Columns of a rotation by their axes, or empty.
  [[nodiscard]] std::vector<std::size_t> rotations(const std::string& axes) const {
    std::vector<std::size_t> all;
    for (const char axis : axes)
      for (std::size_t c = 0; c < words_.size(); ++c)
        if (words_[c].kind == Kind::rotation && words_[c].axis == axis && !words_[c].commanded) {
          all.push_back(c);
          break;
        }
    return all.size() == axes.size() ? all : std::vector<std::size_t>();
  }

  void find_turns() {
    const std::vector<std::size_t> quaternion = rotations("WXYZ"), angles = rotations("rpy");
    if (!quaternion.empty()) {
      std::vector<Values> q;
      for (const std::size_t c : quaternion) q.push_back(source_.numbers(c));
      for (std::size_t i = 0; i < source_.readings(); ++i)
        run_.turns.emplace_back(q[0][i], q[1][i], q[2][i], q[3][i]);
      use(quaternion, "a quaternion");
    } else if (!angles.empty()) {
      std::vector<Values> q;
      double most = 0;
      for (const std::size_t c : angles)
        for (const double value : finite(source_.numbers(c))) most = std::max(most, std::abs(value));
      constexpr double once_around = 6.4;
      for (const std::size_t c : angles)
        q.push_back(values(c, quantity::angle, most > once_around ? "deg" : ""));
      for (std::size_t i = 0; i < source_.readings(); ++i)
        run_.turns.emplace_back(from_roll_pitch_yaw({q[0][i], q[1][i], q[2][i]}));
      use(angles, "roll, pitch and yaw about fixed axes");
    }
  }
  void use(const std::vector<std::size_t>& columns, const std::string& reason) {
    std::vector<std::string> names;
    for (const std::size_t c : columns) names.push_back(title(c)), run_.used.push_back(c);
    say("orientation of the tip", fmt::format("{}", fmt::join(names, ", ")), reason);
  }

  void find_loads() {
    static const std::array forces{Kind::force_x, Kind::force_y, Kind::force_z},
        moments{Kind::moment_x, Kind::moment_y, Kind::moment_z};
    static const std::array names{"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
    if (const auto mass = column_of(Kind::mass)) return put("weight", *mass, quantity::mass, "kg");
    for (std::size_t i = 0; i < names.size(); ++i)
      if (const auto column = column_of(i < 3 ? forces[i] : moments[i - 3]))
        put(names[i], *column, i < 3 ? quantity::force : quantity::torque, "");
  }

  const RunSource& source_;
  const NominalArm& arm_;
  std::vector<ColumnWords> words_;
  ArmRun run_;
};

}  // namespace

ArmRun arm_run(const RunSource& source, const DraftModel& model) {
  return ArmTableReader(source, model).result();
}

}  // namespace plumbline::diagnose
