#include "app/certified_report.hpp"

#include <fmt/format.h>

#include <set>

namespace plumbline::app {

namespace {

constexpr int shown_digits = 12;

std::string text(const proofs::CertifiedRun& run, const char* of) {
  return fmt::format(
      "  {} from {:.9g} to {:.9g}: {}\n", of, run.from, run.to,
      run.negative_directions == 0 ? "stable" : fmt::format("unstable ({})", run.negative_directions));
}

template <class Certificate>
std::string_view title(const Certificate& one) {
  return !one.certified()   ? "proved in part"
         : one.gaps.empty() ? "one smooth branch"
                            : "smooth but for the gaps";
}

std::string stiffness_elsewhere(const proofs::PathCertificate& one) {
  std::string text =
      one.finite ? "" : "  the tangent stiffness is not proved finite all along: it may have poles\n";
  if (!one.counted) return text + "  how many local minima the tangent stiffness has stays open\n";
  if (!one.softest.empty()) return text;
  return text + (one.softens ? "  the tangent stiffness falls all along\n"
                             : "  the tangent stiffness has no local minimum\n");
}

nlohmann::ordered_json pair(const proofs::Span& loads) {
  return {loads.low, loads.high};
}

nlohmann::ordered_json pairs(const std::vector<proofs::Span>& loads) {
  auto list = nlohmann::ordered_json::array();
  for (const proofs::Span& load : loads) list.push_back(pair(load));
  return list;
}

nlohmann::ordered_json to_json(const std::vector<proofs::CertifiedRun>& runs) {
  auto list = nlohmann::ordered_json::array();
  for (const proofs::CertifiedRun& run : runs)
    list.push_back({{"from", run.from}, {"to", run.to}, {"negative_directions", run.negative_directions}});
  return list;
}

/// The parts of the path that a fork joins to one of them.
std::set<std::size_t> joined(const proofs::ProvedFork& fork) {
  std::set<std::size_t> parts;
  for (const auto* ends : {&fork.symmetric, &fork.bent}) {
    for (const proofs::EndOfPiece& end : *ends) parts.insert(end.branch + 1);
  }
  return parts;
}

/// The first line of a part's certificate.
template <class Certificate>
std::string head(std::size_t part, const Certificate& of) {
  return fmt::format(
      "part {}: {} in {} segments; the points are within {:.1e} rad of it, the chords {:.1e}\n", part,
      title(of), of.segments, of.distance, of.tube);
}

/// Its last line, where it failed.
template <class Certificate>
std::string failure(const Certificate& of) {
  if (!of.failed_at) return "";
  return fmt::format("  NOT proved from {} on: {}\n", text(*of.failed_at, shown_digits), of.failure);
}

}  // namespace

bool complete(const proofs::JoinedBranches& proved) {
  return std::all_of(proved.branches.begin(), proved.branches.end(),
                     [](const proofs::PathCertificate& one) { return one.certified(); });
}

std::string as_text(const proofs::JoinedBranches& proved) {
  std::string all = "\nProved by interval arithmetic, the chain's numbers as exact decimals\n";
  for (std::size_t b = 0; b < proved.branches.size(); ++b) {
    const proofs::PathCertificate& one = proved.branches[b];
    all += head(b + 1, one);
    for (const proofs::CertifiedRun& run : one.runs) all += text(run, "load");
    for (const proofs::Span& fold : one.folds)
      all += "  the load turns once in " + text(fold, shown_digits) + "\n";
    for (const proofs::Span& least : one.softest)
      all += "  the tangent stiffness has one local minimum in " + text(least, shown_digits) + "\n";
    if (one.certified()) all += stiffness_elsewhere(one);
    for (const proofs::Gap& gap : one.gaps)
      all += fmt::format("  not covered, {}, {}\n",
                         gap.unfolded ? "a bifurcation unfolded (it is proved that none is there)"
                                      : "a bifurcation or nearly one (not decided)",
                         text(gap.loads, shown_digits));
    all += failure(one);
  }
  for (const proofs::ProvedFork& fork : proved.forks)
    all +=
        fmt::format("a symmetric pitchfork in {}: part{} {} without a gap\n", text(fork.load, shown_digits),
                    joined(fork).size() == 1 ? "" : "s", fmt::join(joined(fork), " and "));
  return all;
}

nlohmann::ordered_json as_json(const proofs::JoinedBranches& proved) {
  auto list = nlohmann::ordered_json::array();
  for (std::size_t b = 0; b < proved.branches.size(); ++b) {
    const proofs::PathCertificate& one = proved.branches[b];
    auto gaps = nlohmann::ordered_json::array(), forks = gaps;
    for (const proofs::Gap& gap : one.gaps)
      gaps.push_back({{"load", pair(gap.loads)}, {"unfolded", gap.unfolded}});
    for (const proofs::ProvedFork& fork : proved.forks) {
      if (joined(fork).count(b + 1) > 0) forks.push_back(pair(fork.load));
    }
    nlohmann::ordered_json failure;
    if (one.failed_at) failure = {{"load", pair(*one.failed_at)}, {"reason", one.failure}};
    list.push_back({{"certified", one.certified()},
                    {"segments", one.segments},
                    {"widest_tube", one.tube},
                    {"farthest_point", one.distance},
                    {"runs", to_json(one.runs)},
                    {"folds", pairs(one.folds)},
                    {"finite_stiffness", one.finite},
                    {"least_stiffness", pairs(one.softest)},
                    {"least_stiffness_counted", one.certified() && one.counted},
                    {"gaps", gaps},
                    {"pitchforks", forks},
                    {"failure", failure}});
  }
  return list;
}

std::string as_text(const std::vector<proofs::StructureCertificate>& proved) {
  std::string all = "\nProved by interval arithmetic, the chain's numbers as exact decimals\n";
  for (std::size_t b = 0; b < proved.size(); ++b) {
    const proofs::StructureCertificate& one = proved[b];
    all += head(b + 1, one);
    for (const proofs::CertifiedRun& run : one.runs) all += text(run, "factor");
    for (const proofs::Span& fold : one.folds)
      all += "  the factor turns once in " + text(fold, shown_digits) + "\n";
    for (const proofs::Span& gap : one.gaps)
      all += "  not covered, a bifurcation or nearly one (not decided), " + text(gap, shown_digits) + "\n";
    all += failure(one);
  }
  return all;
}

nlohmann::ordered_json as_json(const std::vector<proofs::StructureCertificate>& proved) {
  auto list = nlohmann::ordered_json::array();
  for (const proofs::StructureCertificate& one : proved) {
    nlohmann::ordered_json failure;
    if (one.failed_at) failure = {{"factor", pair(*one.failed_at)}, {"reason", one.failure}};
    list.push_back({{"certified", one.certified()},
                    {"segments", one.segments},
                    {"widest_tube", one.tube},
                    {"farthest_point", one.distance},
                    {"runs", to_json(one.runs)},
                    {"folds", pairs(one.folds)},
                    {"gaps", pairs(one.gaps)},
                    {"failure", failure}});
  }
  return list;
}

}  // namespace plumbline::app
