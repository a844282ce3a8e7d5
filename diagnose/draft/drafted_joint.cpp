#include "diagnose/draft/drafted_joint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "diagnose/draft/unit_words.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

class JointDrafter {
 public:
  JointDrafter(const RunSource& source, const DraftModel& model, const Ask& ask)
      : model_(model), ask_(ask), slides_(model.chain.slides(0)) {
    run_.source = source;
    run_.device = model.chain.device;
    words_ = source.words(model.joints);
  }

  DraftedRun result() {
    if (const auto time = column_of({Kind::time}, false)) take(draft_t, *time, "its name");
    find_place();
    find_load();
    find_command();
    require_something();
    find_unit_of_place();
    find_control();
    return std::move(run_);
  }

 private:
  std::optional<std::string> say(const std::string& what, const std::string& value, const std::string& reason,
                                 bool doubtful = false, const std::string& line = "") {
    return say_guess(run_, ask_, {what + " of " + run_.source.name(), value, reason, doubtful, line});
  }
  [[nodiscard]] const std::string& channel(std::size_t single) const {
    return single_channels(run_.device)[single].name;
  }
  [[nodiscard]] std::string title(std::size_t column) const { return run_.source.shown_title(column); }
  /// The line that a script writes to say what a column holds.
  [[nodiscard]] std::string told(Kind kind, std::size_t column, const std::string& unit) const {
    return columns_option({{run_.source.told_name(column), {.kind = kind, .unit = unit}}});
  }

  [[nodiscard]] std::optional<std::size_t> column_of(const std::vector<Kind>& kinds, bool commanded) const {
    for (const Kind kind : kinds)
      for (std::size_t c = 0; c < words_.size(); ++c)
        if (words_[c].kind == kind && words_[c].commanded == commanded) return c;
    return {};
  }
  [[nodiscard]] std::vector<Kind> places() const {
    return slides_ ? std::vector{Kind::x, Kind::y, Kind::z} : std::vector{Kind::angle};
  }
  [[nodiscard]] std::vector<Kind> loads() const {
    const std::vector forces{Kind::force, Kind::force_x, Kind::force_y, Kind::force_z, Kind::mass};
    std::vector all{Kind::torque, Kind::moment_z, Kind::moment_y, Kind::moment_x};
    if (slides_) return forces;
    all.insert(all.end(), forces.begin(), forces.end());
    return all;
  }

  void take(std::size_t single, std::size_t column, const std::string& reason) {
    const std::string& unit = words_[column].unit;
    say(channel(single), title(column) + (unit.empty() ? "" : ", in " + unit), reason);
    run_.singles[single] = DraftColumn{column, unit, words_[column].sign};
  }

  void find_place() {
    const auto column = column_of(places(), false);
    if (column) take(draft_x, *column, "its name");
  }

  /// A torque on a joint that turns may be told by a force or a weight on a lever, which no table has.
  void find_load() {
    auto column = column_of(loads(), false);
    if (!column) column = column_of(loads(), true);
    if (!column) return;
    const Kind kind = words_[*column].kind;
    const std::string own = words_[*column].unit;
    // A person may have said a torque of a weight: "50 gf mm".
    if (slides_ || !unit_in(own, quantity::torque).empty() || kind == Kind::torque ||
        kind == Kind::moment_x || kind == Kind::moment_y || kind == Kind::moment_z) {
      take(draft_Fx, *column, "its name");
      if (kind == Kind::mass && slides_) run_.singles[draft_Fx]->unit = weight_unit(own);
      return;
    }
    run_.singles[draft_Fx] =
        DraftColumn{*column, lever_unit(*column, weight_unit(own)), words_[*column].sign};
  }

  static std::string weight_unit(const std::string& unit) {
    const std::string force = unit_in(unit.empty() ? "kg" : unit, quantity::force);
    return force.empty() ? "N" : force;
  }

  /// \return the unit of torque of the column; empty where nobody says the lever
  std::string lever_unit(std::size_t column, const std::string& force) {
    const std::string line =
        told(Kind::torque, column, fmt::format("50 {} mm", force)) + ", with the lever for 50";
    const auto answer =
        say("lever of " + title(column), "not known",
            fmt::format("a torque is meant, {} is a force: on which lever, such as 50 mm?", title(column)),
            true, line);
    if (answer) {
      const std::size_t unit = answer->find_first_not_of("0123456789. ");
      const std::string length = unit == std::string::npos ? "m" : answer->substr(unit);
      return parse_unit(fmt::format("{} {} {}", answer->substr(0, unit), force, length), quantity::torque,
                        "lever of " + title(column))
          .name;
    }
    run_.question = fmt::format("torque of {}: found {}, a force without its lever, expected {}",
                                run_.source.name(), title(column), line);
    return "";
  }

