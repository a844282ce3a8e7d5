#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "app/chain_file.hpp"
#include "app/complaints.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "files/csv_file.hpp"
#include "files/printable.hpp"
#include "files/text_file.hpp"
#include "proofs/decimal.hpp"
#include "verify/reference/agreement.hpp"
#include "verify/reference/chains.hpp"

namespace plumbline::app {
namespace {

struct Options {
  std::string values, chains, json;
};

using Chains = std::map<std::string, Chain<Rational>>;
using Submitted = std::map<std::string, std::vector<verify::SubmittedForce>>;

/// The chains that values may be about: of a table, or of the reference set.
/// Ends the verb where anything is wrong.
void refuse(const std::vector<std::string>& errors) {
  complain(errors);
  if (!errors.empty()) throw CLI::RuntimeError(2);
}

Chains read_chains(const std::string& path) {
  Chains chains;
  if (path.empty()) {
    for (const auto& reference :
         verify::reference_chains(verify::ReferenceSize::full, verify::reference_seed))
      chains.emplace(reference.name, reference.chain);
    return chains;
  }
  const ChainTable table = parse_chain_table(files::read_text(path), path);
  refuse(table.errors);
  for (const NamedChain& entry : table.chains) chains.emplace(entry.name, entry.chain);
  return chains;
}

std::size_t column(const files::CsvRow& header, const std::string& name, const std::string& path) {
  const auto found = std::find(header.fields.begin(), header.fields.end(), name);
  if (found == header.fields.end())
    throw Error(fmt::format("{}:{}", path, header.line), fmt::format("no column {}", name),
                "the columns chain,mode,force");
  return static_cast<std::size_t>(found - header.fields.begin());
}

bool not_a_number(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  static const std::set<std::string> names{"nan", "-nan", "inf", "-inf", "+inf", "infinity", "-infinity"};
  return names.count(text) > 0;
}

verify::SubmittedForce parse_force(const files::CsvRow& row, const std::string& place,
                                   const std::string& mode, const std::string& force, std::size_t modes) {
  verify::SubmittedForce result{row.line, 0, force};
  const auto [end, error] = std::from_chars(mode.data(), mode.data() + mode.size(), result.mode);
  if (error != std::errc() || end != mode.data() + mode.size() || result.mode < 1 || result.mode > modes)
    throw Error(place, fmt::format("mode \"{}\"", files::shown(mode)), fmt::format("a mode from 1 to {}", modes));
  if (!proofs::parse_decimal(force) && !not_a_number(force))
    throw Error(place, fmt::format("force \"{}\"", files::shown(force)), "a decimal number");
  return result;
}

Submitted read_values(const std::string& path, const Chains& chains) {
  const std::vector<files::CsvRow> rows = files::parse_csv(files::read_text(path), path);
  const std::size_t chain_column = column(rows.front(), "chain", path),
                    mode_column = column(rows.front(), "mode", path),
                    force_column = column(rows.front(), "force", path);
  if (rows.size() == 1) throw Error(path, "no row below the header", "a row for each critical force");
  Submitted submitted;
  std::set<std::pair<std::string, std::size_t>> seen;
  const auto take = [&](const files::CsvRow& row, const std::string& place) {
    if (row.fields.size() != rows.front().fields.size())
      throw Error(place, fmt::format("{} fields", row.fields.size()),
                  fmt::format("{} as in the header", rows.front().fields.size()));
    const std::string& name = row.fields[chain_column];
    const auto chain = chains.find(name);
    if (chain == chains.end())
      throw Error(place, fmt::format("chain \"{}\"", files::shown(name)),
                  "a chain of the reference set (or name yours by --chains)");
    const auto force = parse_force(row, place, row.fields[mode_column], row.fields[force_column],
                                   mode_count(chain->second));
    if (!seen.emplace(name, force.mode).second)
      throw Error(place, fmt::format("mode {} of {} again", force.mode, name), "each mode once");
    submitted[name].push_back(force);
  };
  std::vector<std::string> errors;
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    try {
      take(*row, fmt::format("{}:{}", path, row->line));
    } catch (const Error& error) {
      errors.emplace_back(error.what());
    }
  }
  refuse(errors);
  return submitted;
}

std::vector<verify::ForceAgreement> compare_all(const Submitted& submitted, const Chains& chains) {
  std::vector<verify::ForceAgreement> result;
  Progress progress("chains", submitted.size());
  for (const auto& [name, forces] : submitted) {
    const auto compared = verify::compare(name, chains.at(name), forces);
    result.insert(result.end(), compared.begin(), compared.end());
    progress.advance();
  }
  verify::sort_worst_first(result);
  return result;
}

std::size_t disagreeing(const std::vector<verify::ForceAgreement>& values) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(),
                                                [](const verify::ForceAgreement& v) { return !v.agrees(); }));
}

