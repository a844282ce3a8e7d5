/// \file
/// Slowly compressed chains: what is proved of their whole paths, and where something happens.

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "proofs/exact/exactly.hpp"
#include "verify/generic/quantities.hpp"
#include "verify/judging/comparison.hpp"
#include "verify/judging/sign.hpp"

namespace plumbline::verify {
namespace {

double last_deflection(const Parameters& with, const Premises& given) {
  return from_rational<double>(exact_quantity(with.text("to"), given));
}

/// Deflections of the path, evenly apart: where what is not proved of all of it is looked for.
std::vector<Rational> places(const Rational& from, const Rational& to) {
  constexpr int pieces = 12;
  std::vector<Rational> list;
  for (int i = 1; i <= pieces; ++i) list.push_back(from + (to - from) * Rational(i, pieces));
  return list;
}

std::string all_signs(const Parameters& with, const Premises& given, const SlowPath& path) {
  const Rational from = exact_quantity(with.text("from", "0"), given),
                 to = exact_quantity(with.text("to"), given);
  const auto seen = states(path, places(from, to));
  const std::string found = signs(seen.back());
  if (path.everywhere(from, to, [&](const auto& one) { return signs(one) == found; })) return found;
  const bool others = std::any_of(seen.begin(), seen.end(), [&](const auto& one) {
    const std::string here = signs(one);
    return here != found && here.find('0') == std::string::npos;
  });
  if (others && found.find('0') == std::string::npos) return "changing";
  with.wrong("signs that are not proved of the whole path", "a path whose signs are");
}

/// The word where it is proved, the other where two certified states contradict it.
std::string proved_or_contradicted(const Parameters& with, const SlowPath& path, const Premises& given,
                                   bool proved, const std::string& word,
                                   bool (*contradict)(const Interval&, const Interval&),
                                   std::vector<Interval> (*values)(const SlowPath&,
                                                                   const std::vector<Rational>&)) {
  if (proved) return word;
  const std::vector<Interval> list = values(path, places(0, exact_quantity(with.text("to"), given)));
  for (std::size_t i = 1; i < list.size(); ++i)
    if (contradict(list[i - 1], list[i])) return "not " + word;
  with.wrong("a path of which " + word + " is not proved",
             "one of which it is, or states that contradict it");
}

std::vector<Interval> compressions(const SlowPath& path, const std::vector<Rational>& at) {
  std::vector<Interval> list;
  for (const auto& one : states(path, at)) list.push_back(paper_force(one).x);
  return list;
}

/// Smooth where it is proved to be, not smooth at an event of a path that is proved but for that.
std::string smoothness(const Parameters& with, const SlowPath& path) {
  if (path.regular()) return "smooth";
  if (path.continuity() == "open" || path.events.empty())
    with.wrong("a path that is not proved", "one that is, as far as its events");
  return "not smooth";
}

/// The event that is asked for. \throws Error where there is another number of them than one
BranchPoint<proofs::Located> place_of(const Parameters& with, const Premises& given, const SlowPath& path) {
  const std::string what = with.text("event");
  if (what == "joint straightens" || what == "link levels") {
    const Printed between = with.list("between");
    if (between.size() != 2) with.wrong("between", "two deflections");
    const std::size_t joint = what == "link levels" ? 0 : std::stoul(with.text("joint")) - 1;
    const proofs::Located at =
        straightens_at(path, joint, exact_quantity(between[0], given), exact_quantity(between[1], given));
    return path.at(proofs::exactly(at));
  }
  const EventKind kind = what == "bifurcation" ? EventKind::bifurcation
                         : what == "fold"      ? EventKind::fold
                         : what == "least stiffness"
                             ? EventKind::quasi_buckling
                             : throw Error("check", "the event '" + what + "'",
                                           "bifurcation, fold, least stiffness, joint "
                                           "straightens or link levels");
  const auto events = path.of_kind(kind);
  if (events.size() != 1) with.wrong(fmt::format("{} events", events.size()), "one " + what);
  return events.front().point;
}

/// "a bifurcation", "joint 2 straight".
std::string happening(const Parameters& with) {
  const std::string what = with.text("event");
  return what == "joint straightens" ? fmt::format("joint {} straight", with.text("joint"))
         : what == "link levels"     ? "its first link level"
                                     : "a " + what;
}

/// What a chain has whose path is found to be so: "a path that is smooth".
std::string possession(const std::string& asks, const std::string& found) {
  if (asks == "signs") return "joint angles of the signs " + found;
  if (asks == "minima of the stiffness") return found + " minima of the stiffness";
  if (found.starts_with("a ")) return found + " on its path";
  const bool path = asks == "continuity" || asks == "smoothness";
  return fmt::format("a {} that is {}", path ? "path" : asks, found);
}

/// "deflection 0.5, force 1.2".
std::string named(const Printed& names, const Printed& numbers) {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list.push_back((names[i].starts_with("theta") ? with_index(names[i]) : names[i]) + " = " + numbers.at(i));
  return fmt::format("{}", fmt::join(list, ", "));
}

/// "deflection", "force", "stiffness", "theta 1".
proofs::Located of_point(const Parameters& with, const BranchPoint<proofs::Located>& point,
                         const std::string& name) {
  if (name == "deflection") return point.load;
  if (name == "force") return paper_force(point).x;
  if (name == "stiffness") return point.stiffness;
  std::istringstream words(name);
  std::string what;
  Eigen::Index link = 0;
  if (words >> what >> link && what == "theta" && link > 0 && link <= point.theta.size())
    return point.theta(link - 1);
  with.wrong("of '" + name + "'", "deflection, force, stiffness or theta 1");
}

/// Slopes of the force just before and just after a deflection, certified as means.
std::vector<Interval> slopes_next_to(const SlowPath& path, const Rational& at) {
  const Rational next(1, 1000000), wide(1, 100000);
  return {mean_stiffnesses(path, {Rational(at - wide), Rational(at - next)})[0],
          mean_stiffnesses(path, {Rational(at + next), Rational(at + wide)})[0]};
}

}  // namespace

Judgement generic::path(const Parameters& with, const Printed& printed, const Premises& given, int) {
  with.known({"chain", "links", "to", "from", "asks"});
  const Premise chain = chain_with_links(with, given);
  const SlowPath& path = held_chain(chain).compressed(last_deflection(with, given));
  const std::string asks = with.text("asks");
  const auto word = [&](const std::string& found) {
    Judgement judgement = judge_word(printed.at(0), found, "it is " + found, {path.evidence()});
    judgement.subject = in_words(chain);
    judgement.statement =
        fmt::format("has, slowly compressed up to {}, {}", with.text("to"), possession(asks, found));
    return judgement;
  };
  if (asks == "continuity") return word(path.continuity());
  if (asks == "smoothness") return word(smoothness(with, path));
  const auto falls = [](const Interval& a, const Interval& b) { return certainly_less(b, a); };
  const auto rises = [](const Interval& a, const Interval& b) { return certainly_less(a, b); };
  if (asks == "force")
    return word(proved_or_contradicted(with, path, given, path.stiff(), "increasing", falls, compressions));
  if (asks == "stiffness")
    return word(proved_or_contradicted(with, path, given, path.regular() && path.proved[0].softens,
                                       "decreasing", rises, mean_stiffnesses));
  if (asks == "minima of the stiffness") return word(std::to_string(path.softest()));
  if (asks == "signs") return word(all_signs(with, given, path));
  with.wrong("asks = '" + asks + "'",
             "continuity, smoothness, force, stiffness, minima of the stiffness or signs");
}

Judgement generic::event(const Parameters& with, const Printed& printed, const Premises& given, int digits) {
  with.known({"chain", "links", "to", "event", "joint", "between", "of"});
  const Premise chain = chain_with_links(with, given);
  const SlowPath& path = held_chain(chain).compressed(last_deflection(with, given));
  const BranchPoint<proofs::Located> point = place_of(with, given, path);
  const Printed of = with.list("of");
  std::vector<Interval> computed;
  std::string values;
  const proofs::Located doubt("1e-45");
  for (const std::string& name : of) {
    if (name == "slopes") {  // before and after
      for (const Interval& slope : slopes_next_to(path, proofs::exactly(point.load)))
        computed.push_back(slope);
      continue;
    }
    const proofs::Located number = of_point(with, point, name);
    computed.emplace_back(number - doubt, number + doubt);
    values += (values.empty() ? "" : "; ") + located(number, digits);
  }
  Printed names;
  for (const std::string& name : of)
    for (const char* const one : {" before", " after"})
      if (name == "slopes" || one == std::string(" before"))
        names.push_back(name == "slopes" ? "slope" + std::string(one) : name);
  Judgement result = judge_decimals(printed, computed, names, "");
  if (result.verdict == Verdict::confirmed)
    result.statement =
        fmt::format("has, slowly compressed, {} at {}", happening(with), named(names, printed));
  result.subject = in_words(chain);
  result.evidence = {{EvidenceKind::mp50, fmt::format("{}, located by Newton's method in 64 digits: {}",
                                                      with.text("event"), values)},
                     path.evidence()};
  result.value = values;
  return result;
}

}  // namespace plumbline::verify
