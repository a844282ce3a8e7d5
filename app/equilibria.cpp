#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <plumbline/loaded/equilibrium.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <random>

#include "app/loaded_input.hpp"
#include "app/verbs.hpp"
#include "files/text_file.hpp"
#include "proofs/census.hpp"
#include "proofs/decimal.hpp"

namespace plumbline::app {
namespace {

struct Options {
  LoadedChain chain;
  std::vector<std::string> at, place, force;
  std::string json;
  bool certify = false;
  int digits = 12;
};

struct Load {
  Control control;
  Point<Interval> value;  ///< where the end point is held, or the force
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
  bool complete = false;
};

Interval exact(const std::string& text, const char* option) {
  const auto value = proofs::parse_decimal(text);
  if (!value) throw Error(option, text, "two decimal numbers joined by a comma");
  return Interval(*value);
}

Load load_of(const Options& options) {
  if (!options.force.empty())
    return {Control::force, {exact(options.force[0], "--force"), exact(options.force[1], "--force")}};
  if (!options.place.empty())
    return {Control::end_point,
            {exact(options.place[0], "--end-point"), exact(options.place[1], "--end-point")}};
  const auto chain = from_rational<Interval>(options.chain.exact);
  const Point<Interval> rest = end_point(chain, chain.rest());
  const Interval dx = options.at.empty() ? Interval(Rational(2, 5)) : exact(options.at[0], "--at");
  const Interval dy = options.at.empty() ? Interval(0) : exact(options.at[1], "--at");
  return {Control::end_point, {rest.x - dx, rest.y + dy}};
}

std::string type_name(std::optional<std::size_t> negative) {
  if (!negative) return "undecided";
  return *negative == 0 ? "stable" : fmt::format("unstable ({})", *negative);
}

Answer certified(const Options& options, const Load& load) {
  const auto chain = from_rational<Interval>(options.chain.exact);
  const proofs::Census census = load.control == Control::force
                                    ? proofs::census_under_force(chain, load.value)
                                    : proofs::census_at_end_point(chain, load.value);
  const auto text = [&](const Interval& x) { return x.middle().str(options.digits); };
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
  answer.complete = census.complete();
  answer.note = fmt::format(
      "{} ({} boxes searched; every number is certified to the digits shown)",
      answer.complete ? "certified: these are all" : "certified, but for the undecided boxes", census.boxes);
  return answer;
}

/// Newton's method from many random shapes: fast, for any n, and never sure to be complete.
Answer sampled(const Options& options, const Load& load) {
  const auto chain = from_rational<double>(options.chain.exact);
  const NominalModel<double> model(chain);
  EquilibriumSolver<NominalModel<double>> solver(model);
  const auto middle = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const Point<double> at{middle(load.value.x), middle(load.value.y)};
  if (load.control == Control::end_point) model.require_reach(at);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> turn(-3.14159, 3.14159);
  std::vector<Equilibrium<double>> found;
  const std::size_t n = chain.size(), trials = 1000 * n;
  for (std::size_t trial = 0; trial < trials; ++trial) {
    std::vector<double> q = chain.rest();
    for (double& angle : q) angle += turn(random) * (trial % 3 == 0 ? 1 : 0.4);
    if (trial == 0) q = chain.rest();
    try {
      const auto theta = absolute_angles(q);
      const auto one =
          load.control == Control::force ? solver.under_force(at, theta) : solver.at_end_point(at, theta);
      const auto angles = joint_angles(one.theta);
      bool counted = true, known = false;
      for (std::size_t i = 0; i < n; ++i) {
        const double d = chain.stiffness()[i] > 0 ? angles[i] - chain.rest()[i] : angles[i];
        counted = counted && (load.control == Control::force && chain.stiffness()[i] > 0
                                  ? true
                                  : std::abs(d) <= 3.1415926535897936);
      }
      for (const auto& other : found) known = known || (other.theta - one.theta).cwiseAbs().maxCoeff() < 1e-6;
      if (counted && !known) found.push_back(one);
    } catch (const Error&) {  // this start leads to no equilibrium
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.energy < b.energy; });
  const auto text = [&](double x) { return fmt::format("{:.{}g}", x, std::min(options.digits, 15)); };
  Answer answer;
  for (const auto& one : found) {
    Entry entry{{},
                text(one.end_point.x),
                text(one.end_point.y),
                text(one.force.x),
                text(one.force.y),
                text(one.energy),
                type_name(one.negative_directions)};
    for (const double angle : joint_angles(one.theta)) entry.q.push_back(text(angle));
    answer.equilibria.push_back(std::move(entry));
  }
  answer.note = fmt::format(
      "found from {} random shapes; --certify proves that there are no others, or finds them", trials);
  return answer;
}

std::string as_text(const Answer& answer, const Options& options, const Load& load) {
  std::string text =
      fmt::format("{}: {} ({:.6g}, {:.6g})\n{} equilibria, by energy; {}\n", options.chain.name,
                  load.control == Control::force ? "force" : "end point held at",
                  static_cast<double>(load.value.x.middle()), static_cast<double>(load.value.y.middle()),
                  answer.equilibria.size(), answer.note);
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

nlohmann::ordered_json as_json(const Answer& answer, const Options& options, const Load& load) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Entry& one : answer.equilibria) {
    list.push_back({{"type", one.type},
                    {"energy", one.energy},
                    {"force", {one.fx, one.fy}},
                    {"end_point", {one.x, one.y}},
                    {"q", one.q}});
  }
  return {{"chain", options.chain.name},  {"control", load.control == Control::force ? "force" : "end_point"},
          {"certified", options.certify}, {"complete", answer.complete},
          {"equilibria", list},           {"undecided", answer.undecided}};
}

void run(Options options) {
  options.chain.read();
  options.chain.refuse_as_output(options.json);
  const Load load = load_of(options);
  const Answer answer = options.certify ? certified(options, load) : sampled(options, load);
  if (options.json.empty()) {
    fmt::print("{}", as_text(answer, options, load));
  } else {
    files::OutputFile file(options.json);
    file.write(as_json(answer, options, load).dump(2) + "\n");
    file.commit();
  }
  if (options.certify && !answer.complete) throw CLI::RuntimeError(1);
}

}  // namespace

