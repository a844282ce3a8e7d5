#include "verify/reference/loaded.hpp"

#include <algorithm>
#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/census/census.hpp"
#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/certificates/path_certificate.hpp"
#include "proofs/exact/certain_digits.hpp"
#include "proofs/paths/followed_path.hpp"
#include "verify/reference/draw.hpp"
#include "verify/reference/set.hpp"

namespace plumbline::verify {
namespace {

using nlohmann::json;
using Model = NominalModel<Mpfr50>;

constexpr int certificate_digits = 40;
constexpr double longest_path_step = 0.2;  ///< in radians; a tube that cannot be so long is halved

Rational ten_thousandths(int value) {
  return {value, 10000};
}

void add_paper(std::vector<LoadedCase>& cases) {
  const auto held = [&](const char* name, const Chain<Rational>& chain, const Rational& x,
                        const Rational& window, bool rest_in_pi = false) {
    cases.push_back({{name, chain, rest_in_pi, proofs::Given::end_point, {x, 0}}, window});
  };
  const auto four = [&](const char* name, const std::vector<int>& rest) {
    std::vector<Rational> angles;
    for (const int angle : rest) angles.push_back(ten_thousandths(angle));
    held(name, Chain<Rational>({1, 1, 1, 1}, {1, 1, 1, 1}, angles), Rational(17, 5), Rational(3, 2));
  };
  held("paper-two-link", Chain<Rational>({1, 1}, {0, 1}), Rational(8, 5), 0);
  held("paper-three-link-straight", Chain<Rational>({1, 1, 1}, {0, 1, 1}), Rational(13, 5), 0);
  held("paper-three-link-zigzag",
       Chain<Rational>({1, 1, 1}, {0, 1, 1}, {0, Rational(1, 10), Rational(-1, 10)}), Rational(13, 5),
       Rational(1, 10), true);
  held("paper-four-link-straight", Chain<Rational>({1, 1, 1, 1}, {1, 1, 1, 1}), Rational(18, 5), 0);
  four("paper-four-link-u", {-3179, 558, 3804, 3524});
  four("paper-four-link-z", {-2417, 6821, -7958, 5170});
}

/// A chain that snaps: its branch has a fold on the way.
LoadedCase snapping() {
  const std::vector<Rational> rest{Rational(3, 5), Rational(-6, 5), Rational(3, 5), 0};
  return {{"snap-four-link",
           Chain<Rational>({1, 1, 1, 1}, {5, 5, 5, 6}, rest),
           false,
           proofs::Given::end_point,
           {Rational(5, 2), 0}},
          Rational(29, 25)};
}

/// A straight chain that buckles under its load.
LoadedCase buckling() {
  return {{"buckling-three-link",
           Chain<Rational>({1, 1, 1}, {1, 1, 1}),
           false,
           proofs::Given::force,
           {Rational(-2, 5), 0}},
          Rational(1, 2)};
}

/// A place well within reach: no farther than nine tenths of all links in line, no nearer than the longest
/// link less the others, and a tenth.
Point<Rational> place_in_reach(Draw& draw, const Rational& reach, const Rational& longest) {
  const Rational nearest = std::max(Rational(2 * longest - reach), Rational(0)) + reach / 10;
  for (;;) {
    const Point<Rational> place{reach * Rational(draw.whole(30, 80), 100),
                                reach * Rational(draw.whole(-30, 30), 100)};
    const Rational square = place.x * place.x + place.y * place.y;
    if (square > nearest * nearest && square < reach * reach * Rational(81, 100)) return place;
  }
}

LoadedCase random_case(const std::string& name, std::size_t n, bool held, std::uint64_t seed) {
  Draw draw(name, seed);
  std::vector<Rational> length, stiffness, rest;
  Rational reach(0);
  for (std::size_t i = 0; i < n; ++i) {
    length.emplace_back(draw.whole(50, 150), 100);
    stiffness.emplace_back(draw.whole(50, 200), 100);
    rest.emplace_back(draw.whole(-150, 150), 100);
    reach += length.back();
  }
  const Rational longest = *std::max_element(length.begin(), length.end());
  const Rational force(draw.whole(-100, -10), 100), slope(draw.whole(-30, 30), 100);
  const auto load = held ? place_in_reach(draw, reach, longest) : Point<Rational>{force, force * slope};
  return {{name, Chain<Rational>(length, stiffness, rest), false,
           held ? proofs::Given::end_point : proofs::Given::force, load},
          held ? Rational(reach / 2) : Rational(2)};
}

json exact_list(const std::vector<Rational>& values) {
  json list = json::array();
  for (const Rational& x : values) list.push_back(proofs::to_exact(x));
  return list;
}

json description(const proofs::CensusTask& task) {
  return {{"case", task.name},
          {"lengths", exact_list(task.chain.length())},
          {"stiffness", exact_list(task.chain.stiffness())},
          {"rest", exact_list(task.chain.rest())},
          {"rest_unit", task.rest_in_pi ? "pi" : "rad"},
          {"control", task.control() == Control::end_point ? "end_point" : "force"}};
}

/// "0" stands for what is within 1e-50 of it.
std::string certain_digits(const Interval& x) {
  if (x.contains_zero() && !(proofs::magnitude(x) < Interval::End("1e-50")))
    throw Error("equilibrium", x.text(6), "zero to fifty digits");
  return proofs::certain_digits(x, reference_digits);
}

Branch<Mpfr50> compressed(const LoadedCase& loaded, const Mpfr50& longest_step) {
  const auto chain = convert<Mpfr50>(proofs::enclosed_chain(loaded.task),
                                     [](const Interval& x) { return Mpfr50(x.middle()); });
  const Model model(chain);
  std::vector<Mpfr50> q = chain.rest();
  Loading<Mpfr50> loading{loaded.task.control(), {0, 0}, {-1, 0}};
  if (loaded.task.control() == Control::end_point) {
    loading.start = end_point(chain, q);
    if (chain.passive_joint(0)) {
      q[0] -= atan2(loading.start.y, loading.start.x);
      loading.start = end_point(chain, q);
    }
  }
  const Vector<Mpfr50> shape = absolute_angles(q);
  Brancher<Model> brancher(model, loading, shape);
  const TraceLimits<Mpfr50> limits{Mpfr50(0), from_rational<Mpfr50>(loaded.window), longest_step};
  return Tracer<Model>(brancher, limits).run(brancher.start(0, shape));
}

json event_entry(const BranchEvent<Mpfr50>& event) {
  const auto text = [](const Mpfr50& x) {
    return abs(x) < Mpfr50("1e-40") ? std::string("0") : x.str(event_digits);
  };
  const BranchPoint<Mpfr50>& at = event.point;
  json angles = json::array();
  for (const Mpfr50& angle : joint_angles(at.theta)) angles.push_back(text(angle));
  return {{"kind", name(event.kind)},
          {"load", text(at.load)},
          {"energy", text(at.energy)},
          {"force", {text(at.force.x), text(at.force.y)}},
          {"end_point", {text(at.end_point.x), text(at.end_point.y)}},
          {"angles", std::move(angles)}};
}

std::string joined(const json& list) {
  std::string text;
  for (const json& one : list) text += (text.empty() ? "" : ";") + one.get<std::string>();
  return text;
}

std::string chain_columns(const json& entry) {
  return fmt::format("{},{},{},{},{}", entry["case"].get<std::string>(), joined(entry["lengths"]),
                     joined(entry["stiffness"]), joined(entry["rest"]),
                     entry["rest_unit"].get<std::string>());
}

std::string state_columns(const json& state) {
  return fmt::format("{},{},{},{}", state["energy"].get<std::string>(), joined(state["force"]),
                     joined(state["end_point"]), joined(state["angles"]));
}

}  // namespace

std::vector<LoadedCase> loaded_cases(ReferenceSize size, std::uint64_t seed) {
  std::vector<LoadedCase> cases;
  add_paper(cases);
  cases.push_back(snapping());
  cases.push_back(buckling());
  for (std::size_t n = 2; n <= 5; ++n) {
    for (int i = 1; i <= (size == ReferenceSize::full ? 10 : 2); ++i) {
      cases.push_back(random_case(fmt::format("loaded-{}-{:02}", n, i), n, i % 2 == 1, seed));
    }
  }
  return cases;
}

std::optional<CertifiedEntry> equilibria_entry(const LoadedCase& loaded) {
  const proofs::Census census = proofs::take_census(loaded.task);
  if (!census.complete()) return std::nullopt;
  json states = json::array();
  for (const proofs::CertifiedEquilibrium& one : census.equilibria) {
    if (!one.negative_directions) return std::nullopt;
    json angles = json::array();
    for (const Interval& angle : one.q) angles.push_back(certain_digits(angle));
    states.push_back({{"negative_directions", *one.negative_directions},
                      {"energy", certain_digits(one.energy)},
                      {"force", {certain_digits(one.fx), certain_digits(one.fy)}},
                      {"end_point", {certain_digits(one.x), certain_digits(one.y)}},
                      {"angles", std::move(angles)}});
  }
  // Mirror images have the same energy; which comes first must not hang on rounding.
  for (std::size_t first = 0, last = 0; first < states.size(); first = last) {
    while (last < states.size() && states[last]["energy"] == states[first]["energy"]) ++last;
    const auto at = [&](std::size_t i) { return states.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(first), at(last), [](const json& a, const json& b) { return a["angles"] < b["angles"]; });
  }
  json entry = description(loaded.task);
  entry["given"] = exact_list({loaded.task.load.x, loaded.task.load.y});
  entry["equilibria"] = std::move(states);
  return CertifiedEntry{std::move(entry),
                        proofs::equilibria_certificate(loaded.task, census, certificate_digits)};
}

std::optional<json> events_entry(const LoadedCase& loaded) {
  const auto once = compressed(loaded, Mpfr50(1) / 20), again = compressed(loaded, Mpfr50(1) / 31);
  json events = json::array();
  for (const auto& event : once.events) events.push_back(event_entry(event));
  json same = json::array();
  for (const auto& event : again.events) same.push_back(event_entry(event));
  if (events != same) return std::nullopt;
  json entry = description(loaded.task);
  entry["window"] = proofs::to_exact(loaded.window);
  entry["events"] = std::move(events);
  return entry;
}

std::optional<json> path_entry(const LoadedCase& loaded) {
  const proofs::CensusTask& task = loaded.task;
  if (task.chain.passive_joint(0)) return std::nullopt;
  const auto exact = proofs::enclosed_chain(task);
  const auto middle = [](const Interval& x) { return static_cast<double>(x.middle()); };
  const auto chain = convert<double>(exact, middle);
  Loading<Interval> loading{task.control(), {0, 0}, {-1, 0}};
  if (task.control() == Control::end_point) loading.start = end_point(exact, exact.rest());
  const proofs::PathTask path{chain,
                              {task.control(), {middle(loading.start.x), middle(loading.start.y)}, {-1, 0}},
                              static_cast<double>(loaded.window),
                              longest_path_step};
  const Point<Rational> along{-1, 0};
  const auto proved =
      proofs::certify(proofs::follow_slowly(path), exact, loading,
                      proofs::symmetries(task.chain, task.control(), along), proofs::ProvedPoints::rounded);
  const bool whole = std::all_of(proved.branches.begin(), proved.branches.end(),
                                 [](const proofs::PathCertificate& one) { return one.certified(); });
  if (!whole) return std::nullopt;
  return proofs::path_certificate({task.name, task.chain, task.rest_in_pi, task.control(), along}, proved);
}

std::string equilibria_csv(const std::vector<json>& entries) {
  std::string text =
      "case,lengths,stiffness,rest,rest_unit,control,given,equilibrium,negative_directions,energy,force,"
      "end_point,angles\n";
  for (const json& e : entries) {
    std::size_t number = 0;
    for (const json& state : e["equilibria"]) {
      text += fmt::format("{},{},{},{},{},{}\n", chain_columns(e), e["control"].get<std::string>(),
                          joined(e["given"]), ++number, state["negative_directions"].get<std::size_t>(),
                          state_columns(state));
    }
  }
  return text;
}

std::string events_csv(const std::vector<json>& entries) {
  std::string text =
      "case,lengths,stiffness,rest,rest_unit,control,window,event,kind,load,energy,force,end_point,angles\n";
  for (const json& e : entries) {
    std::size_t number = 0;
    for (const json& event : e["events"]) {
      text += fmt::format("{},{},{},{},{},{},{}\n", chain_columns(e), e["control"].get<std::string>(),
                          e["window"].get<std::string>(), ++number, event["kind"].get<std::string>(),
                          event["load"].get<std::string>(), state_columns(event));
    }
  }
  return text;
}

}  // namespace plumbline::verify
