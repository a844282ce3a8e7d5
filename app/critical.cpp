#include <fmt/core.h>

#include <memory>

#include "app/chain_file.hpp"
#include "app/critical_report.hpp"
#include "app/example_chain.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "files/text_file.hpp"

namespace plumbline {
namespace {

struct Options {
  std::string input, csv, json;
  int digits = 15;
  bool all = false;
};

bool is_table(const std::string& path) {
  return std::filesystem::path(path).extension() == ".csv";
}

ChainTable read(const std::string& path) {
  if (path.empty())
    return {{{"four-link", example_chain_name, parse_chain(example_chain, example_chain_name)}}, {}};
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".csv") return parse_chain_table(read_text(path), path);
  if (extension != ".toml" && !std::filesystem::is_directory(path))
    throw Error(path, "a name that ends in \"" + extension + "\"",
                ".toml (a chain) or .csv (a table of chains)");
  return {{{std::filesystem::path(path).stem(), path, parse_chain(read_text(path), path)}}, {}};
}

/// Computes every chain of the table; what cannot be computed joins its errors.
std::vector<CriticalModes> compute(ChainTable& table, const Options& options) {
  const bool lowest_only = !options.all && (is_table(options.input) || !options.csv.empty());
  std::vector<CriticalModes> results;
  Progress progress("chains", table.chains.size());
  for (const NamedChain& entry : table.chains) {
    try {
      results.push_back({entry.name, entry.chain,
                         critical_modes(entry.chain, options.digits,
                                        lowest_only ? std::optional<std::size_t>(1) : std::nullopt)});
    } catch (const Error& error) {
      table.errors.push_back(entry.place + ": " + error.what());
    }
    progress.advance();
  }
  return results;
}

void run(Options options) {
  namespace fs = std::filesystem;
  for (std::string* output : {&options.csv, &options.json}) {
    if (options.input.empty() && fs::exists(*output)) std::swap(options.input, *output), *output = "-";
    if (!options.input.empty() && *output == options.input)
      throw Error(*output, "the input itself", "another file for the output");
  }
  ChainTable table = read(options.input);
  std::unique_ptr<OutputFile> csv, json;
  if (!options.csv.empty()) csv = std::make_unique<OutputFile>(options.csv);
  if (!options.json.empty()) json = std::make_unique<OutputFile>(options.json);

  const std::vector<CriticalModes> results = compute(table, options);
  for (const std::string& error : table.errors) fmt::print(stderr, "plumbline: {}\n", error);
  if (!results.empty()) {
    if (csv) csv->write(as_csv(results)), csv->commit();
    if (json) json->write(as_json(results, table.errors).dump(2) + "\n"), json->commit();
    if (!csv && !json) fmt::print("{}", is_table(options.input) ? as_text(results) : as_text(results[0]));
  }
  if (!table.errors.empty()) throw CLI::RuntimeError(2);
}

}  // namespace

void add_critical(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "critical", "Critical forces and shapes of the straight chain, to any number of digits");
  const auto options = std::make_shared<Options>();
  verb->add_option(
          "chain", options->input,
          "CHAIN.toml with the lists lengths, stiffness and (optional) rest, or CHAINS.csv with the "
          "columns chain,lengths,stiffness, the latter two joined by ';'. All numbers are taken as exact "
          "decimals. Without it: the four-link chain of the paper")
      ->type_name("FILE");
  verb->add_option("--digits", options->digits, "Significant digits of the forces, each of them correct")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  verb->add_flag("--all", options->all,
                 "Every mode, where CSV or a table of chains would have the lowest only");
  verb->add_option("--csv", options->csv,
                   "Write chain,mode,force as CSV, ascending (without FILE: to standard output)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->default_str("-");
  verb->add_option("--json", options->json, "Write everything as JSON (without FILE: to standard output)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->default_str("-");
  verb->footer(
      "In a table a wrong chain (a repeated name among them) is one line on standard error and has no rows; "
      "the others are computed, and the exit status is 2.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline
