#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/arguments.hpp"
#include "app/loaded_input.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "proofs/census/census_task.hpp"
#include "proofs/census/found_equilibria.hpp"
#include "proofs/certificates/certificate.hpp"
#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/exact/certain_digits.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/exact/span.hpp"

namespace plumbline::app {
namespace {

struct EquilibriaOptions {
  LoadedChain chain;
  std::vector<std::string> at, place, force;
  std::string json, certificate;
  bool certify = false;
  int digits = 12, turns = 0;
  std::string factor_text;  ///< exact
  double factor = 0;
};

/// One equilibrium as decimals.
struct Entry {
  std::vector<std::string> q;
  std::string x, y, fx, fy, energy, type;
};

struct Answer {
  std::vector<Entry> equilibria;
  std::vector<std::vector<std::string>> undecided;  ///< boxes of joint angles
  std::string note;                                 ///< what is known of completeness
  proofs::Window window;                            ///< of the joint angles counted; empty: all
  std::string zero;                                 ///< "0" stands for less than this, where it does
  nlohmann::json certificate;                       ///< where one is wanted
  bool complete = false, balanced = false;
};

constexpr int certificate_digits = 40;

Point<Rational> exact(const std::vector<std::string>& pair, const char* option) {
  const auto number = [&](const std::string& text) {
    const auto value = proofs::parse_decimal(text);
    if (!value) throw Error(option, text, "two decimal numbers joined by a comma");
    return *value;
  };
  return {number(pair[0]), number(pair[1])};
}

proofs::CensusTask task_of(const EquilibriaOptions& options) {
  proofs::CensusTask task{options.chain.name, options.chain.exact, false, {}, {}, options.turns};
  if (!options.force.empty()) {
    task.given = proofs::Given::force;
    task.load = exact(options.force, "--force");
  } else if (!options.place.empty()) {
    task.given = proofs::Given::end_point;
    task.load = exact(options.place, "--end-point");
  } else {
    task.given = proofs::Given::deflection;
    task.load = options.at.empty() ? Point<Rational>{Rational(2, 5), 0} : exact(options.at, "--at");
  }
  return task;
}

std::string certificate_of(const Answer& answer, const page::Provenance& from) {
  const proofs::Provenance provenance{from.command + " --certificate FILE", from.program, ""};
  return proofs::certificate_file(proofs::equilibria_certificates, provenance, {answer.certificate})
             .dump(1, ' ', true) +
         "\n";
}

std::string type_name(std::optional<std::size_t> negative) {
  if (!negative) return "undecided";
  return *negative == 0 ? "stable" : fmt::format("unstable ({})", *negative);
}

/// The decimals of an answer, and how small what is written as 0 is.
class Decimals {
 public:
  explicit Decimals(int digits) : digits_(digits) {}
  std::string operator()(const Interval& x) {
    if (x.contains_zero()) nothing_ = std::max(nothing_, proofs::magnitude(x));
    return proofs::certain_digits(x, digits_);
  }
  [[nodiscard]] std::string zero() const {
    return nothing_ > 0 ? hull(Interval(0), Interval(nothing_, nothing_)).text(2) : "";
  }

