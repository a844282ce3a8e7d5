#include <fmt/format.h>

#include <algorithm>

#include "diagnose/bench/end_kind.hpp"
#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

namespace {

/// The first or the second of the channels of an end.
SingleChannel single(const std::vector<Channel>& channels, std::size_t place) {
  const std::string_view unit = channels.front().unit();
  const Quantity& quantity = unit == "m"     ? quantity::length
                             : unit == "rad" ? quantity::angle
                             : unit == "N"   ? quantity::force
                                             : quantity::torque;
  return {place < channels.size() ? channels[place].label() : "", &quantity};
}

}  // namespace

const std::array<SingleChannel, draft_singles>& single_channels(Device device) {
  using Channels = std::array<SingleChannel, draft_singles>;
  const auto of = [](Device one) {
    const EndKind& end = end_kind(one);
    return Channels{{{"t", &quantity::time},
                     single(end.place, 0),
                     single(end.place, 1),
                     single(end.load, 0),
                     single(end.load, 1)}};
  };
  static const std::array all{of(Device::chain), of(Device::turning_joint), of(Device::sliding_joint)};
  return all[static_cast<std::size_t>(device)];
}

std::vector<double> DraftedRun::values(const DraftColumn& column, const Quantity& quantity) const {
  if (column.constant) return std::vector<double>(source.readings(), *column.constant);
  const double unit = column.unit.empty() ? 1 : parse_unit(column.unit, quantity, "").in_si();
  std::vector<double> all = source.numbers(column.place);
  for (double& value : all) value = column.sign * (value - column.zero) * unit;
  return all;
}

std::vector<double> DraftedRun::values(std::size_t single) const {
  if (!singles[single]) return {};
  return values(*singles[single], *single_channels(device)[single].quantity);
}

bool DraftedRun::uses(std::size_t column) const {
  const auto is = [column](const DraftColumn& one) { return !one.constant && one.place == column; };
  return std::any_of(singles.begin(), singles.end(), [&](const auto& one) { return one && is(*one); }) ||
         std::any_of(angles.begin(), angles.end(), is) || std::any_of(commands.begin(), commands.end(), is) ||
         std::any_of(covariates.begin(), covariates.end(), [&](const auto& one) { return is(one.second); }) ||
         std::any_of(actuators.begin(), actuators.end(), [&](const auto& one) { return is(one.column); }) ||
         std::find(further.begin(), further.end(), column) != further.end();
}

std::optional<std::string> say_guess(DraftedRun& run, const Ask& ask, Guess guess) {
  std::optional<std::string> answer;
  if (guess.doubtful && ask) answer = ask(guess);
  if (answer) guess = {guess.what, *answer, "as you said"};
  run.guesses.push_back(std::move(guess));
  return answer;
}

std::string line_of_control(const std::string& other) {
  return fmt::format("control = \"{}\" in its [[run]] where that is imposed", other);
}

EvenSteps even_steps(double of_place, double of_load, const char* places, const char* loads) {
  constexpr double clearly = 2, even = 0.002;  // where both go evenly, either may count as put
  const bool load = of_load < of_place;
  const double more = std::max(of_place, of_load);
  return {
      load, more > clearly * std::min(of_place, of_load) || more < even,
      fmt::format("from reading to reading the {} go more evenly than the {} ({:.2g} % against {:.2g} % of "
                  "their range)",
                  load ? loads : places, load ? places : loads, 100 * std::min(of_place, of_load),
                  100 * std::max(of_place, of_load))};
}

}  // namespace plumbline::diagnose
