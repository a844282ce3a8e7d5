#include "diagnose/change/motion_change_report.hpp"

#include <fmt/format.h>

#include "diagnose/change/change_report.hpp"
#include "diagnose/motion/report.hpp"

namespace plumbline::diagnose {
namespace {

std::string answer_of(const MotionChange& change) {
  switch (change.diagnosis.verdict) {
    case CauseVerdict::none:
      return "No change: the two differ by noise\n";
    case CauseVerdict::unknown:
      return "Changed, by a cause outside the catalogue\n";
    case CauseVerdict::identified:
    case CauseVerdict::ambiguous:
    case CauseVerdict::partial:
      break;
  }
  return fmt::format("Changed{}\n", senses(change.sense));
}

std::string compared_log(const PairedLog& one) {
  if (one.reference.empty())
    return fmt::format("  {}: no log of the other state has these commands at this rate; repeat it there\n",
                       one.log);
  std::string text = fmt::format("  {}, against {}", one.log, one.reference);
  if (one.offset != 0) text += fmt::format("; its clock stands {:.3g} s apart", one.offset);
  return text + "\n";
}

}  // namespace

std::string as_text(const MotionChange& change) {
  std::string text = fmt::format("{} against {}\n\n{}\nCompared under the same commands\n", change.after,
                                 change.before, answer_of(change));
  for (const PairedLog& one : change.relative.logs) text += compared_log(one);
  if (!change.relative.cancels)
    text += "  None has: all are compared, and what the model lacks counts as noise\n";
  text += fmt::format("\nBelow, the model is the drive as it was {}, and the gap is the change.\n\n",
                      change.sense == Sense::removed ? "after" : "before");
  return text + motion::as_text(change.diagnosis);
}

nlohmann::ordered_json as_json(const MotionChange& change) {
  nlohmann::ordered_json report = motion::as_json(change.diagnosis), logs = nlohmann::ordered_json::array();
  for (const PairedLog& one : change.relative.logs)
    logs.push_back({{"log", one.log}, {"reference", one.reference}, {"offset", one.offset}});
  report["against"] = {{"before", change.before},
                       {"after", change.after},
                       {"check", check_word(check(change))},
                       {"sense", sense_word(change.sense)},
                       {"cancels", change.relative.cancels},
                       {"logs", logs}};
  return report;
}

}  // namespace plumbline::diagnose
