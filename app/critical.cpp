#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <plumbline/base/parallel.hpp>

#include "app/arguments.hpp"
#include "app/case_words.hpp"
#include "app/complaints.hpp"
#include "app/critical_report.hpp"
#include "app/example_chain.hpp"
#include "app/model_chain.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/critical_torque.hpp"
#include "proofs/paths/structure_path.hpp"
#include "proofs/rod/rod_of_chain.hpp"
#include "statement/chain_table.hpp"
#include "statement/stated.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;
using statement::ChainTable, statement::NamedChain;

struct CriticalOptions {
  std::string input, csv, json, certify;
  int digits = 15;
  bool all = false;
  bool table = false;  ///< what was read is a table of chains
};

constexpr const char* example_chain_name = "docs/examples/four-link.toml";

bool is_table(const std::string& path) {
  return fs::path(path).extension() == ".csv";
}

/// How many modes of a chain to compute, whatever is written: of one chain some, of many the lowest.
std::size_t wanted(const CriticalOptions& options) {
  if (options.all) return std::numeric_limits<std::size_t>::max();
  return options.table ? 1 : 20;
}

/// Rows of numbers alone have the forces alone.
bool needs_shapes(const CriticalOptions& options) {
  return options.csv.empty() || !options.json.empty();
}

ChainTable one(const std::string& name, const std::string& source, const std::string& text,
               statement::PlaneChain chain) {
  return {{{std::move(chain), name, source, text}}, {}};
}

/// The text of the input, whose kind it tells.
std::string read(CriticalOptions& options) {
  const std::string& path = options.input;
  if (path.empty()) return example_chain;
  const std::string extension = fs::path(path).extension();
  const bool piped = files::is_standard_input(path);
  if (extension != ".csv" && !names_chain_file(path) && !piped && !fs::is_directory(path))
    throw Error(path, "a name that ends in \"" + extension + "\"",
                ".toml (a chain), .csv (a table of chains) or a model: .xml (MJCF), .urdf, .sdf");
  std::string text = read_chain_text(path);
  options.table = piped ? statement::is_chain_table(text) : is_table(path);
  return text;
}

std::string source_of(const CriticalOptions& options) {
  return options.input.empty() ? example_chain_name : files::source_name(options.input);
}

std::string name_of(const CriticalOptions& options) {
  if (options.input.empty()) return "four-link";
  return files::is_standard_input(options.input) ? "chain"
                                                 : files::printable(fs::path(options.input).stem().string());
}

void require_straight(const Chain<Rational>& chain) {
  const auto bent =
      std::find_if(chain.rest().begin(), chain.rest().end(), [](const Rational& q) { return q != 0; });
  if (bent == chain.rest().end()) return;
  throw Error("rest, entry " + std::to_string(bent - chain.rest().begin() + 1), "an angle that is not zero",
              "zero: only the straight chain has critical forces");
}

struct Results {
  std::vector<CriticalModes> chains;
  std::vector<nlohmann::json> certificates;
};

/// What is asked for of one chain.
struct Result {
  CriticalModes chain;
  nlohmann::json certificate;
};

Result compute_plain(NamedChain& entry, const CriticalOptions& options) {
  const Chain<Rational>& chain = entry.structure.chain;
  const auto modes = needs_shapes(options) ? proofs::modes_in_decimals : proofs::forces_in_decimals;
  auto found = modes(chain, wanted(options), options.digits);
  nlohmann::json certificate;
  if (!options.certify.empty()) {
    const std::size_t shapes = options.digits > 1 ? wanted(options) : 0;
    certificate = proofs::certificate(entry.name, chain,
                                      proofs::certify(chain, wanted(options), shapes, options.digits));
  }
  const std::size_t all = chain.size() - 1;
  return {{std::move(entry.name), std::move(entry.structure), std::move(found), all, {}, {}},
          std::move(certificate)};
}

/// Of a chain with a load that follows it.
Result compute_follower(NamedChain& entry, const CriticalOptions& options) {
  const auto motion = straight_motion(entry.structure);
  const auto loss = proofs::stability_loss(motion, options.digits);
  nlohmann::json certificate;
  if (!options.certify.empty())
    certificate = proofs::structure_certificate(entry.name, statement::stated(entry.text, entry.place), loss,
                                                options.digits);
  return {{std::move(entry.name), std::move(entry.structure), {}, 0, entry.beam, loss},
          std::move(certificate)};
}