  void find_command() {
    auto column = column_of(places(), true);
    if (!column && slides_) column = column_of({Kind::angle}, true);  // "command" alone
    if (!column || *column == place_column()) return;
    run_.commands.push_back({*column, words_[*column].unit, words_[*column].sign});
    say("q_command", title(*column), words_[*column].at_motor ? "the motor's side of the joint" : "its name");
  }

  [[nodiscard]] std::optional<std::size_t> place_column() const {
    return run_.singles[draft_x] ? std::optional(run_.singles[draft_x]->place) : std::nullopt;
  }

  void require_something() const {
    const bool place = run_.singles[draft_x].has_value();
    if (place && (run_.singles[draft_Fx] || !run_.commands.empty())) return;
    std::vector<std::string> titles;
    for (std::size_t c = 0; c < words_.size(); ++c) titles.push_back(title(c));
    const char* const what = slides_ ? "x" : "angle";
    throw Error(run_.source.name(),
                fmt::format("the columns {}", files::shown(fmt::format("{}", fmt::join(titles, ", ")))),
                place ? fmt::format("beside {} its {} or its command: --columns {}=COLUMN:UNIT", what,
                                    slides_ ? "force" : "torque", channel(draft_Fx))
                      : fmt::format("one of the {} of the joint: --columns {}=COLUMN:UNIT,{}=COLUMN:UNIT",
                                    slides_ ? "travel" : "angle", what, channel(draft_Fx)));
  }

  /// The unit of the place and of a command without one is that of the other.
  void find_unit_of_place() {
    DraftColumn& place = *run_.singles[draft_x];
    if (place.unit.empty() && !run_.commands.empty()) place.unit = run_.commands.front().unit;
    if (place.unit.empty()) guess_unit(place);
    for (DraftColumn& command : run_.commands)
      if (command.unit.empty()) command.unit = place.unit;
  }

  /// The unit with which the load over the place comes nearest to the stiffness.
  void guess_unit(DraftColumn& place) {
    const std::vector<double> at = finite(run_.source.numbers(place.place));
    double most = 0, load = 0;
    for (const double value : at) most = std::max(most, std::abs(value - at.front()));
    if (run_.singles[draft_Fx] && run_.question.empty())
      for (const double value : finite(run_.values(draft_Fx))) load = std::max(load, std::abs(value));
    double nearest = INFINITY, second = INFINITY;
    const std::array units = slides_ ? std::array{"m", "mm"} : std::array{"rad", "deg"};
    for (const char* const unit : units) {
      const double in_si =
          most * parse_unit(unit, *single_channels(run_.device)[draft_x].quantity, "").in_si();
      const double off = std::abs(std::log(load / in_si / model_.chain.joint_stiffness.front()));
      if (off < nearest) {
        second = nearest, nearest = off, place.unit = unit;
      } else {
        second = std::min(second, off);
      }
    }
    constexpr double clearly = 2;  // natural logarithms
    constexpr double once_around = 6.4;
    if (!(load > 0)) {
      place.unit = slides_ ? "mm" : most > once_around ? "deg" : "rad";
      nearest = 0, second = most > once_around ? clearly + 1 : 0;
    }
    say(fmt::format("unit of {}", channel(draft_x)), place.unit,
        load > 0 ? fmt::format("the load over it is then {:.2g} times the stiffness of the model",
                               std::exp(nearest))
                 : "no unit stands there",
        second - nearest < clearly, told(slides_ ? Kind::x : Kind::angle, place.place, place.unit));
  }

  void find_control() {
    if (!run_.commands.empty()) {
      run_.imposes_force = true;
      say("control", "command",
          fmt::format("{} is where the spring pulls to", title(run_.commands.front().place)));
      return;
    }
    const EndKind& end = run_.end();
    const std::string place(end.by_place), load(end.by_load);
    const auto& s = run_.singles;
    const EvenSteps steps = even_steps(roughness(run_.source.numbers(s[draft_x]->place)),
                                       roughness(run_.source.numbers(s[draft_Fx]->place)),
                                       slides_ ? "places" : "angles", slides_ ? "forces" : "torques");
    run_.imposes_force = steps.load;
    const auto answer = say("control", steps.load ? load : place, steps.reason, !steps.sure,
                            line_of_control(steps.load ? place : load));
    if (answer) run_.imposes_force = *answer == load;
    run_.by_weights = run_.imposes_force && words_[s[draft_Fx]->place].kind == Kind::mass;
  }

  const DraftModel& model_;
  const Ask& ask_;
  bool slides_;
  DraftedRun run_;
  std::vector<ColumnWords> words_;
};

}  // namespace

DraftedRun drafted_joint_run(const RunSource& source, const DraftModel& model, const Ask& ask) {
  return JointDrafter(source, model, ask).result();
}

}  // namespace plumbline::diagnose
