#include "diagnose/draft/draft_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/bench/read_nominal.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/quoted.hpp"

namespace plumbline::diagnose {
namespace {

std::string list(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

/// What experiment.toml calls a column: the words above it, or its number.
std::string reference(const RunSource& source, std::size_t column) {
  const SourcePart& part = source.part_of(column);
  const std::vector<std::string>& header = part.table.table.header;
  const std::size_t place = column - part.first;
  const bool named = part.table.format.header && place < header.size() && !header[place].empty() &&
                     std::count(header.begin(), header.end(), header[place]) == 1;
  return named ? quoted(header[place]) : fmt::format("{}", place + 1);
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
  if (format.transposed) add("transposed = true");
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

/// The covariates that every run has.
std::vector<std::string> common_covariates(const std::vector<DraftedRun>& runs) {
  std::vector<std::string> names;
  for (const auto& one : runs.front().covariates)
    if (std::all_of(runs.begin(), runs.end(),
                    [&](const DraftedRun& run) { return run.covariates.contains(one.first); }))
      names.push_back(one.first);
  return names;
}

std::string covariate_lines(const DraftedRun& run, const DraftedExperiment& experiment,
                            const auto& is_there) {
  std::vector<std::string> all;
  for (const std::string& name : common_covariates(experiment.runs)) {
    const DraftColumn& column = run.covariates.at(name);
    if (!is_there(column.place)) continue;
    const std::string source = reference(run.source, column.place);
    const bool plain = !column.constant && column.unit.empty();
    all.push_back(name + " = " + (plain ? source : column_table(column, source)));
  }
  return all.empty() ? "" : fmt::format("covariate = {{ {} }}\n", fmt::join(all, ", "));
}

/// The time of a part that is joined with the first.
std::optional<DraftColumn> time_of(const RunSource& source, const SourcePart& part) {
  const std::vector<ColumnWords> words = source.words({});
  for (std::size_t c = part.first; c < part.first + part.table.columns(); ++c)
    if (words[c].kind == Kind::time) return DraftColumn{c, words[c].unit};
  return {};
}

/// One value for all columns, or a list with one each; nothing where none differs from the usual.
std::string for_each(const char* key, const std::vector<DraftColumn>& columns, const auto& value,
                     double usual) {
  std::vector<double> all;
  for (const DraftColumn& column : columns) all.push_back(value(column));
  const auto is = [](double wanted) { return [wanted](double one) { return one == wanted; }; };
  if (std::all_of(all.begin(), all.end(), is(usual))) return "";
  if (std::all_of(all.begin(), all.end(), is(all.front())))
    return fmt::format(", {} = {:.12g}", key, all.front());
  return fmt::format(", {} = [{:.12g}]", key, fmt::join(all, ", "));
}

/// `q = { column = ["q1", "q2"], unit = "deg", sign = [1, -1] }`
std::string angles_line(const char* key, const RunSource& source, const std::vector<DraftColumn>& angles,
                        bool absolute) {
  std::vector<std::string> names;
  for (const DraftColumn& column : angles) names.push_back(reference(source, column.place));
  std::string text = fmt::format("{} = {{ column = [{}]", key, fmt::join(names, ", "));
  if (!angles.front().unit.empty()) text += ", unit = " + quoted(angles.front().unit);
  text += for_each(
      "sign", angles, [](const DraftColumn& one) { return static_cast<double>(one.sign); }, 1);
  text += for_each(
      "zero", angles, [](const DraftColumn& one) { return one.zero; }, 0);
  return text + (absolute ? ", absolute = true }\n" : " }\n");
}

/// \param part  whose columns are written, and with the first the constants; or nullptr for those of all
std::string columns_lines(const DraftedRun& run, const DraftedExperiment& experiment,
                          const SourcePart* part = nullptr) {
  const RunSource& source = run.source;
  const auto is_there = [&](std::size_t place) { return part == nullptr || &source.part_of(place) == part; };
  const bool later = part != nullptr && part != &source.parts.front();
  std::string text;
  for (std::size_t c = 0; c < draft_singles; ++c) {
    const auto column = c == draft_t && later ? time_of(source, *part) : run.singles[c];
    if (column && (column->constant ? !later : is_there(column->place)))
      text += fmt::format("{} = {}\n", single_channels(run.device)[c].name,
                          column_table(*column, reference(source, column->place)));
  }
  text += covariate_lines(run, experiment, is_there);
  for (const auto& [key, angles] : {std::pair("q", &run.angles), std::pair("q_command", &run.commands)})
    if (!angles->empty() && is_there(angles->front().place))
      text += angles_line(key, source, *angles, experiment.absolute_angles);
  return text;
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
  const auto add = [&](const std::string& name, const DraftedRun& run, const DraftColumn& column,
                       const Quantity& quantity) {
    if (column.constant) return;
    const double unit =
        column.unit.empty() || same_columns ? 1 : parse_unit(column.unit, quantity, "").in_si();
    if (const double one = scatter_of(run.source.numbers(column.place)); one > 0)
      scatter[name].push_back(one * unit);
  };
  for (const DraftedRun& run : runs) {
    for (std::size_t c = draft_x; c < draft_singles; ++c)
      if (run.singles[c] && run.imposes_force == (c < draft_Fx))
        add(single_channels(run.device)[c].name, run, *run.singles[c],
            *single_channels(run.device)[c].quantity);
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
  std::string text = chain.has_links() ? "link_length = " + list(chain.link_length)
                     : chain.slides(0) ? "joint = \"prismatic\""
                                       : "joint = \"revolute\"";
  text += "\njoint_stiffness = " + list(chain.joint_stiffness) + "\n";
  const auto weighs = [](double mass) { return mass > 0; };
  if (std::any_of(chain.link_mass.begin(), chain.link_mass.end(), weighs))
    text += "link_mass = " + list(chain.link_mass) + "\n";
  if (chain.gravity[0] != 0 || chain.gravity[1] != 0)
    text += fmt::format("gravity = [{}, {}]\n", chain.gravity[0], chain.gravity[1]);
  for (const NominalEffect& effect : chain.effects) text += nominal_effect_table(effect);
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

/// A load along the chain. Moment arms that nobody has said are an empty list, which the reader refuses.
std::string load_lines(const DraftedLoad& load, std::size_t joints) {
  const LoadWords& words = load_words(load.kind);
  const std::string note = load.moment_arm.empty() ? fmt::format("  # fill in {} numbers, {}: {}", joints,
                                                                 words.of_arms->si, words.arms_are)
                                                   : "";
  return fmt::format("\n[[load]]\n{} = {}\n{} = {}{}\n", words.key, quoted(load.name), words.arms,
                     list(load.moment_arm), note);
}

const SampleFormat& format_of(const DraftedRun& run) {
  return run.source.parts.front().table.format;
}

/// Whether the parts of a run have a format and columns each.
bool is_joined(const DraftedRun& run) {
  return run.source.parts.size() > 1 && !run.source.follow;
}

/// The key `samples`: a file, files that follow one another, or files that are joined, with all that is said
/// about each.
std::string samples_lines(const DraftedRun& run, const DraftedExperiment& experiment) {
  const std::vector<SourcePart>& parts = run.source.parts;
  if (parts.size() == 1) return "samples = " + quoted(parts.front().file) + "\n";
  std::vector<std::string> all;
  for (const SourcePart& part : parts) {
    if (!is_joined(run)) {
      all.push_back(quoted(part.file));
      continue;
    }
    const std::string csv = csv_lines(part.table.format);
    all.push_back(fmt::format("\n  {{ file = {},{} columns = {} }}", quoted(part.file),
                              csv.empty() ? "" : " csv = " + inline_table(csv) + ",",
                              inline_table(columns_lines(run, experiment, &part))));
  }
  return fmt::format("samples = [{}{}]\n", fmt::join(all, ", "), is_joined(run) ? ",\n" : "");
}

std::string_view control_word(const DraftedRun& run) {
  if (!run.commands.empty()) return "command";
  const EndKind& end = run.end();
  return run.imposes_force ? end.by_load : end.by_place;
}

/// A run, with its format and columns unless all share them.
std::string run_lines(const DraftedRun& run, const DraftedExperiment& experiment, bool same_csv,
                      bool same_columns) {
  std::string text =
      fmt::format("\n[[run]]\nid = {}\ncontrol = \"{}\"\n", quoted(run.source.id), control_word(run));
  if (run.by_weights) text += "loaded_by = \"weights\"\n";
  if (!run.rest.empty()) text += fmt::format("rest = [{:.6g}]\n", fmt::join(run.rest, ", "));
  text += samples_lines(run, experiment);
  if (is_joined(run)) return text;
  const std::string csv = csv_lines(format_of(run));
  if (!same_csv && !csv.empty()) text += "csv = " + inline_table(csv) + "\n";
  if (!same_columns) text += "columns = " + inline_table(columns_lines(run, experiment)) + "\n";
  return text;
}

}  // namespace

std::string settings_text(const DraftedExperiment& experiment, const DraftModel& model) {
  const std::vector<DraftedRun>& runs = experiment.runs;
  const std::string csv = csv_lines(format_of(runs.front())),
                    columns = columns_lines(runs.front(), experiment);
  const bool same_csv = std::all_of(runs.begin(), runs.end(), [&](const DraftedRun& run) {
    return !is_joined(run) && csv_lines(format_of(run)) == csv;
  });
  const bool same_columns = std::all_of(runs.begin(), runs.end(), [&](const DraftedRun& run) {
    return !is_joined(run) && columns_lines(run, experiment) == columns;
  });
  std::string text =
      "#:schema experiment.schema.json\n# Drafted by `plumbline new`: what it guessed, it said; correct here "
      "what is wrong.\nformat = \"chain-experiment/1\"\n";
  text += "name = " + quoted(experiment.name) + "\n\n[nominal]\n" + nominal_lines(model.chain);
  if (model.chain.has_links()) text += "\n[bench]\n" + bench_lines(model);
  for (const DraftedLoad& load : experiment.loads) text += load_lines(load, model.chain.link_length.size());
  text += "\n[noise]  # how much neighbouring readings scatter\n" + noise_lines(runs, same_columns);
  if (same_csv && !csv.empty()) text += "\n[csv]\n" + csv;
  if (same_columns) text += "\n[columns]\n" + columns;
  for (const DraftedRun& run : runs) text += run_lines(run, experiment, same_csv, same_columns);
  return text;
}

}  // namespace plumbline::diagnose
