#include "app/certified_report.hpp"

#include <fmt/core.h>

namespace plumbline::app {

namespace {

constexpr int digits = 12;

std::string text(const proofs::CertifiedRun& run) {
  return fmt::format(
      "  load from {:.9g} to {:.9g}: {}\n", run.from, run.to,
      run.negative_directions == 0 ? "stable" : fmt::format("unstable ({})", run.negative_directions));
}

std::string_view title(const proofs::PathCertificate& one) {
  return !one.certified()   ? "proved in part"
         : one.gaps.empty() ? "one smooth branch"
                            : "smooth but for the gaps";
}

std::string stiffness_elsewhere(const proofs::PathCertificate& one) {
  std::string text = one.finite ? "" : "  the tangent stiffness is not finite all along: it has poles\n";
  if (!one.counted) return text + "  how many local minima the tangent stiffness has stays open\n";
  if (!one.softest.empty()) return text;
  return text + (one.softens ? "  the tangent stiffness falls all along\n"
                             : "  the tangent stiffness has no local minimum\n");
}

nlohmann::ordered_json pairs(const std::vector<proofs::Span>& loads) {
  auto list = nlohmann::ordered_json::array();
  for (const proofs::Span& load : loads) list.push_back({load.low, load.high});
  return list;
}

}  // namespace

CertifiedReport certify(const proofs::PathReport& report, const Chain<Interval>& chain,
                        const Loading<Interval>& loading, const std::vector<proofs::Symmetry>& symmetries) {
  CertifiedReport certified;
  for (const Branch<double>& branch : report.branches) {
    certified.push_back(proofs::certify(chain, loading, branch));
    certified.back().symmetric = !symmetries.empty();
  }
  for (std::size_t b = 0; report.history && b + 1 < certified.size(); ++b)
    proofs::join(certified[b], report.branches[b], certified[b + 1], chain, loading, symmetries);
  return certified;
}

bool complete(const CertifiedReport& report) {
  return std::all_of(report.begin(), report.end(),
                     [](const proofs::PathCertificate& one) { return one.certified(); });
}

std::string as_text(const CertifiedReport& report) {
  std::string all = "\nProved by interval arithmetic, the chain's numbers as exact decimals\n";
  for (std::size_t b = 0; b < report.size(); ++b) {
    const proofs::PathCertificate& one = report[b];
    all +=
        fmt::format("part {}: {} in {} segments; the points are within {:.1e} rad of it, the chords {:.1e}\n",
                    b + 1, title(one), one.segments, one.distance, one.tube);
    for (const proofs::CertifiedRun& run : one.runs) all += text(run);
    for (const proofs::Span& fold : one.folds) all += "  the load turns once in " + text(fold, digits) + "\n";
    for (const proofs::Span& least : one.softest)
      all += "  the tangent stiffness has one local minimum in " + text(least, digits) + "\n";
    if (one.certified()) all += stiffness_elsewhere(one);
    if (one.fork)
      all += fmt::format("  a symmetric pitchfork in {}: part {} goes on from it without a gap\n",
                         text(*one.fork, digits), b + 2);
    for (const proofs::Span& gap : one.gaps)
      all += fmt::format("  not covered, {}, across which the branch is not proved to be one: {}\n",
                         one.symmetric
                             ? "a bifurcation or nearly one"
                             : "a bifurcation unfolded, for the chain has no symmetry that makes one,\n"
                               "  or nearly one",
                         text(gap, digits));
    if (one.failed_at)
      all += fmt::format("  NOT proved from {} on: {}\n", text(*one.failed_at, digits), one.failure);
  }
  return all;
}

nlohmann::ordered_json as_json(const CertifiedReport& report) {
  auto list = nlohmann::ordered_json::array();
  for (const proofs::PathCertificate& one : report) {
    auto runs = nlohmann::ordered_json::array();
    for (const proofs::CertifiedRun& run : one.runs)
      runs.push_back({{"from", run.from}, {"to", run.to}, {"negative_directions", run.negative_directions}});
    nlohmann::ordered_json failure;
    if (one.failed_at)
      failure = {{"load", {one.failed_at->low, one.failed_at->high}}, {"reason", one.failure}};
    nlohmann::ordered_json fork;
    if (one.fork) fork = {one.fork->low, one.fork->high};
    list.push_back({{"certified", one.certified()},
                    {"segments", one.segments},
                    {"widest_tube", one.tube},
                    {"farthest_point", one.distance},
                    {"runs", runs},
                    {"folds", pairs(one.folds)},
                    {"finite_stiffness", one.finite},
                    {"least_stiffness", pairs(one.softest)},
                    {"least_stiffness_counted", one.certified() && one.counted},
                    {"gaps", pairs(one.gaps)},
                    {"pitchfork", fork},
                    {"failure", failure}});
  }
  return list;
}

}  // namespace plumbline::app
