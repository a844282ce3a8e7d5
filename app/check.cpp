#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/arguments.hpp"
#include "app/complaints.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/submitted_values.hpp"
#include "app/verbs.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/certificates/path_certificate.hpp"
#include "proofs/certificates/structure_certificate.hpp"
#include "statement/chain_table.hpp"
#include "support/files/json_file.hpp"
#include "support/files/text_file.hpp"
#include "verify/reference/agreement.hpp"
#include "verify/reference/chains.hpp"

namespace plumbline::app {
namespace {

struct CheckOptions {
  std::string values, chains, json;
};

/// Ends the verb where anything is wrong.
void refuse(const std::vector<std::string>& errors) {
  complain(errors);
  if (!errors.empty()) throw CLI::RuntimeError(2);
}

/// Certificates are checked by independent programs.
void refuse_certificates(const std::string& text, const std::string& path) {
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object()) return;
  const auto format = document.find("format");
  for (const auto& [name, checker] : {std::pair{proofs::critical_certificates, "check_certificates.py"},
                                      std::pair{proofs::equilibria_certificates, "check_equilibria.py"},
                                      std::pair{proofs::path_certificates, "check_paths.py"},
                                      std::pair{proofs::structure_certificates, "check_structures.py"}}) {
    if (format == document.end() || *format != name) continue;
    throw Error(
        path, "certificates",
        fmt::format(
            "values as CSV; certificates are checked without this program: python3 proofs/certificates/{} {}",
            checker, path));
  }
  throw Error(path, "JSON", "values as CSV, with the columns chain,mode,force");
}

/// The chains of the values: a table, or the reference set.
Chains read_chains(const std::string& path) {
  Chains chains;
  if (path.empty()) {
    for (const auto& reference :
         verify::reference_chains({verify::ReferenceSize::full, verify::reference_seed}))
      chains.emplace(reference.name, reference.chain);
    return chains;
  }
  const statement::ChainTable table =
      statement::parse_chain_table(files::read_text(path), files::source_name(path));
  refuse(table.errors);
  for (const statement::NamedChain& entry : table.chains) chains.emplace(entry.name, entry.structure.chain);
  return chains;
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

void run(const CheckOptions& options, const CLI::App& verb) {
  Outputs outputs(verb, {options.values, options.chains});
  files::OutputFile* const json = outputs.open("--json", options.json);
  const std::string text = files::read_text(options.values);
  refuse_certificates(text, files::source_name(options.values));
  const Chains chains = read_chains(options.chains);
  const SubmittedValues read = parse_values(text, files::source_name(options.values), chains);
  refuse(read.errors);
  const Submitted& submitted = read.values;
  const auto values = compare_all(submitted, chains);
  if (json) {
    json->write(page::json_text(as_json(values, submitted.size()), outputs.provenance()));
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
  const auto options = std::make_shared<CheckOptions>();
  verb->add_option("values", options->values,
                   "CSV with the columns chain,mode,force, as `plumbline critical --all --csv` writes it; - "
                   "is standard "
                   "input")
      ->type_name("VALUES.csv")
      ->required();
  verb->add_option("--chains", options->chains,
                   "The chains that the values are about, chain,lengths,stiffness; without it those of "
                   "`plumbline reference`")
      ->type_name("CHAINS.csv");
  add_printed_output(*verb, "--json", options->json,
                     "Write everything as JSON (without FILE: to standard output)");
  verb->footer(
      "Exit status 1 when a value agrees to fewer digits than double precision permits. Certificates are "
      "checked without this program: proofs/certificates/check_*.py need Python alone.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
