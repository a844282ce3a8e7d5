#include "diagnose/draft/drafted_rest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <plumbline/base/error.hpp>

#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/rest_shape.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using Values = std::vector<double>;

/// Whether a load is next to nothing at the first reading.
bool begins_at_nothing(const Values& load) {
  constexpr double nothing = 0.03;  // of its most
  double most = 0;
  for (const double value : finite(load)) most = std::max(most, std::abs(value));
  return !std::isfinite(load.front()) || std::abs(load.front()) <= nothing * most + 3 * scatter_of(load);
}

class RestFinder {
 public:
  RestFinder(DraftedRun& run, const DraftModel& model, const Ask& ask)
      : run_(run),
        model_(model),
        ask_(ask),
        joints_(model.chain.link_length.size()),
        reach_(std::accumulate(model.chain.link_length.begin(), model.chain.link_length.end(), 0.0)) {}

  /// The unloaded shape: commanded angles, the model's, or that of a first reading without load.
  void find(const std::vector<DraftColumn>& commands) {
    if (!commands.empty()) {
      std::vector<std::string> titles;
      for (const DraftColumn& column : commands) {
        titles.push_back(run_.source.shown_title(column.place));
        run_.further.push_back(column.place);
        run_.rest.push_back(run_.values(column, quantity::angle).front());
      }
      say("rest", fmt::format("{:.4g}", fmt::join(run_.rest, ", ")),
          fmt::format("the commanded angles {}", fmt::join(titles, ", ")));
      return;
    }
    const Values& own = model_.chain.rest;
    constexpr double near = 0.02;
    if (!run_.angles.empty()) {
      Values first;
      double away = 0;
      for (std::size_t j = 0; j < joints_; ++j) {
        first.push_back(run_.values(run_.angles[j], quantity::angle).front());
        away = std::max(away, std::abs(first[j] - (j < own.size() ? own[j] : 0)));
      }
      if (!own.empty() && away < near) return;
      if (begins_unloaded())
        return set_rest(first, "the first reading, which is without load", own.empty() ? 0 : away);
      if (!own.empty() && run_.moved_by_actuators) {
        say("rest", "the model's", "the first reading is under load");
        return;
      }
    }
    const Values xs = run_.values(draft_x), ys = run_.values(draft_y);
    if (xs.empty() || ys.empty() || !std::isfinite(xs.front()) || !std::isfinite(ys.front()))
      return ask_rest("nothing in the table says it");
    const std::array<double, 2> end = end_point(model_.chain, own);
    const double gap = std::hypot(xs.front() - end[0], ys.front() - end[1]);
    if (!own.empty() && (gap < near * reach_ || !begins_unloaded())) return;
    const Values middle = own.empty() ? Values(joints_, 0.0) : own;
    if (const auto shape = reaching(model_.chain, middle, {xs.front(), ys.front()}))
      return set_rest(*shape, "the shape that has the end point where the first reading has it",
                      own.empty() && joints_ > 1 ? NAN : gap / reach_);  // there are others
    ask_rest(fmt::format(
        "the model's puts the end point {:.3g} m from the first reading, which is without load", gap));
  }

 private:
  std::optional<std::string> say(const std::string& what, const std::string& value, const std::string& reason,
                                 bool doubtful = false, const std::string& line = "") {
    return say_guess(run_, ask_, {what + " of " + run_.source.name(), value, reason, doubtful, line});
  }

  [[nodiscard]] bool begins_unloaded() const {
    std::vector<DraftColumn> loads;
    for (const std::size_t c : {draft_Fx, draft_Fy})
      if (const auto& column = run_.singles[c]; column && !column->constant) loads.push_back(*column);
    if (run_.moved_by_actuators)
      for (const DraftedActuator& one : run_.actuators) loads.push_back(one.column);
    return std::all_of(loads.begin(), loads.end(), [&](const DraftColumn& load) {
      return begins_at_nothing(run_.source.numbers(load.place));
    });
  }

  void set_rest(const Values& rest, const std::string& reason, double away) {
    constexpr double large = 0.3;
    run_.rest = rest;
    const auto answer = say("rest", fmt::format("{:.4g} rad", fmt::join(rest, ", ")), reason, !(away < large),
                            fmt::format("rest = [{:.4g}] in its [[run]], in rad", fmt::join(rest, ", ")));
    if (answer) take_rest(*answer);
  }
  void ask_rest(const std::string& reason) {
    const auto answer = say("rest", model_.chain.rest.empty() ? "not known" : "the model's", reason, true);
    if (answer) return take_rest(*answer);
    run_.question = fmt::format(
        "rest of {}: found {}, expected rest = [...], the {} unloaded joint angles, in its [[run]]",
        run_.source.name(), reason, joints_);
  }
  void take_rest(const std::string& answer) {
    const auto values = numbers_in(answer);
    if (!values || values->size() != joints_)
      throw Error("rest of " + run_.source.name(), files::shown(answer),
                  fmt::format("{} angles in rad", joints_));
    run_.rest = *values;
  }

  DraftedRun& run_;
  const DraftModel& model_;
  const Ask& ask_;
  std::size_t joints_;
  double reach_;
};

}  // namespace

void find_rest(DraftedRun& run, const DraftModel& model, const Ask& ask,
               const std::vector<DraftColumn>& commands) {
  RestFinder(run, model, ask).find(commands);
}

}  // namespace plumbline::diagnose
