#include "app/located_report.hpp"

#include <fmt/core.h>

#include "app/path_report.hpp"

namespace plumbline::app {

LocatedReport locate(const proofs::PathReport& report, const Chain<Rational>& chain,
                     const Loading<proofs::Located>& loading) {
  LocatedReport located;
  for (const Branch<double>& branch : report.branches)
    located.push_back(proofs::locate_events(from_rational<proofs::Located>(chain), loading, branch));
  return located;
}

std::string as_text(const LocatedReport& report, int digits) {
  std::string text = fmt::format("\nEvents to {} digits\n", digits);
  for (std::size_t b = 0; b < report.size(); ++b) {
    for (const auto& event : report[b]) {
      text += fmt::format("{} on part {}\n  load  {}\n  force {}, {}\n  q    ", name(event.kind), b + 1,
                          event.point.load.str(digits), event.point.force.x.str(digits),
                          event.point.force.y.str(digits));
      for (const proofs::Located& q : joint_angles(event.point.theta)) text += " " + q.str(digits);
      text += "\n";
    }
  }
  return text;
}

nlohmann::ordered_json as_json(const LocatedReport& report, int digits) {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (std::size_t b = 0; b < report.size(); ++b) {
    for (const auto& event : report[b]) {
      std::vector<std::string> q;
      for (const proofs::Located& angle : joint_angles(event.point.theta)) q.push_back(angle.str(digits));
      events.push_back({{"kind", name(event.kind)},
                        {"part", b + 1},
                        {"load", event.point.load.str(digits)},
                        {"force", {event.point.force.x.str(digits), event.point.force.y.str(digits)}},
                        {"energy", event.point.energy.str(digits)},
                        {"q", q}});
    }
  }
  return events;
}

}  // namespace plumbline::app