/// Of a chain with other ends and loads than the paper's.
Result compute_structure(NamedChain& entry, const CriticalOptions& options) {
  if (entry.structure.follower()) return compute_follower(entry, options);
  const proofs::StraightStructure straight(entry.structure);
  auto found = straight.in_decimals(wanted(options), options.digits, needs_shapes(options));
  nlohmann::json certificate;
  if (!options.certify.empty())
    certificate = proofs::structure_certificate(entry.name, statement::stated(entry.text, entry.place),
                                                straight, wanted(options), options.digits);
  return {
      {std::move(entry.name), std::move(entry.structure), std::move(found), straight.modes(), entry.beam, {}},
      std::move(certificate)};
}

RodAnswer rod_of(const CriticalModes& chain, int digits) {
  constexpr int most_digits = 20;
  try {
    const proofs::Rod rod = proofs::rod_of_chain(chain.data, *chain.beam);
    return {proofs::critical_rod(rod, std::min(digits, most_digits)), ""};
  } catch (const Error& error) {
    return {std::nullopt, error.what()};
  }
}

Result compute(NamedChain& entry, const CriticalOptions& options) {
  require_straight(entry.structure.chain);
  if (entry.plain) return compute_plain(entry, options);
  Result result = compute_structure(entry, options);
  if (result.chain.beam && needs_shapes(options)) result.chain.rod = rod_of(result.chain, options.digits);
  return result;
}

std::string certificates(const std::vector<nlohmann::json>& entries, const char* format,
                         const page::Provenance& from) {
  const proofs::Provenance provenance{from.command + " --certify FILE", from.program, ""};
  return proofs::certificate_file(format, provenance, entries).dump(1, ' ', true) + "\n";
}

/// Writes a result in space wherever it is asked for.
template <class Result>
void write(const Result& result, const CriticalOptions& options, Outputs& outputs, files::OutputFile* csv,
           files::OutputFile* json) {
  if (csv) csv->write(as_csv(result));
  if (json) json->write(page::json_text(as_json(result, options.digits), outputs.provenance()));
  outputs.commit();
  if (!csv && !json) fmt::print("{}", as_text(result));
}

/// The straight chain in space.
void run_space(const CriticalOptions& options, const std::string& text,
               const SpaceStructure<Rational>& structure, Outputs& outputs, files::OutputFile* csv,
               files::OutputFile* json, files::OutputFile* certify) {
  const std::string name = name_of(options), words = case_of(structure);
  const std::size_t links = structure.chain.size();
  if (structure.torque) {
    if (certify) throw Error("--certify", "a torque", "forces: no certificate is made of a torque");
    const auto found = proofs::critical_torque(structure, options.digits);
    proofs::require_regular_line(structure);
    return write(SpaceTorque{name, words, links, found.value.decimal, found.conservative}, options, outputs,
                 csv, json);
  }
  const proofs::StraightSpace straight(structure);
  proofs::require_regular_line(structure);
  const SpaceModes modes{name, words, links, straight.modes(),
                         straight.in_decimals(wanted(options), options.digits)};
  if (certify)
    certify->write(
        certificates({proofs::structure_certificate(name, statement::stated(text, source_of(options)),
                                                    straight, wanted(options), options.digits)},
                     proofs::structure_certificates, outputs.provenance()));
  write(modes, options, outputs, csv, json);
}

/// Computes every chain of the table, which is used up; what cannot be computed joins its errors.
Results compute(ChainTable& table, const CriticalOptions& options) {
  const std::size_t count = table.chains.size();
  std::vector<std::optional<Result>> found(count);
  std::vector<std::string> errors(count);
  Progress progress(count > 1 ? "chains" : "critical forces", count > 1 ? count : 0);
  in_parallel(count, available_threads(), [&](std::size_t i) {
    try {
      found[i] = compute(table.chains[i], options);
    } catch (const Error& error) {
      errors[i] = table.chains[i].place + ": " + error.what();
    }
    progress.advance();
  });
  Results results;
  for (std::size_t i = 0; i < count; ++i) {
    if (!found[i]) {
      table.errors.push_back(std::move(errors[i]));
      continue;
    }
    results.chains.push_back(std::move(found[i]->chain));
    if (!options.certify.empty()) results.certificates.push_back(std::move(found[i]->certificate));
  }
  return results;
}

