#include "diagnose/draft/drafted_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <plumbline/base/error.hpp>

#include "diagnose/draft/angle_maps.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/drafted_rest.hpp"
#include "diagnose/draft/joint_columns.hpp"
#include "diagnose/draft/rest_shape.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "diagnose/draft/unit_words.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Values = std::vector<double>;

class Drafter {
 public:
  Drafter(const RunSource& source, const DraftModel& model, const Ask& ask)
      : model_(model), ask_(ask), joints_(model.chain.link_length.size()) {
    run_.source = source;
    reach_ = std::accumulate(model.chain.link_length.begin(), model.chain.link_length.end(), 0.0);
  }

  DraftedRun result() {
    read_words();
    find_singles();
    find_angles();
    find_covariates();
    require_something();
    find_length_unit();
    find_angle_unit();
    find_actuators();
    if (imposes_commands()) {
      impose_commands();
      map_angles();
    } else {
      map_angles();
      find_control();
      take_commands();
      find_rest(run_, model_, ask_, columns_of_commands());
    }
    return std::move(run_);
  }

 private:
  /// \return what is to be taken instead
  /// \param line  that says it instead, in a script
  std::optional<std::string> say(const std::string& what, const std::string& value, const std::string& reason,
                                 bool doubtful = false, const std::string& line = "") {
    return say_guess(run_, ask_, {what + " of " + run_.source.name(), value, reason, doubtful, line});
  }
  /// The line that a script writes to say what a column holds.
  [[nodiscard]] std::string told(Kind kind, std::size_t column, const std::string& unit, int sign = 1) const {
    return columns_option({{run_.source.told_name(column), {.kind = kind, .unit = unit, .sign = sign}}});
  }

  [[nodiscard]] std::string title(std::size_t column) const { return run_.source.shown_title(column); }

  void read_words() {
    words_ = run_.source.words(model_.joints);
    if (!run_.source.parts.front().table.names.empty() || !run_.source.told.empty()) return;
    const std::size_t columns = words_.size();
    const std::vector<ColumnWords> standard = words_of_standard(columns, joints_);
    if (standard.empty()) return;
    words_ = standard;
    say("columns", "t, x, y, Fx, Fy" + std::string(columns > draft_singles ? " and the joint angles" : ""),
        fmt::format("there are {} and no words above them", columns), true,
        "--columns \"t=1,x=2,y=3,Fx=4,Fy=5\"");
  }

  [[nodiscard]] std::optional<std::size_t> column_of(Kind kind, bool commanded) const {
    for (std::size_t c = 0; c < words_.size(); ++c)
      if (words_[c].kind == kind && words_[c].commanded == commanded) return c;
    return {};
  }
  [[nodiscard]] bool has(Kind kind) const {
    return column_of(kind, false).has_value() || column_of(kind, true).has_value();
  }

  static Kind kind_of(std::size_t single) {
    static constexpr std::array kinds{Kind::time, Kind::x, Kind::y, Kind::force_x, Kind::force_y};
    return kinds[single];
  }
  static const std::string& channel(std::size_t c) { return single_channels(Device::chain)[c].name; }

  void take(std::size_t single, Kind kind, const std::string& reason, bool doubtful = false) {
    std::optional<std::size_t> column = column_of(kind, false);
    if (!column) column = column_of(kind, true);
    if (!column) return;
    const std::string said = words_[*column].unit, name = title(*column);
    const auto answer = say(channel(single), name + (said.empty() ? "" : ", in " + said), reason, doubtful,
                            told(kind_of(single), *column, said));
    if (answer) {
      for (std::size_t c = 0; c < words_.size(); ++c)
        if (run_.source.title(c) == *answer) column = c;
    }
    run_.singles[single] = DraftColumn{*column, words_[*column].unit, words_[*column].sign};
    kinds_[single] = kind;
  }

  void find_singles() {
    const std::string by_word = "its name";
    take(draft_t, Kind::time, by_word);
    const bool upright = !has(Kind::y) && has(Kind::z),
               force_upright = !has(Kind::force_y) && has(Kind::force_z);
    take(draft_x, Kind::x, by_word);
    take(draft_y, upright ? Kind::z : Kind::y, upright ? "z is up, and there is no y" : by_word, upright);
    take(draft_Fx, has(Kind::force_x) ? Kind::force_x : Kind::force,
         has(Kind::force_x) ? by_word : "the only force: taken for the one along x", !has(Kind::force_x));
    take(draft_Fy, force_upright ? Kind::force_z : Kind::force_y, force_upright ? "z is up" : by_word,
         force_upright);
    take_weight();
  }

