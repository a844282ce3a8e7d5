#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <plumbline/base/parallel.hpp>

#include "app/arguments.hpp"
#include "app/chain_file.hpp"
#include "app/complaints.hpp"
#include "app/critical_report.hpp"
#include "app/example_chain.hpp"
#include "app/model_chain.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/space_file.hpp"
#include "app/verbs.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "proofs/exact/critical_torque.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

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

ChainTable one(const std::string& name, NamedStructure structure) {
  structure.name = name;
  return {{std::move(structure)}, {}};
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
  options.table = piped ? is_chain_table(text) : is_table(path);
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

Result compute_plain(NamedStructure& entry, const CriticalOptions& options) {
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
Result compute_follower(NamedStructure& entry, const CriticalOptions& options) {
  const auto motion = straight_motion(entry.structure);
  const auto loss = proofs::stability_loss(motion, options.digits);
  nlohmann::json certificate;
  if (!options.certify.empty())
    certificate = proofs::structure_certificate(entry.name, entry.structure, loss, options.digits);
  return {{std::move(entry.name), std::move(entry.structure), {}, 0, entry.beam, loss},
          std::move(certificate)};
}

/// Of a chain with other ends and loads than the paper's.
Result compute_structure(NamedStructure& entry, const CriticalOptions& options) {
  if (entry.structure.follower()) return compute_follower(entry, options);
  const proofs::StraightStructure straight(entry.structure);
  auto found = straight.in_decimals(wanted(options), options.digits, needs_shapes(options));
  nlohmann::json certificate;
  if (!options.certify.empty())
    certificate =
        proofs::structure_certificate(entry.name, entry.structure, straight, wanted(options), options.digits);
  return {
      {std::move(entry.name), std::move(entry.structure), std::move(found), straight.modes(), entry.beam, {}},
      std::move(certificate)};
}

Result compute(NamedStructure& entry, const CriticalOptions& options) {
  require_straight(entry.structure.chain);
  return entry.plain ? compute_plain(entry, options) : compute_structure(entry, options);
}

std::string certificates(const std::vector<nlohmann::json>& entries, const char* format,
                         const page::Provenance& from) {
  const proofs::Provenance provenance{from.command + " --certify FILE", from.program, ""};
  return proofs::certificate_file(format, provenance, entries).dump(1, ' ', true) + "\n";
}

/// The straight chain in space.
void run_space(const CriticalOptions& options, const std::string& text, Outputs& outputs,
               files::OutputFile* csv, files::OutputFile* json, files::OutputFile* certify) {
  const std::string source = source_of(options), name = name_of(options);
  const SpaceCase space = parse_space_chain(text, source);
  if (space.torque) {
    if (certify) throw Error("--certify", "a torque", "forces: no certificate is made of a torque");
    const auto found = [&] {
      try {
        return proofs::critical_torque(space.chain, space.straight, *space.torque, options.digits);
      } catch (const Error& error) {
        throw Error(source + ": " + error.what());
      }
    }();
    const SpaceTorque torque{name, space.words, space.chain.size(), found.value.decimal, found.conservative};
    if (csv) csv->write(as_csv(torque));
    if (json) json->write(page::json_text(as_json(torque, options.digits), outputs.provenance()));
    outputs.commit();
    if (!csv && !json) fmt::print("{}", as_text(torque));
    return;
  }
  if (!space.axial) throw Error(source, "loads across the chain, which bend it", "loads along x");
  const proofs::StraightSpace straight = [&] {
    try {
      return proofs::StraightSpace(space.chain, space.straight);
    } catch (const Error& error) {
      throw Error(source + ": " + error.what());
    }
  }();
  const SpaceModes modes{name, space.words, space.chain.size(), straight.modes(),
                         straight.in_decimals(wanted(options), options.digits)};
  if (certify)
    certify->write(certificates({proofs::structure_certificate(name, space.chain, space.straight, straight,
                                                               wanted(options), options.digits)},
                                proofs::structure_certificates, outputs.provenance()));
  if (csv) csv->write(as_csv(modes));
  if (json) json->write(page::json_text(as_json(modes, options.digits), outputs.provenance()));
  outputs.commit();
  if (!csv && !json) fmt::print("{}", as_text(modes));
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
  return is_table(path) && is_chain_table(files::read_text(path));
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
  if (!options.table && is_space_chain(text, source))
    return run_space(options, text, outputs, csv, json, certify);
  ChainTable table =
      options.table ? parse_chain_table(text, source) : one(name_of(options), parse_structure(text, source));
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