 private:
  int digits_;
  Interval::End nothing_{0};
};

std::string completeness(const proofs::Census& census) {
  if (!census.complete()) return "certified, but for the undecided boxes";
  return census.window.empty() ? "certified: these are all"
                               : "certified: these are all with joint angles in the window";
}

Answer certified(const EquilibriaOptions& options, const proofs::CensusTask& task) {
  const proofs::Census census = proofs::take_census(task);
  Decimals text(options.digits);
  Answer answer;
  for (const proofs::CertifiedEquilibrium& one : census.equilibria) {
    Entry entry{{},
                text(one.x),
                text(one.y),
                text(one.fx),
                text(one.fy),
                text(one.energy),
                type_name(one.negative_directions)};
    for (const Interval& angle : one.q) entry.q.push_back(text(angle));
    answer.equilibria.push_back(std::move(entry));
  }
  for (const auto& box : census.undecided) {
    std::vector<std::string> q;
    q.reserve(box.size());
    for (const Interval& angle : box) q.push_back(angle.text(8));
    answer.undecided.push_back(std::move(q));
  }
  if (!options.certificate.empty())
    answer.certificate = proofs::equilibria_certificate(task, census, certificate_digits);
  answer.complete = census.complete();
  answer.balanced = census.balanced;
  answer.window = census.window;
  answer.zero = text.zero();
  answer.note = fmt::format("{} ({} boxes searched; every digit shown is certain{})", completeness(census),
                            census.boxes, census.balanced ? "; even less odd ones as topology demands" : "");
  return answer;
}

/// Newton's method from many random shapes: fast, for any n, and never sure to be complete.
Answer sampled(const EquilibriaOptions& options, const proofs::CensusTask& task) {
  const proofs::FoundEquilibria found = proofs::find_equilibria(task);
  const int digits = std::min(options.digits, 15);
  const auto text = [&](const Interval::End& x) { return x.str(digits); };
  Answer answer;
  answer.window = found.window;
  for (const proofs::FoundEquilibrium& one : found.equilibria) {
    Entry entry{{},
                text(one.x),
                text(one.y),
                text(one.fx),
                text(one.fy),
                text(one.energy),
                type_name(one.negative_directions)};
    for (const double angle : one.q) entry.q.push_back(text(Interval::End(angle)));
    answer.equilibria.push_back(std::move(entry));
  }
  answer.note = fmt::format("found from {} random shapes; {}", found.starts,
                            found.exhausted ? "--certify proves that there are no others, or finds them"
                                            : "stopped at so many: there are more, perhaps a continuum");
  return answer;
}

Answer answer_of(const EquilibriaOptions& options, const proofs::CensusTask& task) {
  const std::string bound = fmt::format("census (given up after {:.0e} boxes, a minute or two)",
                                        static_cast<double>(proofs::CensusLimits().boxes));
  const Progress progress(options.certify ? bound : "equilibria", 0);
  return options.certify ? certified(options, task) : sampled(options, task);
}

/// "joint angles counted: q1 in [-3.1416, 3.1416], …".
std::string window_text(const Answer& answer, const Chain<Rational>& chain) {
  if (answer.window.empty()) return "joint angles counted: all, passive joints once around\n";
  std::string text = "joint angles counted:";
  for (std::size_t i = 0; i < answer.window.size(); ++i) {
    const proofs::Span range(answer.window[i]);
    const auto shown = [](double x) { return std::abs(x) < 1e-9 ? 0 : x; };
    text += fmt::format("{} q{} in [{:.5g}, {:.5g}]{}", i > 0 ? "," : "", i + 1, shown(range.low),
                        shown(range.high), chain.passive_joint(i) ? " (passive: once around)" : "");
  }
  return text + "\n  shapes that are wound up further have more energy and are left out: --turns\n";
}

nlohmann::ordered_json window_json(const Answer& answer) {
  if (answer.window.empty()) return "all";
  auto list = nlohmann::ordered_json::array();
  for (const Interval& range : answer.window) {
    const proofs::Span angle(range);
    list.push_back({angle.low, angle.high});
  }
  return list;
}

std::string answer_text(const Answer& answer, const EquilibriaOptions& options,
                        const proofs::CensusTask& task) {
  const Point<Interval> load = proofs::enclosed_load(task);
  std::string text =
      fmt::format("{}: {} ({}, {})\n{} equilibria, by energy; {}\n", options.chain.name,
                  task.control() == Control::force ? "force" : "end point held at", load.x.middle().str(6),
                  load.y.middle().str(6), answer.equilibria.size(), answer.note);
  text += window_text(answer, options.chain.exact);
  if (!answer.zero.empty()) text += "0 stands for an absolute value in " + answer.zero + "\n";
  for (std::size_t i = 0; i < answer.equilibria.size(); ++i) {
    const Entry& one = answer.equilibria[i];
    text +=
        fmt::format("\n{:3}  {}, energy {}\n     force     {}, {}\n     end point {}, {}\n     angles    ",
                    i + 1, one.type, one.energy, one.fx, one.fy, one.x, one.y);
    for (std::size_t j = 0; j < one.q.size(); ++j) text += (j > 0 ? ", " : "") + one.q[j];
    text += "\n";
  }
  for (const auto& box : answer.undecided) {
    text += "\nundecided: joint angles in";
    for (const std::string& q : box) text += " " + q;
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json answer_json(const Answer& answer, const EquilibriaOptions& options,
                                   const proofs::CensusTask& task) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& one : answer.equilibria) {
    list.push_back({{"type", one.type},
                    {"energy", one.energy},
                    {"force", {one.fx, one.fy}},
                    {"end_point", {one.x, one.y}},
                    {"q", one.q}});
  }
  return {
      {"chain", options.chain.name},  {"control", task.control() == Control::force ? "force" : "end_point"},
      {"certified", options.certify}, {"complete", answer.complete},
      {"balanced", answer.balanced},  {"joint_angles_counted", window_json(answer)},
      {"equilibria", list},           {"undecided", answer.undecided}};
}

/// The certified census of a planar chain at a factor of its file's loads.
void run_census(const EquilibriaOptions& options, Outputs& outputs, files::OutputFile* json) {
  if (!options.chain.structure) throw Error("--certify", "a chain in space", "a chain in the plane");
  const auto factor = proofs::parse_decimal(options.factor_text);
  const Progress progress("census", 0);
  const auto census = proofs::take_census(*options.chain.structure, *factor, options.turns);
  const NamedModel& chain = *options.chain.model;
  if (json) json->write(page::json_text(as_json(chain, options.factor, census), outputs.provenance()));
  outputs.commit();
  if (!json) fmt::print("{}", as_text(chain, options.factor, census));
  if (!census.complete()) throw CLI::RuntimeError(1);
}

/// At a factor of the file's loads.
void run_factor(const EquilibriaOptions& options, Outputs& outputs, files::OutputFile* json) {
  if (!options.at.empty() || !options.place.empty() || !options.force.empty() || options.factor == 0)
    throw Error(options.chain.plain ? "--factor" : options.chain.path,
                options.chain.plain ? "a force or a place beside it" : "ends and loads of its own",
                "--factor F: its loads times F");
  if (!options.certificate.empty())
    throw Error("--certificate", "loads by a factor", "--certify alone: no file of such proofs");
  if (options.certify) return run_census(options, outputs, json);
  constexpr std::size_t starts = 2000;
  constexpr double half_turn = 3.1415926535897932;
  const NamedModel& chain = *options.chain.model;
  const Progress progress("equilibria", 0);
  const auto found = proofs::find_equilibria(chain.model, chain.wide, options.factor, starts,
                                             (1 + 2 * options.turns) * half_turn, 1);
  if (json) json->write(page::json_text(as_json(chain, options.factor, found), outputs.provenance()));
  outputs.commit();
  if (!json) fmt::print("{}", as_text(chain, options.factor, found, starts));
}

void run(EquilibriaOptions options, const CLI::App& verb) {
  Outputs outputs(verb, {options.chain.path});
  files::OutputFile *const json = outputs.open("--json", options.json), *const certificate =
                                                                            outputs.open("--certificate",
                                                                                         options.certificate);
  options.certify = options.certify || certificate;
  options.chain.read();
  if (!options.chain.plain || options.factor != 0) return run_factor(options, outputs, json);
  const proofs::CensusTask task = task_of(options);
  const Answer answer = answer_of(options, task);
  if (json) json->write(page::json_text(answer_json(answer, options, task), outputs.provenance()));
  if (certificate) certificate->write(certificate_of(answer, outputs.provenance()));
  outputs.commit();
  if (!json) fmt::print("{}", answer_text(answer, options, task));
  if (options.certify && !answer.complete) throw CLI::RuntimeError(1);
}

}  // namespace

void add_equilibria(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "equilibria", "All equilibria of a chain at a deflection or under a force: shape, force, energy, type");
  const auto options = std::make_shared<EquilibriaOptions>();
  options->chain.add_to(*verb);
  auto* at =
      as_pair(verb->add_option(
                  "--at", options->at,
                  "The unloaded end point moved by DX against x (compression is positive) and by DY along y"),
              "DX,DY");
  auto* place =
      as_pair(verb->add_option("--end-point", options->place, "Instead: the end point held at (X, Y)"), "X,Y")
          ->excludes(at);
  as_pair(verb->add_option("--force", options->force,
                           "Instead: a force on the end point; compression has FX < 0"),
          "FX,FY")
      ->excludes(at)
      ->excludes(place);
  verb->add_option("--factor", options->factor_text,
                   "Under the file's loads times F; where it says of none, under a compression of F")
      ->type_name("F")
      ->check(number())
      ->excludes(at)
      ->excludes(place);
  verb->add_flag("--certify", options->certify,
                 "Prove by interval arithmetic that the list is complete: under a force among all joint "
                 "angles, with the "
                 "end point held among those in the window that is printed. Exit status 1 where something "
                 "stays undecided");
  add_output(
      *verb, "--certificate", options->certificate,
      "Write that proof so that proofs/certificates/check_equilibria.py checks it with integers alone");
  verb->add_option(
          "--turns", options->turns,
          "With the end point held: count also shapes whose joints are wound up by so many full turns "
          "more. Without: each joint within half a turn of straight (of folded, if it rests nearer to "
          "that; of its rest, at the base)")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  verb->add_option("--digits", options->digits, "Significant digits")
      ->check(whole_number(1, 35))
      ->capture_default_str();
  add_printed_output(*verb, "--json", options->json,
                     "Write everything as JSON (without FILE: to standard output)");
  verb->footer(
      "Type: the number in brackets counts the directions in which the energy falls, with the end point held "
      "or "
      "under the dead force.");
  verb->callback([options, verb] {
    if (!options->factor_text.empty()) options->factor = std::stod(options->factor_text);
    run(*options, *verb);
  });
}

}  // namespace plumbline::app