  /// A mass that hangs at the end point.
  void take_weight() {
    const auto mass = column_of(Kind::mass, false);
    if (!mass || run_.singles[draft_Fx] || run_.singles[draft_Fy]) return;
    const std::string unit = unit_in(words_[*mass].unit.empty() ? "kg" : words_[*mass].unit, quantity::force);
    say("Fy", fmt::format("{}, in {}", title(*mass), unit), "a weight, taken to pull down at the end point",
        true, told(Kind::force_y, *mass, unit, -1));
    run_.singles[draft_Fy] = DraftColumn{*mass, unit, -1};
    run_.by_weights = true;
    kinds_[draft_Fy] = Kind::mass;
  }

  [[nodiscard]] std::vector<std::size_t> angle_columns(bool commanded) const {
    return joint_columns(words_, Kind::angle, commanded, joints_);
  }

  void find_angles() {
    std::vector<std::string> names;
    for (const std::size_t c : angle_columns(false)) {
      run_.angles.push_back({c, words_[c].unit, words_[c].sign});
      names.push_back(title(c));
    }
    if (!names.empty()) say("q", fmt::format("{}", fmt::join(names, ", ")), "one for each joint");
  }

  /// Temperature and humidity, for expressions of one's own.
  void find_covariates() {
    for (std::size_t c = 0; c < words_.size(); ++c) {
      if (words_[c].kind != Kind::temperature && words_[c].kind != Kind::humidity) continue;
      const std::string name = words_[c].kind == Kind::temperature ? "temperature" : "humidity";
      if (finite(run_.source.numbers(c)).empty()) continue;
      if (!run_.covariates.emplace(name, DraftColumn{c, ""}).second) continue;
      say("covariate " + name, title(c), "its name");
    }
  }

  /// Tensions and pressures. Of which of them are loads along the chain, all runs together decide.
  void find_actuators() {
    for (const bool commanded : {false, true})
      for (std::size_t c = 0; c < words_.size(); ++c)
        if (is_actuation(words_[c].kind) && words_[c].commanded == commanded) add_actuator(c);
    const bool forced = run_.singles[draft_Fx] || run_.singles[draft_Fy] || has(Kind::torque),
               put = column_of(Kind::x, true) || column_of(Kind::y, true) || !angle_columns(true).empty();
    run_.moved_by_actuators = !run_.actuators.empty() && !forced && !put;
  }

  void add_actuator(std::size_t c) {
    if (finite(run_.source.numbers(c)).empty()) return;
    const auto taken = [&](const std::string& name) {
      return std::any_of(run_.actuators.begin(), run_.actuators.end(),
                         [&](const DraftedActuator& one) { return one.name == name; });
    };
    std::string name = words_[c].variable;
    if (words_[c].commanded && taken(name)) {
      say(title(c), "left out", "of a load along the chain what was reached counts");
      return;
    }
    for (int number = 2; taken(name); ++number) name = fmt::format("{}_{}", words_[c].variable, number);
    const char* const what = words_[c].kind == Kind::tension ? "tension" : "pressure";
    const std::string& unit = words_[c].unit;
    say(what, title(c) + (unit.empty() ? "" : ", in " + unit), "its name");
    const DraftColumn column{c, unit.empty() ? asked_unit(c, what) : unit};
    run_.actuators.push_back({words_[c].kind, name, column});
  }

  /// SI, unless a person says another; nothing in the numbers of a tension or a pressure tells it.
  std::string asked_unit(std::size_t c, const std::string& what) {
    const Quantity& quantity = *quantity_of(words_[c].kind);
    const auto answer = say("unit of " + what, quantity.si, fmt::format("no unit stands at {}", title(c)),
                            true, told(words_[c].kind, c, quantity.si));
    return answer ? parse_unit(*answer, quantity, fmt::format("unit of {}", title(c))).name : "";
  }

  void require_something() const {
    const auto& s = run_.singles;
    if (s[draft_x] || s[draft_y] || s[draft_Fx] || s[draft_Fy] || !run_.angles.empty()) return;
    std::vector<std::string> titles;
    for (std::size_t c = 0; c < words_.size(); ++c) titles.push_back(title(c));
    throw Error(run_.source.name(),
                fmt::format("the columns {}", files::shown(fmt::format("{}", fmt::join(titles, ", ")))),
                "a name that says x, y, Fx, Fy or q1 of some of them");
  }