std::string as_text(const std::vector<verify::ForceAgreement>& values, std::size_t chains) {
  constexpr std::size_t most = 20;
  const std::size_t wrong = disagreeing(values);
  std::string text =
      fmt::format("{} values of {} chains: {} agree as far as double precision permits, {} {} not\n",
                  values.size(), chains, values.size() - wrong, wrong, wrong == 1 ? "does" : "do");
  text += fmt::format("\n{:<26}{:>4}  {:>6} {:>9}  {}\n", "worst first", "mode", "digits", "permitted",
                      "finding");
  for (std::size_t i = 0; i < std::min(values.size(), wrong == 0 ? std::size_t{5} : most); ++i) {
    const verify::ForceAgreement& v = values[i];
    text += fmt::format("{:<26}{:>4}  {:6.1f} {:9.1f}  {}\n", v.chain, v.submitted.mode, v.digits,
                        v.permitted, v.agrees() ? "agrees" : v.finding);
    if (!v.agrees())
      text += fmt::format("    line {}: found {}, expected {}\n", v.submitted.line, v.submitted.text,
                          v.reference);
  }
  if (wrong > most) text += fmt::format("... and {} more (--json has all)\n", wrong - most);
  const auto places = verify::where_to_look(values);
  if (!places.empty()) text += "\nWhere to look\n";
  for (const std::string& place : places) text += fmt::format("  {}\n", place);
  return text;
}

nlohmann::json as_json(const std::vector<verify::ForceAgreement>& values, std::size_t chains) {
  nlohmann::json list = nlohmann::json::array();
  for (const verify::ForceAgreement& v : values) {
    list.push_back({{"chain", v.chain},
                    {"mode", v.submitted.mode},
                    {"line", v.submitted.line},
                    {"force", v.submitted.text},
                    {"reference", v.reference},
                    {"digits", v.digits},
                    {"permitted", v.permitted},
                    {"condition", v.condition},
                    {"agrees", v.agrees()},
                    {"finding", v.finding}});
  }
  return {{"chains", chains},
          {"agree", values.size() - disagreeing(values)},
          {"disagree", disagreeing(values)},
          {"where_to_look", verify::where_to_look(values)},
          {"values", std::move(list)}};
}

void run(const Options& options) {
  Outputs outputs({options.values, options.chains});
  files::OutputFile* const json = outputs.open("--json", options.json);
  const Chains chains = read_chains(options.chains);
  const Submitted submitted = read_values(options.values, chains);
  const auto values = compare_all(submitted, chains);
  if (json) {
    json->write(as_json(values, submitted.size()).dump(2) + "\n");
    outputs.commit();
  } else {
    fmt::print("{}", as_text(values, submitted.size()));
  }
  if (disagreeing(values) > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_check(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("check", "How many digits of your critical forces agree with the reference");
  const auto options = std::make_shared<Options>();
  verb->add_option("values", options->values,
                   "CSV with the columns chain,mode,force, as `plumbline critical --all --csv` writes it")
      ->type_name("VALUES.csv")
      ->required();
  verb->add_option("--chains", options->chains,
                   "The chains that the values are about, chain,lengths,stiffness; without it those of "
                   "`plumbline reference`")
      ->type_name("CHAINS.csv");
  verb->add_option("--json", options->json, "Write everything as JSON (without FILE: to standard output)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->default_str("-");
  verb->footer("Exit status 1 when a value agrees to fewer digits than double precision permits.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
