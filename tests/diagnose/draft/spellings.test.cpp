#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/draft/draft.hpp"
#include "tests/property.hpp"

// One table (docs/experiment-format.md: two links with dry friction), written as laboratories write: the
// readings that come out are those that were taken, without a word by a person.
namespace plumbline::diagnose {
namespace {

struct Line {
  double t, x, y, Fx, Fy;
};

const std::vector<Line>& pressed() {
  static const std::vector<Line> lines{
      {0, .4518, .0209, -0.00, .01},  {1, .4458, .0209, -1.69, .16},  {2, .4398, .0209, -2.40, .22},
      {3, .4338, .0209, -3.04, .26},  {4, .4278, .0209, -3.64, .32},  {5, .4218, .0209, -4.16, .40},
      {6, .4158, .0209, -4.60, .47},  {7, .4098, .0209, -5.01, .57},  {8, .4038, .0209, -5.39, .56},
      {9, .4098, .0209, -3.83, .28},  {10, .4158, .0209, -3.39, .26}, {11, .4218, .0209, -2.88, .14},
      {12, .4278, .0209, -2.32, .12}, {13, .4338, .0209, -1.72, .05}, {14, .4398, .0209, -1.00, .01},
      {15, .4458, .0209, -0.17, .01}};
  return lines;
}

using Fields = std::function<std::vector<std::string>(const Line&)>;

std::string plain(double value) {
  return fmt::format("{:.6g}", value);
}

/// The fields of a reading, its numbers times a factor each.
Fields scaled(double place, double force) {
  return [=](const Line& l) {
    return std::vector{plain(l.t), plain(place * l.x), plain(place * l.y), plain(force * l.Fx),
                       plain(force * l.Fy)};
  };
}

/// With another clock.
Fields clocked(const std::function<std::string(int)>& clock) {
  return [=](const Line& l) {
    return std::vector{clock(static_cast<int>(l.t)), plain(1000 * l.x), plain(1000 * l.y), plain(l.Fx),
                       plain(l.Fy)};
  };
}

std::string table(const std::vector<std::string>& head, const Fields& fields,
                  const std::string& between = ",", char decimal = '.', const std::string& before = "",
                  const std::string& after = "") {
  std::string text = before;
  if (!head.empty()) text += fmt::format("{}\n", fmt::join(head, between));
  for (const Line& line : pressed()) {
    std::string row = fmt::format("{}\n", fmt::join(fields(line), between));
    if (decimal != '.') std::replace(row.begin(), row.end(), '.', decimal);
    text += row;
  }
  return text + after;
}

std::string in_windows(std::string text) {
  for (std::size_t at; (at = text.find("\u00b0")) != std::string::npos;) text.replace(at, 2, "\xb0");
  return text;
}

std::string in_utf16(const std::string& text) {  // of letters of ASCII alone
  std::string bytes = "\xFF\xFE";
  for (const char c : text) bytes += c, bytes += '\0';
  return bytes;
}

/// Every field in quotes.
std::string with_quotes(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == ',' ? "\",\"" : c == '\n' ? "\"\n\"" : std::string(1, c);
  result.pop_back();
  return result;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

/// The header, and the rows from the last to the first.
std::string in_reverse(const std::string& text) {
  std::istringstream in(text);
  std::string header, rows;
  std::getline(in, header);
  for (std::string line; std::getline(in, line);) rows = line + "\n" + rows;
  return header + "\n" + rows;
}

std::string in_json(const std::vector<std::string>& names, const Fields& fields) {
  std::string text;
  for (const Line& line : pressed()) {
    const std::vector<std::string> values = fields(line);
    std::vector<std::string> parts;
    for (std::size_t c = 0; c < names.size(); ++c)
      parts.push_back(fmt::format("\"{}\": {}", names[c], values[c]));
    text += fmt::format("{{{}}}\n", fmt::join(parts, ", "));
  }
  return text;
}

struct Spelling {
  const char* name;
  std::string bytes;
};

std::vector<Spelling> spellings() {
  const std::vector<std::string> names{"t", "x", "y", "Fx", "Fy"}, mm{"t", "x_mm", "y_mm", "Fx", "Fy"};
  constexpr double inch = 0.0254, pound = 4.4482216152605, gram = 0.00980665, kilo = 9.80665;
  const Fields si = scaled(1, 1), in_mm = scaled(1000, 1);
  const auto with = [](const Fields& fields, const std::vector<std::string>& more) {
    return [=](const Line& line) {
      std::vector<std::string> all = fields(line);
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
  };
  return {
      {"plain", table(names, si)},
      {"semicolon, decimal comma", table({"Zeit", "x [mm]", "y [mm]", "Fx [N]", "Fy [N]"}, in_mm, ";", ',')},
      {"cm", table({"t", "x (cm)", "y (cm)", "Fx (N)", "Fy (N)"}, scaled(100, 1))},
      {"mm without a unit", table(names, in_mm)},
      {"inch and pound",
       table({"t", "x (in)", "y (in)", "Fx (lbf)", "Fy (lbf)"}, scaled(1 / inch, 1 / pound))},
      {"grams of force", table({"t", "x_mm", "y_mm", "Fx_g", "Fy_g"}, scaled(1000, 1 / gram))},
      {"grams without a unit", table(names, scaled(1, 1 / gram))},
      {"kgf", table({"time (s)", "X (mm)", "Y (mm)", "FX (kgf)", "FY (kgf)"}, scaled(1000, 1 / kilo))},
      {"mN", table({"t", "x_mm", "y_mm", "Fx_mN", "Fy_mN"}, scaled(1000, 1000))},
      {"two header lines", table({}, in_mm, ",", '.', "time,x,y,Fx,Fy\ns,mm,mm,N,N\n")},
      {"Windows-1252",
       in_windows(table({"Zeit", "x [mm]", "y [mm]", "Kraft x [N]", "Kraft y [N]", "Temp [\u00b0C]"},
                        with(in_mm, {"21.5"}), ";", ','))},
      {"UTF-16", in_utf16(table({"t", "x (mm)", "y (mm)", "Fx", "Fy"}, in_mm, "\t"))},
      {"byte order mark", "\xEF\xBB\xBF" + table({"t", "x (mm)", "y (mm)", "Fx", "Fy"}, in_mm)},
      {"ISO stamps", table({"timestamp", "x_mm", "y_mm", "Fx", "Fy"},
                           clocked([](int t) { return fmt::format("2026-11-03T14:02:{:02}.250Z", t); }))},
      {"hh:mm:ss", table({"time", "x_mm", "y_mm", "Fx", "Fy"},
                         clocked([](int t) { return fmt::format("14:02:{:02}", t); }))},
      {"epoch", table({"stamp", "x_mm", "y_mm", "Fx", "Fy"},
                      clocked([](int t) { return fmt::format("{}.25", 1762178531 + t); }))},
      {"missing values", replaced(replaced(table(names, si), ",0.47\n", ",NaN\n"), "-3.39", "-")},
      {"x and z", table({"t", "x", "z", "Fx", "Fz"}, si)},
      {"Japanese", table({"時間", "位移X(mm)", "位移Y(mm)", "力X(N)", "力Y(N)"}, in_mm)},
      {"French",
       table({"Temps (s)", "Déplacement X (mm)", "Déplacement Y (mm)", "Effort X (N)", "Effort Y (N)"}, in_mm,
             ";", ',')},
      {"German",
       table({"Zeit (s)", "Weg X (mm)", "Weg Y (mm)", "Kraft X (N)", "Kraft Y (N)"}, in_mm, ";", ',')},
      {"Spanish",
       table({"Tiempo (s)", "Desplazamiento X (mm)", "Desplazamiento Y (mm)", "Fuerza X (N)", "Fuerza Y (N)"},
             in_mm, ";", ',')},
      {"Chinese", table({"时间", "位移X (mm)", "位移Y (mm)", "力X (N)", "力Y (N)"}, in_mm)},
      {"empty columns", table({"t", "x", "y", "Fx", "Fy", "", ""}, with(si, {"", ""}))},
      {"an empty last column with a name", table({"t", "x", "y", "Fx", "Fy", "Remarks"}, si)},
      {"a preamble",
       table(mm, in_mm, ",", '.', "Device: LoadMaster 3\nOperator: kl\nDate: 2026-11-03\nRate: 1 Hz\n\n")},
      {"a preamble of unequal fields", table(mm, in_mm, ",", '.', "Rate,1,Hz\nOperator,kl\n\n")},
      {"a footer", table(names, si, ",", '.', "", "END OF DATA\nmax,0.4518,0.0209,0,0.57\n")},
      {"all in quotes", with_quotes(table(names, si))},
      {"raw and filtered",
       table({"t", "x", "y", "Fx_raw", "Fy_raw", "Fx_filt", "Fy_filt"}, with(si, {"0", "0"}))},
      {"an index without a name", table({"", "x", "y", "Fx", "Fy"}, si)},
      {"micrometres", table({"t", "x_um", "y_um", "Fx", "Fy"}, scaled(1e6, 1))},
      {"blanks", table(names, si, "   ")},
      {"ROS", table({"%time", "field.pose.position.x", "field.pose.position.y", "field.wrench.force.x",
                     "field.wrench.force.y"},
                    si)},
      {"units in the cells", table(names,
                                   [](const Line& l) {
                                     return std::vector{plain(l.t) + " s", plain(1000 * l.x) + "mm",
                                                        plain(1000 * l.y) + "mm", plain(l.Fx) + " N",
                                                        plain(l.Fy) + " N"};
                                   })},
      {"a title block and remarks without a value",
       table({"t", "x (mm)", "y (mm)", "Fx", "Fy", "Remarks"}, in_mm, ",", '.',
             "Torsion bench 4\nOperator: B\n\n")},
      {"a title block of as many fields", table(mm, in_mm, ",", '.', "Bench,4,of,room,12\nA,B,C,D,E\n")},
      {"the newest first", in_reverse(table(names, si))},
      {"objects of JSON", in_json(mm, in_mm)},
      {"columns of other quantities",
       table({"t", "x_mm", "y_mm", "Fx", "Fy", "motor current (A)", "torque1 (N·mm)"},
             with(in_mm, {"1.5", "300"}))},
  };
}

DraftModel two_links() {
  return {{{0.3, 0.2}, {2.0, 1.5}, {}, {0, 0}, {0.4, -0.9}, {}}, {"shoulder", "elbow"}, {0, 0}, true};
}

Experiment read_spelling(const Draft& draft) {
  return read_experiment("", [&](const std::string& name, const std::string& place) {
    if (name == "experiment.toml") return draft.settings;
    for (const DraftFile& one : draft.tables)
      if (one.name == name) return one.text;
    throw Error(place, name, "a table");
  });
}

}  // namespace

TEST_CASE("however a laboratory writes its table, its readings are drafted without a question") {
  for (const Spelling& spelling : spellings()) {
    CAPTURE(spelling.name);
    const Draft draft = draft_experiment("press", two_links(), {{"press.csv", spelling.bytes}});
    CAPTURE(draft.settings);
    CHECK(draft.question == "");
    const Experiment experiment = read_spelling(draft);
    REQUIRE(experiment.runs.size() == 1);
    const std::vector<Reading>& readings = experiment.runs.front().readings;
    REQUIRE(readings.size() == pressed().size());
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const Line& line = pressed()[i];
      const Reading& reading = readings[i];
      CHECK(std::abs(reading.t - readings.front().t - line.t) < 1e-6);
      // Six digits were written: of inches four decimals, so half of 1e-4 of 0.0254 m.
      CHECK(std::abs(reading[column_x] - line.x) < 1.3e-6);
      CHECK(std::abs(reading[column_y] - line.y) < 1.3e-6);
      for (const auto& [column, force] : {std::pair(column_Fx, line.Fx), std::pair(column_Fy, line.Fy)})
        CHECK((std::isnan(reading[column]) || std::abs(reading[column] - force) < 1e-4));
    }
  }
}

TEST_CASE("every column of a table is mentioned, whatever its title") {
  // Words of the trade in any company: whatever is drafted, or refused, names each of them.
  static const std::vector<std::string> titles{
      "Motor 1 [°]", "Motor 2 [°]", "Sensor 1", "Sensor 2",   "torque1 (N mm)", "q1 (deg)",    "q2 (deg)",
      "q1_cmd",      "q2_cmd",      "Fx_raw",   "Fx_filt",    "weight (g)",     "current [A]", "Temp (°C)",
      "roll",        "yaw (deg)",   "volume",   "q1_cmd [°]", "load",           "Fz [N]",      "z (mm)"};
  check_property("used or not, or named where nothing can be drafted", [] {
    std::vector<std::string> header{"t", "x", "y", "Fx", "Fy"};
    for (const std::string& title : *rc::gen::unique<std::vector<std::string>>(rc::gen::elementOf(titles)))
      header.push_back(title);
    const std::string text = table(header, [&](const Line& line) {
      std::vector<std::string> all = scaled(1, 1)(line);
      for (std::size_t c = all.size(); c < header.size(); ++c)
        all.push_back(plain(static_cast<double>(c) + 0.1 * line.t));
      return all;
    });
    std::string said;
    try {
      for (const Guess& guess : draft_experiment("press", two_links(), {{"press.csv", text}}).guesses)
        said += guess.what + " " + guess.value + " " + guess.reason + "\n";
    } catch (const Error& error) {
      said = error.what();
    }
    for (const std::string& title : header)
      if (said.find(title) == std::string::npos) RC_FAIL("nothing says " + title + " in\n" + said);
  });
}

TEST_CASE("a column that the diagnosis may miss is in doubt, with the line that a script writes") {
  for (const char* title : {"motor current (A)", "torque1 (N mm)", "elbow angle", "payload [g]"}) {
    const std::string text = table({"t", "x", "y", "Fx", "Fy", title}, [](const Line& l) {
      std::vector<std::string> all = scaled(1, 1)(l);
      all.push_back(plain(3 + l.t * l.t));
      return all;
    });
    CAPTURE(title);
    const Draft draft = draft_experiment("press", two_links(), {{"press.csv", text}});
    const auto guess = std::find_if(draft.guesses.begin(), draft.guesses.end(), [&](const Guess& one) {
      return one.what == std::string("column ") + title;
    });
    REQUIRE(guess != draft.guesses.end());
    CHECK(guess->doubtful);
    CHECK(guess->line == fmt::format("--columns \"ignore={}\"", title));
  }
}

}  // namespace plumbline::diagnose