  /// The end point reaches no farther than the chain: metres, or what makes it so.
  void find_length_unit() {
    auto& x = run_.singles[draft_x];
    auto& y = run_.singles[draft_y];
    for (auto* one : {&x, &y})
      if (*one && (*one)->unit.empty())
        if (auto* other = one == &x ? &y : &x; *other) (*one)->unit = (*other)->unit;
    if (!x && !y) return;
    const Values xs = x ? raw(*x) : Values(), ys = y ? raw(*y) : Values();
    constexpr double slack = 1.02, least = 0.03;
    const std::array<double, 2> own{0, 0};
    const bool elsewhere = std::hypot(model_.base[0], model_.base[1]) > 0;
    const bool said = !(x ? x : y)->unit.empty();
    const std::vector<std::string> units = said ? std::vector<std::string>{(x ? x : y)->unit}
                                                : std::vector<std::string>{"m", "mm", "cm", "in", "um"};
    for (const bool from_base : {true, false}) {
      if (!from_base && !elsewhere) break;
      for (const std::string& unit : units) {
        const double factor = parse_unit(unit, quantity::length, "").in_si();
        const double far = farthest(xs, ys, from_base ? own : model_.base, factor);
        if (far > slack * reach_ || far < least * reach_) continue;
        set_place(x, unit, from_base ? 0 : model_.base[0] / factor);
        set_place(y, unit, from_base ? 0 : model_.base[1] / factor);
        if (!said)
          say("unit of x, y", unit,
              fmt::format("the farthest reading is then {:.4g} m from the base, the chain {:.4g} m long", far,
                          reach_));
        if (!from_base)
          say("zero of x, y", fmt::format("{:.6g}, {:.6g} m", model_.base[0], model_.base[1]),
              "counted from where the model has its origin, as its joint 1 is there");
        return;
      }
    }
    say("unit of x, y", said ? units.front() : "m", "no unit puts the readings within the reach of the chain",
        true, told(x ? Kind::x : Kind::y, (x ? x : y)->place, said ? units.front() : "m"));
  }
  static void set_place(std::optional<DraftColumn>& column, const std::string& unit, double zero) {
    if (!column) return;
    column->unit = unit;
    column->zero = zero;
  }

  /// The unit of reached angles, or of commanded ones.
  [[nodiscard]] std::string angle_unit() const {
    for (const bool commanded : {false, true})
      for (const std::size_t c : angle_columns(commanded))
        if (!words_[c].unit.empty()) return words_[c].unit;
    return unit_of_angles_;
  }

  void find_angle_unit() {
    std::vector<std::size_t> columns = angle_columns(false);
    const std::vector<std::size_t> commands = angle_columns(true);
    columns.insert(columns.end(), commands.begin(), commands.end());
    if (columns.empty()) return;
    if (angle_unit().empty()) {
      double most = 0;
      for (const std::size_t c : columns)
        for (const double value : finite(run_.source.numbers(c))) most = std::max(most, std::abs(value));
      constexpr double once_around = 6.4;
      if (most > once_around) {
        unit_of_angles_ = "deg";
        say("unit of q", "deg", fmt::format("angles up to {:.4g} are more than once around in rad", most));
      }
    }
    for (DraftColumn& column : run_.angles)
      if (column.unit.empty()) column.unit = angle_unit();
  }

  /// A simulator's joints may turn the other way than the chain's, and stand elsewhere at 0.
  void map_angles() {
    if (model_.angles.empty() || (run_.angles.empty() && run_.commands.empty())) return;
    if (!reads_joints_of_model(run_, model_)) return;
    take_angle_maps(model_, run_.angles);
    take_angle_maps(model_, run_.commands);
    say("signs and zeros of q", "those of the model's joints",
        "the chain counts its angles from a straight line, the model's joints count from where it draws "
        "them");
  }

  [[nodiscard]] Values raw(const DraftColumn& column) const { return run_.source.numbers(column.place); }

  /// Commands to every joint are a motion, or a pose a line; commands that stand still beside a force are a
  /// rest.
  [[nodiscard]] bool imposes_commands() const {
    const auto& s = run_.singles;
    const bool read = !run_.angles.empty() || s[draft_x] || s[draft_y],
               pressed = (s[draft_Fx] || s[draft_Fy]) && (s[draft_x] || s[draft_y]);
    return read && !angle_columns(true).empty() && (!pressed || (s[draft_t] && !run_.angles.empty()));
  }

  [[nodiscard]] std::vector<DraftColumn> columns_of_commands() const {
    std::vector<DraftColumn> all;
    for (const std::size_t c : angle_columns(true))
      all.push_back({c, words_[c].unit.empty() ? angle_unit() : words_[c].unit, words_[c].sign});
    return all;
  }

