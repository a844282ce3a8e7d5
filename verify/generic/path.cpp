/// \file
/// Slowly compressed chains: what is proved of their whole paths, and where something happens.

#include <fmt/core.h>
#include <fmt/ranges.h>

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

std::string all_signs(const Parameters& with, const Premises& given, const SlowPath& path) {
  const Rational from = exact_quantity(with.text("from", "0"), given),
                 to = exact_quantity(with.text("to"), given);
  const std::string found = signs(states(path, {to}).front());
  const bool always = path.everywhere(from, to, [&](const auto& one) { return signs(one) == found; });
  return always ? found : "changing";
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
  const SlowPath& path = held_chain(chain_with_links(with, given)).compressed(last_deflection(with, given));
  const std::string asks = with.text("asks");
  const auto word = [&](const std::string& found) {
    return judge_word(printed.at(0), found, "it is " + found, {path.evidence()});
  };
  if (asks == "continuity") return word(path.continuity());
  if (asks == "smoothness") return word(path.regular() ? "smooth" : "not smooth");
  if (asks == "force") return word(path.stiff() ? "increasing" : "not increasing");
  if (asks == "stiffness")
    return word(path.regular() && path.proved[0].softens ? "decreasing" : "not decreasing");
  if (asks == "minima of the stiffness") return word(std::to_string(path.softest()));
  if (asks == "signs") return word(all_signs(with, given, path));
  with.wrong("asks = '" + asks + "'",
             "continuity, smoothness, force, stiffness, minima of the stiffness or signs");
}

Judgement generic::event(const Parameters& with, const Printed& printed, const Premises& given, int digits) {
  with.known({"chain", "links", "to", "event", "joint", "between", "of"});
  const SlowPath& path = held_chain(chain_with_links(with, given)).compressed(last_deflection(with, given));
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
  Printed names = of;
  names.resize(computed.size(), "slope after");
  Judgement result = judge_decimals(printed, computed, names, "");
  result.evidence = {{EvidenceKind::mp50, fmt::format("{}, located by Newton's method in 64 digits: {}",
                                                      with.text("event"), values)},
                     path.evidence()};
  result.value = values;
  return result;
}

}  // namespace plumbline::verify
