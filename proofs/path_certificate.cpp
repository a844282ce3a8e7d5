#include "proofs/path_certificate.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "proofs/decimal.hpp"

namespace plumbline::proofs {
namespace {

using nlohmann::json;

/// The shortest decimal that is read as this double.
std::string text(double x) {
  return fmt::format("{}", x);
}

json exact_list(const std::vector<Rational>& values) {
  json list = json::array();
  for (const Rational& x : values) list.push_back(to_exact(x));
  return list;
}

json stated(const BranchPoint<double>& point, bool held) {
  json list = json::array();
  for (const double angle : point.theta) list.push_back(text(angle));
  if (held) list.push_back(text(point.force.x)), list.push_back(text(point.force.y));
  list.push_back(text(point.load));
  return list;
}

/// Loads around a fold, wide enough for other roundings than ours.
json bounds(const Span& fold) {
  const double room = 1e-9 * fold.magnitude() + 0.1 * fold.width();
  return {text(fold.low - room), text(fold.high + room)};
}

json stated(const ProvedPiece& piece, bool held) {
  json points = json::array(), runs = json::array(), folds = json::array();
  for (const BranchPoint<double>& point : piece.points) points.push_back(stated(point, held));
  for (const CertifiedRun& run : piece.runs)
    runs.push_back({run.from < run.to ? 1 : -1, run.negative_directions});
  for (const Span& fold : piece.folds) folds.push_back(bounds(fold));
  return {{"points", points}, {"runs", runs}, {"folds", folds}, {"near", text(piece.distance * 2 + 1e-12)}};
}

}  // namespace

json path_certificate(const PathGiven& given, const std::vector<PathCertificate>& branches) {
  json parts = json::array();
  for (const PathCertificate& branch : branches) {
    if (!branch.certified()) throw Error("certificate", branch.failure, "a path that is proved");
    for (const ProvedPiece& piece : branch.pieces)
      parts.push_back(stated(piece, given.control == Control::end_point));
  }
  return {{"case", given.name},
          {"lengths", exact_list(given.chain.length())},
          {"stiffness", exact_list(given.chain.stiffness())},
          {"rest", exact_list(given.chain.rest())},
          {"rest_unit", given.rest_in_pi ? "pi" : "rad"},
          {"control", given.control == Control::end_point ? "end_point" : "force"},
          {"direction", exact_list({given.direction.x, given.direction.y})},
          {"parts", parts}};
}

}  // namespace plumbline::proofs
