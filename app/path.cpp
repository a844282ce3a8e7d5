#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "app/arguments.hpp"
#include "app/certified_report.hpp"
#include "app/complaints.hpp"
#include "app/loaded_input.hpp"
#include "app/located_report.hpp"
#include "app/outputs.hpp"
#include "app/path_report.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/path_certificate.hpp"
#include "proofs/paths/path_load.hpp"

namespace plumbline::app {
namespace {

struct PathOptions {
  LoadedChain chain;
  double to = 0, dy = 0, step = 0.005, factor = 0;
  std::vector<double> force;
  std::string branches = "stable", csv, json, svg, certificate;
  int side = 1, digits = 0;
  bool certify = false;
};

proofs::PathLoad load_of(const PathOptions& options) {
  return options.force.empty() ? proofs::PathLoad{Control::end_point, {-options.to, options.dy}}
                               : proofs::PathLoad{Control::force, {options.force[0], options.force[1]}};
}

struct Followed {
  proofs::PathReport report;
  LocatedReport located;
  proofs::JoinedBranches certified;
};

Followed follow(const PathOptions& options, const proofs::PathTask& task) {
  const Progress progress("path", 0);
  Followed all{options.branches == "stable" ? proofs::follow_slowly(task) : proofs::follow_all(task), {}, {}};
  all.report.chain = options.chain.name;
  if (options.digits > 0) {
    const auto exact = from_rational<proofs::Located>(options.chain.exact);
    all.located = locate(all.report, options.chain.exact, proofs::loading_of(load_of(options), exact).first);
  }
  if (options.certify)
    all.certified = proofs::certify(
        all.report, options.chain.exact, load_of(options),
        options.certificate.empty() ? proofs::ProvedPoints::as_followed : proofs::ProvedPoints::rounded);
  return all;
}

std::string certificate_of(const PathOptions& options, const proofs::JoinedBranches& certified,
                           const page::Provenance& from) {
  const proofs::PathLoad way = load_of(options);
  const proofs::PathGiven given{options.chain.name, options.chain.exact, false, way.control, way.direction()};
  const proofs::Provenance provenance{from.command + " --certificate FILE", from.program, ""};
  return proofs::certificate_file(proofs::path_certificates, provenance,
                                  {proofs::path_certificate(given, certified)})
             .dump(1, ' ', true) +
         "\n";
}

proofs::StructurePath structure_path(const PathOptions& options, const proofs::StructureTask& task) {
  const NamedModel& chain = *options.chain.model;
  try {
    return options.branches == "stable" ? proofs::follow_slowly(chain.model, chain.wide, task)
                                        : proofs::follow_all(chain.model, chain.wide, task);
  } catch (const Error& error) {
    throw Error(chain.name + ": " + error.what());
  }
}

/// The path of a chain as the factor of its file's loads grows.
void run_factor(const PathOptions& options, Outputs& outputs, files::OutputFile* csv,
                files::OutputFile* json) {
  if (options.factor == 0)
    throw Error(options.chain.path, "ends and loads of its own",
                "--factor F: its loads grow from 0 to F times");
  if (options.certify && !options.chain.structure)
    throw Error(options.chain.path, "a chain in space", "--certify for one in the plane");
  const proofs::StructureTask task{options.factor, std::max(options.step, 0.005), options.side};
  const NamedModel& chain = *options.chain.model;
  const Progress progress("path", 0);
  const proofs::StructurePath path = structure_path(options, task);
  std::vector<proofs::StructureCertificate> certified;
  if (options.certify) {
    for (const auto& branch : path.branches)
      certified.push_back(proofs::certify(*options.chain.structure, branch, options.factor));
  }
  for (const std::string& warning : path.warnings) complain("warning: " + warning);
  if (csv) csv->write(as_csv(chain, path));
  if (json) {
    auto all = as_json(chain, path);
    if (options.certify) all["certificates"] = as_json(certified);
    json->write(page::json_text(std::move(all), outputs.provenance()));
  }
  outputs.commit();
  if (!csv && !json) fmt::print("{}{}", as_text(chain, path), options.certify ? as_text(certified) : "");
  if (!std::all_of(certified.begin(), certified.end(), [](const auto& one) { return one.certified(); }))
    throw CLI::RuntimeError(1);
}

void run(PathOptions options, const CLI::App& verb) {
  Outputs outputs(verb, {options.chain.path});
  files::OutputFile *const csv = outputs.open("--csv", options.csv),
                           *const json = outputs.open("--json", options.json),
                           *const svg = outputs.open("--svg", options.svg),
                           *const certificate = outputs.open("--certificate", options.certificate);
  options.certify = options.certify || certificate;
  options.chain.read();
  if (!options.chain.plain || options.factor != 0) {
    if (svg || certificate || options.digits > 0 || !options.force.empty() || options.to != 0.5)
      throw Error(options.chain.plain ? "--factor" : options.chain.path,
                  options.chain.plain ? "other options beside it" : "ends and loads of its own",
                  "--factor, --branches, --side, --step, --certify, --csv and --json alone");
    return run_factor(options, outputs, csv, json);
  }
  const proofs::PathTask task =
      proofs::path_task(options.chain.exact, load_of(options), options.step, options.side);
  const auto [report, located, certified] = follow(options, task);
  for (const std::string& warning : report.warnings) complain("warning: " + warning);
  const page::Provenance& from = outputs.provenance();
  if (svg) svg->write(page::in_drawing(page::as_svg(as_drawing(report, task.chain), 2), from));
  if (csv) csv->write(as_csv(report));
  if (json) {
    auto all = as_json(report);
    if (options.digits > 0) all["events"] = as_json(located, options.digits);
    if (options.certify) all["certificates"] = as_json(certified);
    json->write(page::json_text(std::move(all), from));
  }
  if (certificate) certificate->write(certificate_of(options, certified, from));
  outputs.commit();
  if (!csv && !json && !svg)
    fmt::print("{}{}{}", as_text(report), options.digits > 0 ? as_text(located, options.digits) : "",
               options.certify ? as_text(certified) : "");
  if (options.certify && !complete(certified)) throw CLI::RuntimeError(1);
}

}  // namespace

void add_path(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "path", "Force-deflection curve of a loaded chain, with stability, buckling and quasi-buckling points");
  const auto options = std::make_shared<PathOptions>();
  options->chain.add_to(*verb);
  auto* to =
      verb->add_option("--to", options->to, "Move the end point by DX against x: compression is positive")
          ->check(number())
          ->type_name("DX");
  auto* dy = verb->add_option("--dy", options->dy, "and by DY along y, in proportion")
                 ->check(number())
                 ->type_name("DY");
  as_pair(verb->add_option("--force", options->force,
                           "Instead: load the end point with a force that grows from zero to (FX, FY); "
                           "compression has FX < 0"),
          "FX,FY")
      ->check(number())
      ->excludes(to)
      ->excludes(dy);
  verb->add_option("--factor", options->factor,
                   "Let the file's loads grow from 0 to F times what stands there; where it says of none, a "
                   "compression from 0 to F")
      ->type_name("F")
      ->check(number())
      ->excludes(to)
      ->excludes(dy);
  verb->add_option("--branches", options->branches,
                   "stable: what a slowly loaded chain does, jumps included; all: every branch that hangs "
                   "together with "
                   "it or (up to five links) passes the last or the middle load")
      ->check(one_of({"stable", "all"}))
      ->capture_default_str();
  verb->add_option("--side", options->side, "Where a symmetric chain buckles: 1 or -1, the side it leaves to")
      ->check(one_of({"1", "-1"}))
      ->capture_default_str();
  verb->add_option("--step", options->step,
                   "Longest way between points: root mean square turn of the links, in radians")
      ->check(number(1e-4, 0.5))
      ->capture_default_str();
  verb->add_option("--digits", options->digits,
                   "Locate every event anew to so many digits, and list them (text and JSON)")
      ->check(whole_number(1, proofs::located_digits));
  verb->add_flag(
      "--certify", options->certify,
      "Prove by interval arithmetic what the points only suggest: that each part is one smooth "
      "branch without gap or jump, where it is stable, and where the load turns; and that it goes on through "
      "the pitchforks of a chain that is exactly symmetric. Around any other bifurcation, where "
      "equilibria are not regular, a small gap is left out and listed (text and JSON). Exit status 1 where "
      "anything else stays open");
  add_output(*verb, "--certificate", options->certificate,
             "Write that proof so that proofs/certificates/check_paths.py checks it with integers alone");
  add_printed_output(*verb, "--csv", options->csv,
                     "Write every point as CSV (without FILE: to standard output)");
  add_printed_output(*verb, "--json", options->json,
                     "Write everything as JSON (without FILE: to standard output)");
  add_printed_output(*verb, "--svg", options->svg,
                     "Draw force over deflection and the shapes as SVG (without FILE: to standard output)");
  verb->callback([options, to, verb] {
    if (options->force.empty() && to->count() == 0) options->to = 0.5;
    run(*options, *verb);
  });
}

}  // namespace plumbline::app