  void impose_commands() {
    run_.commands = columns_of_commands();
    std::vector<std::string> names;
    for (const DraftColumn& column : run_.commands) names.push_back(title(column.place));
    run_.imposes_force = true;
    say("control", "command",
        fmt::format("{}: a command to every joint, in the order of the lines", fmt::join(names, ", ")));
  }

  /// What is imposed goes in even steps; what is measured scatters.
  void find_control() {
    if (run_.moved_by_actuators) return impose_actuators();
    const auto& s = run_.singles;
    const bool places = s[draft_x] || s[draft_y], forces = s[draft_Fx] || s[draft_Fy];
    if (!places || !forces) {
      run_.imposes_force = !places;
      if (places)
        return impose_place("there is no force: the end point is put, and only joint angles are read");
      return impose_nothing(forces);
    }
    const auto rough = [&](std::size_t a, std::size_t b) {
      double most = 0;
      for (const std::size_t c : {a, b})
        if (s[c]) most = std::max(most, roughness(raw(*s[c])));
      return most;
    };
    EvenSteps steps = even_steps(rough(draft_x, draft_y), rough(draft_Fx, draft_Fy), "places", "forces");
    const bool commanded_force = column_of(kinds_[draft_Fx], true).has_value(),
               commanded_place = column_of(kinds_[draft_x], true).has_value();
    if (commanded_force != commanded_place) steps = {commanded_force, true, "a column has the commands"};
    if (run_.by_weights) steps = {true, true, "weights are put"};
    run_.imposes_force = steps.load;
    const auto& [load, sure, reason] = steps;
    const auto answer = say("control", run_.imposes_force ? "force" : "displacement", reason, !sure,
                            line_of_control(load ? "displacement" : "force"));
    if (answer) run_.imposes_force = *answer == "force";
    run_.imposes_force ? impose_force() : impose_place("");
  }

  /// A chain that nothing presses on: an arm that is held by its servos.
  void impose_nothing(bool forces) {
    run_.imposes_force = true;
    if (!forces) say("Fx, Fy", "0", "there is no force among the columns: nothing but weights acts");
    impose_force();
  }
  /// Beside a load along the chain no force on the end point needs a column.
  void impose_actuators() {
    run_.imposes_force = true;
    std::vector<std::string> names;
    for (const DraftedActuator& one : run_.actuators) names.push_back(title(one.column.place));
    say("control", "force",
        fmt::format("no force, torque or command stands beside {}", fmt::join(names, ", ")));
  }
  void impose_force() {
    for (const std::size_t c : {draft_Fx, draft_Fy})
      if (!run_.singles[c]) run_.singles[c] = DraftColumn{0, "", 1, 0, 0.0};
  }
  void impose_place(const std::string& reason) {
    if (!reason.empty()) say("control", "displacement", reason);
    const std::array<double, 2> rest = end_point(model_.chain, model_.chain.rest);
    for (const std::size_t c : {draft_x, draft_y})
      if (!run_.singles[c]) {
        const double value = rest[c == draft_x ? 0 : 1];
        run_.singles[c] = DraftColumn{0, "", 1, 0, value};
        say(channel(c), fmt::format("{:.6g} m throughout", value),
            "no column has it: held where the model rests", true,
            fmt::format("{} = {{ constant = {:.6g} }} in its [[run]]", channel(c), value));
      }
  }

  /// Of what is imposed the command counts, of what is measured what was reached.
  void take_commands() {
    for (const std::size_t c : run_.imposes_force ? std::array<std::size_t, 2>{draft_Fx, draft_Fy}
                                                  : std::array<std::size_t, 2>{draft_x, draft_y}) {
      const auto column = kinds_[c] == Kind::none ? std::nullopt : column_of(kinds_[c], true);
      if (!column || !run_.singles[c] || run_.singles[c]->constant) continue;
      run_.singles[c]->place = *column;
      say(channel(c), title(*column), "of what is imposed the command counts");
    }
  }

  const DraftModel& model_;
  const Ask& ask_;
  std::size_t joints_;
  double reach_ = 0;
  DraftedRun run_;
  std::vector<ColumnWords> words_;
  std::array<Kind, draft_singles> kinds_{};
  std::string unit_of_angles_;
};

}  // namespace

DraftedRun drafted_run(const RunSource& source, const DraftModel& model, const Ask& ask) {
  return Drafter(source, model, ask).result();
}

}  // namespace plumbline::diagnose