/// Whether a file is a chain or a table of chains, not what was written here before.
bool holds_chains(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  if (fs::path(path).extension() == ".toml") return true;
  return is_table(path) && statement::is_chain_table(files::read_text(path));
}

/// `critical --csv CHAINS.csv` means that file as the chain, not as the output.
void sort_out_files(CriticalOptions& options) {
  for (std::string* output : {&options.csv, &options.json}) {
    if (!options.input.empty() || !holds_chains(*output)) continue;
    options.input = *output;
    *output = "-";
  }
}

void run(CriticalOptions options, const CLI::App& verb) {
  sort_out_files(options);
  Outputs outputs(verb, {options.input});
  files::OutputFile *const csv = outputs.open("--csv", options.csv),
                           *const json = outputs.open("--json", options.json),
                           *const certify = outputs.open("--certify", options.certify);
  const std::string text = read(options), source = source_of(options);
  ChainTable table;
  if (options.table) {
    table = statement::parse_chain_table(text, source);
  } else {
    statement::StatedChain chain = statement::parse_chain(text, source);
    if (const auto* space = std::get_if<SpaceStructure<Rational>>(&chain)) {
      try {
        return run_space(options, text, *space, outputs, csv, json, certify);
      } catch (const Error& error) {
        throw Error(source + ": " + error.what());
      }
    }
    table = one(name_of(options), source, text, std::get<statement::PlaneChain>(std::move(chain)));
  }
  const bool plain = options.table || table.chains.front().plain;

  const Results results = compute(table, options);
  complain(table.errors);
  if (!results.chains.empty()) {
    if (csv) csv->write(as_csv(results.chains));
    const page::Provenance& from = outputs.provenance();
    if (json) json->write(page::json_text(as_json(results.chains, table.errors, options.digits), from));
    if (certify)
      certify->write(certificates(results.certificates,
                                  plain ? proofs::critical_certificates : proofs::structure_certificates,
                                  from));
    outputs.commit();
    if (!csv && !json) fmt::print("{}", options.table ? as_text(results.chains) : as_text(results.chains[0]));
  }
  if (!table.errors.empty()) throw CLI::RuntimeError(2);
}

}  // namespace

void add_critical(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "critical",
      "Critical forces and shapes of a straight chain, whatever its ends and loads, to any digits");
  const auto options = std::make_shared<CriticalOptions>();
  verb->add_option("chain", options->input,
                   "CHAIN.toml with the lists lengths and stiffness, and\n"
                   "the ends and loads where they are not the paper's, or\n"
                   "CHAINS.csv with the columns chain,lengths,stiffness,\n"
                   "the latter two lists joined by ';'. Every number is\n"
                   "the exact decimal that is written. - is standard\n"
                   "input, either of them. Or a simulator's model,\n"
                   ".xml (MJCF), .urdf or .sdf. Without a file:\n"
                   "the four-link chain of the paper")
      ->type_name("FILE");
  verb->add_option("--digits", options->digits, "Significant digits of the forces, all correct")
      ->type_name("D")
      ->capture_default_str()
      ->check(whole_number(1, 10000).description(""));
  verb->add_flag("--all", options->all,
                 "Every mode (else, at most the 20 lowest of a chain,\n"
                 "and the lowest alone of each in a table)");
  add_printed_output(*verb, "--csv", options->csv, "Write chain,mode,force, a row a mode, ascending");
  add_printed_output(*verb, "--json", options->json, "Write forces, shapes and joint angles as JSON");
  add_output(*verb, "--certify", options->certify,
             "Write certificates that proofs/certificates/check_certificates.py\n(check_structures.py: of "
             "other ends and loads) checks with\nintegers alone");
  verb->footer(
      "Ends and loads: base sprung by the stiffness of joint 1 (pinned where it is 0), end\n"
      "point guided along the line, a dead force there, unless the chain's file says otherwise:\n"
      "docs/chain-format.md. The first line of the answer says which they are.\n"
      "Without FILE, or with -, --csv and --json write to standard output.\n"
      "A wrong chain in a table (a repeated name is wrong too) is one line on standard\n"
      "error and has no rows; the others are computed, and the exit status is 2.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
