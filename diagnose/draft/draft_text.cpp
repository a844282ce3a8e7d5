#include "diagnose/draft/draft_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/draft/column_numbers.hpp"

namespace plumbline::diagnose {
namespace {

/// A text in TOML.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string list(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

/// What experiment.toml calls a column: the words above it, or its number.
std::string reference(const DraftedRun& run, std::size_t column) {
  const std::vector<std::string>& header = run.table.table.header;
  const bool named = run.table.format.header && column < header.size() && !header[column].empty() &&
                     std::count(header.begin(), header.end(), header[column]) == 1;
  return named ? quoted(header[column]) : fmt::format("{}", column + 1);
}

std::string csv_lines(const SampleFormat& format) {
  std::string text;
  const auto add = [&](const std::string& line) { text += line + "\n"; };
  if (format.delimiter != ',')
    add(fmt::format("delimiter = \"{}\"", format.delimiter == '\t'  ? "tab"
                                          : format.delimiter == ' ' ? "blanks"
                                                                    : std::string(1, format.delimiter)));
  if (format.decimal != '.') add("decimal = \",\"");
  if (!format.header) add("header = false");
  if (format.skip_lines > 0) add(fmt::format("skip_lines = {}", format.skip_lines));
  if (format.skip_after_header > 0) add(fmt::format("skip_after_header = {}", format.skip_after_header));
  if (!format.comment.empty()) add("comment = " + quoted(format.comment));
  if (!format.missing.empty()) {
    std::vector<std::string> words;
    for (const std::string& word : format.missing) words.push_back(quoted(word));
    add(fmt::format("missing = [{}]", fmt::join(words, ", ")));
  }
  return text;
}

/// `{ column = "Kraft", unit = "kgf", sign = -1 }`
std::string column_table(const DraftColumn& column, const std::string& source) {
  std::string text =
      column.constant ? fmt::format("{{ constant = {}", *column.constant) : "{ column = " + source;
  if (!column.unit.empty()) text += ", unit = " + quoted(column.unit);
  if (column.sign < 0) text += ", sign = -1";
  if (column.zero != 0) text += fmt::format(", zero = {}", column.zero);
  return text + " }";
}

std::string columns_lines(const DraftedRun& run, bool absolute) {
  std::string text;
  for (std::size_t c = 0; c < draft_singles; ++c)
    if (const auto& column = run.singles[c])
      text += fmt::format("{} = {}\n", single_names[c], column_table(*column, reference(run, column->place)));
  if (run.angles.empty()) return text;
  std::vector<std::string> names;
  for (const DraftColumn& column : run.angles) names.push_back(reference(run, column.place));
  text +=
      fmt::format("q = {}", column_table(run.angles.front(), fmt::format("[{}]", fmt::join(names, ", "))));
  if (absolute) text.insert(text.size() - 2, ", absolute = true");
  return text + "\n";
}

std::string inline_table(const std::string& lines) {
  std::string text = lines.substr(0, lines.size() - 1);
  for (std::size_t at; (at = text.find('\n')) != std::string::npos;) text.replace(at, 1, ", ");
  return "{ " + text + " }";
}

/// The size of the scatter of what is measured, two digits, in the unit of the readings where all runs share
/// it.
std::string noise_lines(const std::vector<DraftedRun>& runs, bool same_columns) {
  std::map<std::string, std::vector<double>> scatter;
  const auto add = [&](const char* name, const DraftedRun& run, const DraftColumn& column,
                       const Quantity& quantity) {
    if (column.constant) return;
    const double unit =
        column.unit.empty() || same_columns ? 1 : parse_unit(column.unit, quantity, "").in_si();
    if (const double one = scatter_of(run.table.numbers(column.place)); one > 0)
      scatter[name].push_back(one * unit);
  };
  for (const DraftedRun& run : runs) {
    for (std::size_t c = draft_x; c < draft_singles; ++c)
      if (run.singles[c] && run.imposes_force == (c < draft_Fx))
        add(single_names[c], run, *run.singles[c], c < draft_Fx ? quantity::length : quantity::force);
    for (const DraftColumn& column : run.angles) add("q", run, column, quantity::angle);
  }
  std::string text;
  for (auto& [name, all] : scatter) {
    std::sort(all.begin(), all.end());
    text += fmt::format("{} = {:.2g}\n", name, all[all.size() / 2]);
  }
  return text;
}

std::string nominal_lines(const NominalChain& chain) {
  std::string text = "link_length = " + list(chain.link_length) +
                     "\njoint_stiffness = " + list(chain.joint_stiffness) + "\n";
  const auto weighs = [](double mass) { return mass > 0; };
  if (std::any_of(chain.link_mass.begin(), chain.link_mass.end(), weighs))
    text += "link_mass = " + list(chain.link_mass) + "\n";
  if (chain.gravity[0] != 0 || chain.gravity[1] != 0)
    text += fmt::format("gravity = [{}, {}]\n", chain.gravity[0], chain.gravity[1]);
  if (!chain.rest.empty()) text += "rest = " + list(chain.rest) + "\n";
  return text;
}

std::string bench_lines(const DraftModel& model) {
  const double g = std::hypot(model.chain.gravity[0], model.chain.gravity[1]);
  if (!model.weighs) return "gravity_plane = \"unknown\"  # the model has no gravity\n";
  if (!(g > 0))
    return "gravity_plane = \"horizontal\"  # the model's gravity is across the plane of the chain\n";
  std::string text = "gravity_plane = \"vertical\"  # the model's gravity is in the plane of the chain\n";
  if (std::abs(model.chain.gravity[0]) > 1e-6 * g || model.chain.gravity[1] > 0)
    text += fmt::format("gravity_direction = [{:.4g}, {:.4g}]\n", model.chain.gravity[0] / g,
                        model.chain.gravity[1] / g);
  return text;
}

}  // namespace

std::string settings_text(const DraftedExperiment& experiment, const DraftModel& model) {
  const std::vector<DraftedRun>& runs = experiment.runs;
  const std::string csv = csv_lines(runs.front().table.format),
                    columns = columns_lines(runs.front(), experiment.absolute_angles);
  const bool same_csv = std::all_of(
      runs.begin(), runs.end(), [&](const DraftedRun& run) { return csv_lines(run.table.format) == csv; });
  const bool same_columns = std::all_of(runs.begin(), runs.end(), [&](const DraftedRun& run) {
    return columns_lines(run, experiment.absolute_angles) == columns;
  });
  std::string text =
      "#:schema experiment.schema.json\n# Drafted by `plumbline new`: what it guessed, it said; correct here "
      "what is wrong.\nformat = \"chain-experiment/1\"\n";
  text += "name = " + quoted(experiment.name) + "\n\n[nominal]\n" + nominal_lines(model.chain);
  text += "\n[bench]\n" + bench_lines(model);
  text += "\n[noise]  # how much neighbouring readings scatter\n" + noise_lines(runs, same_columns);
  if (same_csv && !csv.empty()) text += "\n[csv]\n" + csv;
  if (same_columns) text += "\n[columns]\n" + columns;
  for (const DraftedRun& run : runs) {
    text += fmt::format("\n[[run]]\nid = {}\ncontrol = \"{}\"\n", quoted(run.id),
                        run.imposes_force ? "force" : "displacement");
    if (!run.rest.empty()) text += fmt::format("rest = [{:.6g}]\n", fmt::join(run.rest, ", "));
    text += "samples = " + quoted(run.file) + "\n";
    if (!same_csv && !csv_lines(run.table.format).empty())
      text += "csv = " + inline_table(csv_lines(run.table.format)) + "\n";
    if (!same_columns)
      text += "columns = " + inline_table(columns_lines(run, experiment.absolute_angles)) + "\n";
  }
  return text;
}

}  // namespace plumbline::diagnose
