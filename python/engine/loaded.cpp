#include <nlohmann/json.hpp>
#include <optional>

#include "proofs/census/found_equilibria.hpp"
#include "proofs/certificates/equilibria_certificate.hpp"
#include "proofs/certificates/path_certificate.hpp"
#include "proofs/exact/certain_digits.hpp"
#include "proofs/exact/decimal.hpp"
#include "proofs/paths/path_load.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

py::dict in_columns(const std::vector<const BranchPoint<double>*>& points, std::size_t links) {
  std::vector<double> load, energy, stiffness;
  std::vector<std::array<double, 2>> end_point, force;
  std::vector<std::vector<double>> q;
  std::vector<std::int64_t> negative;
  for (const BranchPoint<double>* p : points) {
    load.push_back(p->load), energy.push_back(p->energy), stiffness.push_back(p->stiffness);
    end_point.push_back({p->end_point.x, p->end_point.y}), force.push_back({p->force.x, p->force.y});
    q.push_back(joint_angles(p->theta));
    negative.push_back(static_cast<std::int64_t>(p->negative_directions));
  }
  py::dict all;
  all["load"] = array_of(load), all["energy"] = array_of(energy), all["stiffness"] = array_of(stiffness);
  all["end_point"] = table_of(end_point, 2), all["force"] = table_of(force, 2);
  all["q"] = table_of(q, links);
  all["negative_directions"] = py::array_t<std::int64_t>(negative.size(), negative.data());
  return all;
}

py::dict as_dict(const Branch<double>& branch) {
  std::vector<const BranchPoint<double>*> points, events;
  std::vector<std::string> kinds;
  std::vector<std::size_t> before;
  for (const auto& point : branch.points) points.push_back(&point);
  for (const auto& event : branch.events) {
    events.push_back(&event.point);
    kinds.emplace_back(name(event.kind));
    before.push_back(event.before);
  }
  const auto links = static_cast<std::size_t>(branch.points.front().theta.size());
  py::dict all = in_columns(points, links);
  all["events"] = in_columns(events, links), all["event_kinds"] = kinds, all["event_behind"] = before;
  all["end"] = std::string(proofs::name(branch.end));
  return all;
}

std::vector<std::pair<double, double>> ends(const std::vector<proofs::Span>& spans) {
  std::vector<std::pair<double, double>> all;
  for (const proofs::Span& span : spans) all.emplace_back(span.low, span.high);
  return all;
}

py::dict as_dict(const proofs::PathCertificate& proved) {
  std::vector<std::tuple<double, double, std::size_t>> runs;
  for (const auto& run : proved.runs) runs.emplace_back(run.from, run.to, run.negative_directions);
  std::vector<proofs::Span> gaps;
  for (const proofs::Gap& gap : proved.gaps) gaps.push_back(gap.loads);
  py::dict all;
  all["certified"] = proved.certified(), all["segments"] = proved.segments, all["runs"] = runs;
  all["folds"] = ends(proved.folds), all["gaps"] = ends(gaps);
  all["failure"] = proved.certified() ? py::object(py::none()) : py::str(proved.failure);
  return all;
}

/// A path and, on request, what is proved of it.
struct Path {
  proofs::PathReport report;
  std::optional<proofs::JoinedBranches> proved;
  std::string certificate;
};

struct PathQuestion {
  Decimals lengths, stiffness, rest;
  bool held;  ///< the end point is moved; else a force grows
  std::pair<double, double> by;
  bool slowly;  ///< what a slowly loaded chain does; else every branch
  int side;
  double step;
  bool certify;
  std::string command;  ///< of a certificate; empty where none is wanted
};

Path answer(const PathQuestion& asked) {
  const Chain<Rational> chain = exact_chain(asked.lengths, asked.stiffness, asked.rest);
  const proofs::PathLoad load{asked.held ? Control::end_point : Control::force,
                              {asked.by.first, asked.by.second}};
  const proofs::PathTask task = proofs::path_task(chain, load, asked.step, asked.side);
  Path path{asked.slowly ? proofs::follow_slowly(task) : proofs::follow_all(task), {}, ""};
  const bool written = !asked.command.empty();
  if (asked.certify || written)
    path.proved =
        proofs::certify(path.report, chain, load,
                        written ? proofs::ProvedPoints::rounded : proofs::ProvedPoints::as_followed);
  if (written)
    path.certificate = certificate_text(
        proofs::path_certificates, asked.command,
        proofs::path_certificate({"chain", chain, false, load.control, load.direction()}, *path.proved));
  return path;
}

py::dict path(const PathQuestion& asked) {
  const Path found = unlocked([&] { return answer(asked); });
  py::list branches, proofs;
  for (const Branch<double>& branch : found.report.branches) branches.append(as_dict(branch));
  if (found.proved)
    for (const proofs::PathCertificate& one : found.proved->branches) proofs.append(as_dict(one));
  const Point<double>& along = found.report.loading.direction;
  py::dict all;
  all["branches"] = branches, all["proofs"] = proofs, all["warnings"] = found.report.warnings;
  all["certificate"] = found.certificate, all["direction"] = py::make_tuple(along.x, along.y);
  return all;
}

