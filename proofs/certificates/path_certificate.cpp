#include "proofs/certificates/path_certificate.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_list.hpp"
#include "proofs/paths/measures.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

/// Nine decimals, rounded as it is told.
std::string decimal(double x, double (*round)(double)) {
  const std::string text = fmt::format("{:.9f}", round(x * 1e9) / 1e9);
  const std::size_t last = text.find_last_not_of('0');
  const std::string short_text = text.substr(0, text[last] == '.' ? last : last + 1);
  return short_text == "-0" ? "0" : short_text;
}

json stated(const Vector<double>& point) {
  json list = json::array();
  for (const double x : point) list.push_back(decimal(x, std::round));
  return list;
}

/// Loads around a fold or a pitchfork, wide enough for other roundings than ours.
json bounds(const Span& fold) {
  const double room = 1e-9 * fold.magnitude() + 0.1 * fold.width();
  return {decimal(fold.low - room, std::floor), decimal(fold.high + room, std::ceil)};
}

json stated(const ProvedPiece& piece) {
  json points = json::array(), runs = json::array(), folds = json::array();
  for (const Vector<double>& point : piece.points) points.push_back(stated(point));
  for (const CertifiedRun& run : piece.runs)
    runs.push_back({run.from < run.to ? 1 : -1, run.negative_directions});
  for (const Span& fold : piece.folds) folds.push_back(bounds(fold));
  return {{"points", points},
          {"runs", runs},
          {"folds", folds},
          {"near", decimal(2 * piece.distance + 2e-9, std::ceil)}};
}

/// Ends of parts, which are counted over all branches.
json stated(const std::vector<EndOfPiece>& ends, const std::vector<PathCertificate>& branches) {
  json list = json::array();
  for (const EndOfPiece& end : ends) {
    std::size_t part = end.piece + 1;
    for (std::size_t b = 0; b < end.branch; ++b) part += branches[b].pieces.size();
    list.push_back({part, end.last ? "last" : "first"});
  }
  return list;
}

const char* name(const Symmetry& symmetry) {
  if (!symmetry.reversed) return "mirrored";
  return symmetry.mirrored ? "reversed and mirrored" : "reversed";
}

json stated(const ProvedFork& fork, const std::vector<PathCertificate>& branches, const Span& unit) {
  return {{"symmetry", name(fork.symmetry)},
          {"load", bounds(fork.load / unit)},
          {"symmetric", stated(fork.symmetric, branches)},
          {"bent", stated(fork.bent, branches)}};
}

}  // namespace

json path_certificate(const PathGiven& given, const JoinedBranches& proved) {
  json parts = json::array(), forks = json::array();
  for (const PathCertificate& branch : proved.branches) {
    if (!branch.certified()) throw Error("certificate", branch.failure, "a path that is proved");
    for (const ProvedPiece& piece : branch.pieces) parts.push_back(stated(piece));
  }
  const Span unit(load_unit(from_rational<Interval>(given.chain), given.control));
  for (const ProvedFork& fork : proved.forks) forks.push_back(stated(fork, proved.branches, unit));
  return {{"case", given.name},
          {"lengths", exact_list(given.chain.length())},
          {"stiffness", exact_list(given.chain.stiffness())},
          {"rest", exact_list(given.chain.rest())},
          {"rest_unit", given.rest_in_pi ? "pi" : "rad"},
          {"control", given.control == Control::end_point ? "end_point" : "force"},
          {"direction", exact_list({given.direction.x, given.direction.y})},
          {"parts", parts},
          {"pitchforks", forks}};
}

}  // namespace plumbline::proofs