void add_equilibria(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "equilibria", "All equilibria of a chain at a deflection or under a force: shape, force, energy, type");
  const auto options = std::make_shared<Options>();
  options->chain.add_to(*verb);
  const auto pair = [&](const char* flag, std::vector<std::string>& target, const char* names,
                        const char* what) {
    return verb->add_option(flag, target, what)->type_name(names)->delimiter(',')->expected(2);
  };
  auto* at = pair("--at", options->at, "DX,DY",
                  "The unloaded end point moved by DX against x (compression is positive) and by DY along y");
  auto* place =
      pair("--end-point", options->place, "X,Y", "Instead: the end point held at (X, Y)")->excludes(at);
  pair("--force", options->force, "FX,FY", "Instead: a force on the end point; compression has FX < 0")
      ->excludes(at)
      ->excludes(place);
  verb->add_flag(
      "--certify", options->certify,
      "Prove by interval arithmetic that the list is complete: with the end point held, among all shapes "
      "(each counted with the deflections of at most half a turn that make it); under a force, among all "
      "joint angles. Exit status 1 where something stays undecided");
  verb->add_option("--digits", options->digits, "Significant digits")
      ->check(CLI::Range(1, 35))
      ->capture_default_str();
  verb->add_option("--json", options->json, "Write everything as JSON (without FILE: to standard output)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->default_str("-");
  verb->footer(
      "Type: the number in brackets counts the directions in which the energy falls, with the end point held "
      "or "
      "under the dead force.");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