struct EquilibriaQuestion {
  Decimals lengths, stiffness, rest;
  std::string given;  ///< "deflection", "end_point" or "force"
  std::pair<std::string, std::string> load;
  int turns;
  bool certify;
  int digits;
  std::string command;  ///< of a certificate; empty where none is wanted
};

proofs::CensusTask task_of(const EquilibriaQuestion& asked) {
  const Chain<Rational> load = exact_chain({"1", "1"}, {"1", "1"}, {asked.load.first, asked.load.second});
  return {"chain",
          exact_chain(asked.lengths, asked.stiffness, asked.rest),
          false,
          asked.given == "force"       ? proofs::Given::force
          : asked.given == "end_point" ? proofs::Given::end_point
                                       : proofs::Given::deflection,
          {load.rest()[0], load.rest()[1]},
          asked.turns};
}

/// Equilibria as columns of decimals.
struct Columns {
  std::vector<Decimals> q, end_point, force;
  Decimals energy;
  std::vector<int> negative;  ///< -1 where it is open

  [[nodiscard]] py::dict as_dict() const {
    py::dict all;
    all["q"] = q, all["end_point"] = end_point, all["force"] = force, all["energy"] = energy;
    all["negative_directions"] = negative;
    return all;
  }
};

struct Listed {
  Columns columns;
  proofs::Window window;
  bool complete = false;
  std::size_t undecided = 0;
  std::string certificate;
};

Listed proved(const EquilibriaQuestion& asked) {
  const proofs::CensusTask task = task_of(asked);
  const proofs::Census census = proofs::take_census(task);
  const auto text = [&](const Interval& x) { return proofs::certain_digits(x, asked.digits); };
  Listed all{{}, census.window, census.complete(), census.undecided.size(), ""};
  for (const proofs::CertifiedEquilibrium& one : census.equilibria) {
    Decimals q;
    for (const Interval& angle : one.q) q.push_back(text(angle));
    all.columns.q.push_back(q);
    all.columns.end_point.push_back({text(one.x), text(one.y)});
    all.columns.force.push_back({text(one.fx), text(one.fy)});
    all.columns.energy.push_back(text(one.energy));
    all.columns.negative.push_back(one.negative_directions ? static_cast<int>(*one.negative_directions) : -1);
  }
  constexpr int certificate_digits = 40;
  if (!asked.command.empty())
    all.certificate = certificate_text(proofs::equilibria_certificates, asked.command,
                                       proofs::equilibria_certificate(task, census, certificate_digits));
  return all;
}

Listed found(const EquilibriaQuestion& asked) {
  const proofs::FoundEquilibria all = proofs::find_equilibria(task_of(asked));
  constexpr int digits = 17;  // tell a double from its neighbours
  Listed list{{}, all.window, false, 0, ""};
  for (const proofs::FoundEquilibrium& one : all.equilibria) {
    Decimals q;
    for (const double angle : one.q) q.push_back(Interval::End(angle).str(digits));
    list.columns.q.push_back(q);
    list.columns.end_point.push_back({one.x.str(digits), one.y.str(digits)});
    list.columns.force.push_back({one.fx.str(digits), one.fy.str(digits)});
    list.columns.energy.push_back(one.energy.str(digits));
    list.columns.negative.push_back(static_cast<int>(one.negative_directions));
  }
  return list;
}

py::dict equilibria(const EquilibriaQuestion& asked) {
  const bool certify = asked.certify || !asked.command.empty();
  const Listed list = unlocked([&] { return certify ? proved(asked) : found(asked); });
  std::vector<std::pair<double, double>> window;
  for (const Interval& angle : list.window) {
    const proofs::Span range(angle);
    window.emplace_back(range.low, range.high);
  }
  py::dict all = list.columns.as_dict();
  all["window"] = window, all["complete"] = list.complete, all["undecided"] = list.undecided;
  all["certificate"] = list.certificate;
  return all;
}

}  // namespace

void add_loaded(py::module_& module) {
  using namespace py::literals;
  module.def(
      "path",
      [](Decimals lengths, Decimals stiffness, Decimals rest, bool held, std::pair<double, double> by,
         bool slowly, int side, double step, bool certify, std::string command) {
        return path({std::move(lengths), std::move(stiffness), std::move(rest), held, by, slowly, side, step,
                     certify, std::move(command)});
      },
      "lengths"_a, "stiffness"_a, "rest"_a, py::kw_only(), "held"_a, "by"_a, "slowly"_a, "side"_a, "step"_a,
      "certify"_a, "command"_a);
  module.def(
      "equilibria",
      [](Decimals lengths, Decimals stiffness, Decimals rest, std::string given,
         std::pair<std::string, std::string> load, int turns, bool certify, int digits, std::string command) {
        return equilibria({std::move(lengths), std::move(stiffness), std::move(rest), std::move(given),
                           std::move(load), turns, certify, digits, std::move(command)});
      },
      "lengths"_a, "stiffness"_a, "rest"_a, py::kw_only(), "given"_a, "load"_a, "turns"_a, "certify"_a,
      "digits"_a, "command"_a);
}

}  // namespace plumbline::python
