#include "diagnose/motion/balance/balance_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace plumbline::motion {

std::string as_text(const Balance& balance) {
  std::string text = fmt::format("{}\n\nWhich inertias and frictions?  Of {} logs with {} readings\n",
                                 balance.name, balance.logs, balance.readings);
  for (const BalanceNumber& one : balance.numbers)
    text += fmt::format("  {} = {:.4g} {} (95 %: {:.4g} to {:.4g}); the model has {:.4g}\n", one.name,
                        one.value, one.unit, one.low, one.high, one.stated);
  if (balance.lead != 0)
    text += fmt::format("  the torque is {:.0f} ms {} the motion\n", 1e3 * std::abs(balance.lead),
                        balance.lead > 0 ? "ahead of" : "behind");
  text += "\nHow much torque is left?  By joint, N m, root mean square\n";
  for (const TorqueLeft& one : balance.left)
    text += fmt::format("  {}{}: {:.3g} in all, {:.3g} less the model's, {:.3g} less what was found\n",
                        one.log, one.held_out ? " (held out)" : "", fmt::join(one.whole, " "),
                        fmt::join(one.stated, " "), fmt::join(one.found, " "));
  return text;
}

nlohmann::ordered_json as_json(const Balance& balance) {
  nlohmann::ordered_json json{{"format", "torque-report/1"},
                              {"name", balance.name},
                              {"lead", balance.lead},
                              {"numbers", nlohmann::ordered_json::array()},
                              {"left", nlohmann::ordered_json::array()}};
  for (const BalanceNumber& one : balance.numbers)
    json["numbers"].push_back({{"name", one.name},
                               {"unit", one.unit},
                               {"value", one.value},
                               {"interval_95", {one.low, one.high}},
                               {"stated", one.stated}});
  for (const TorqueLeft& one : balance.left)
    json["left"].push_back({{"log", one.log},
                            {"held_out", one.held_out},
                            {"whole", one.whole},
                            {"stated", one.stated},
                            {"found", one.found}});
  return json;
}

}  // namespace plumbline::motion
