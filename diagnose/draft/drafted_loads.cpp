#include "diagnose/draft/drafted_loads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <plumbline/base/error.hpp>

#include "diagnose/bench/unit.hpp"
#include "diagnose/draft/column_numbers.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

constexpr LoadWords of_tension{"tendon", "radius", &quantity::length,
                               "the tendon's moment arm at each joint, positive where it turns the joint to "
                               "positive angles, 0 where it does not pass"};
constexpr LoadWords of_pressure{"pressure", "volume", &quantity::volume,
                                "what the actuator gains as each joint turns by a radian, 0 where it does "
                                "not reach"};

const DraftedActuator* actuator_of(const DraftedRun& run, const std::string& name) {
  const auto found = std::find_if(run.actuators.begin(), run.actuators.end(),
                                  [&](const DraftedActuator& one) { return one.name == name; });
  return found == run.actuators.end() ? nullptr : &*found;
}

/// Moment arms as a person writes them: "8, 6, 5 mm", or in SI without a unit.
std::vector<double> arms_in(const std::string& answer, const Quantity& quantity, std::size_t joints,
                            const std::string& place) {
  const auto begins_unit = [](unsigned char c) {  // not the exponent of "2.1e-6"
    return (std::isalpha(c) != 0 || c >= 0x80) && c != 'e' && c != 'E';
  };
  const auto at = std::find_if(answer.begin(), answer.end(), begins_unit);
  std::string written(at, answer.end());
  written.erase(written.find_last_not_of(" \t]") + 1);
  auto arms = numbers_in(std::string(answer.begin(), at));
  if (!arms || arms->size() != joints)
    throw Error(place, files::shown(answer),
                fmt::format("{} numbers in {}, or with a unit behind them", joints, quantity.si));
  const Unit unit = written.empty() ? si_unit(quantity) : parse_unit(written, quantity, place);
  for (double& arm : *arms) arm = in_si(arm, unit);
  return *arms;
}

class LoadDrafter {
 public:
  LoadDrafter(std::vector<DraftedRun>& runs, const DraftModel& model, const Ask& ask, Guesses& guesses)
      : runs_(runs), joints_(model.chain.link_length.size()), ask_(ask), guesses_(guesses) {}

  std::vector<DraftedLoad> result() {
    name_by_kind(Kind::tension, "tension");
    name_by_kind(Kind::pressure, "pressure");
    std::map<std::string, Kind> kinds;  // by name, so that the order of columns does not matter
    for (const DraftedRun& run : runs_)
      for (const DraftedActuator& one : run.actuators) kinds.emplace(one.name, one.kind);
    std::vector<DraftedLoad> loads;
    for (const auto& [name, kind] : kinds) {
      if (const DraftedRun* const run = moved_by(name)) {
        loads.push_back(load(name, kind, *run));
      } else {
        take_covariate(name);
      }
    }
    return loads;
  }

 private:
  /// A load that is the only one of its kind has one name in all runs, whatever their tables call it.
  void name_by_kind(Kind kind, const char* name) {
    const auto is = [kind](const DraftedActuator& one) { return one.kind == kind; };
    for (const DraftedRun& run : runs_)
      if (std::count_if(run.actuators.begin(), run.actuators.end(), is) > 1) return;
    for (DraftedRun& run : runs_)
      for (DraftedActuator& one : run.actuators)
        if (is(one)) one.name = name;
  }

  /// The first run that has the load and nothing else that drives it; or nothing.
  [[nodiscard]] const DraftedRun* moved_by(const std::string& name) const {
    for (const DraftedRun& run : runs_)
      if (run.moved_by_actuators && actuator_of(run, name) != nullptr) return &run;
    return nullptr;
  }

  /// Says a doubtful guess. \return what is to be taken instead
  std::optional<std::string> asked(Guess guess) {
    std::optional<std::string> answer;
    if (ask_) answer = ask_(guess);
    if (answer) guess = {guess.what, *answer, "as you said", false};
    guesses_.push_back(std::move(guess));
    return answer;
  }

  DraftedLoad load(const std::string& name, Kind kind, const DraftedRun& moved) {
    const LoadWords& words = load_words(kind);
    guesses_.push_back(
        {"load", fmt::format("{} = \"{}\"", words.key, name),
         fmt::format("it moves the chain of {}, where nothing else does", moved.source.name())});
    for (DraftedRun& run : runs_) {
      const DraftedActuator* const there = actuator_of(run, name);
      run.covariates[name] = there != nullptr ? there->column : constant(run, name);
    }
    const std::string what = fmt::format("{} of {}", words.arms, name);
    const auto answer =
        asked({what, "not known",
               fmt::format("no table tells {}: {} numbers, in {} where no unit is behind them",
                           words.arms_are, joints_, words.of_arms->si),
               true});
    return {name, kind, answer ? arms_in(*answer, *words.of_arms, joints_, what) : std::vector<double>()};
  }

  /// The load of a run whose table does not have it.
  DraftColumn constant(const DraftedRun& run, const std::string& name) {
    const std::string what = fmt::format("{} of {}", name, run.source.name());
    const auto answer = asked({what, "0 throughout", "no column has it, and other runs do", true});
    const auto values = answer ? numbers_in(*answer) : std::vector<double>{0.0};
    if (!values || values->size() != 1) throw Error(what, files::shown(*answer), "one number, in N or Pa");
    return {0, "", 1, 0, values->front()};
  }

  /// The values as they are written: units are of loads alone.
  void take_covariate(const std::string& name) {
    const auto without = std::find_if(
        runs_.begin(), runs_.end(), [&](const DraftedRun& run) { return actuator_of(run, name) == nullptr; });
    if (without != runs_.end()) {
      guesses_.push_back(
          {name, "left out",
           fmt::format("{} has no such column, and a covariate is of all runs", without->source.name())});
      return;
    }
    for (DraftedRun& run : runs_)
      run.covariates[name] = DraftColumn{actuator_of(run, name)->column.place, ""};
    guesses_.push_back({name, "a covariate, as it is written, and no load along the chain",
                        "a force on the end point, a torque or a command stands beside it"});
  }

  std::vector<DraftedRun>& runs_;
  std::size_t joints_;
  const Ask& ask_;
  Guesses& guesses_;
};

}  // namespace

const LoadWords& load_words(Kind kind) {
  return kind == Kind::tension ? of_tension : of_pressure;
}

std::vector<DraftedLoad> drafted_loads(std::vector<DraftedRun>& runs, const DraftModel& model, const Ask& ask,
                                       Guesses& guesses) {
  return LoadDrafter(runs, model, ask, guesses).result();
}

std::string open_question(const std::vector<DraftedLoad>& loads, std::size_t joints) {
  std::vector<std::string> open;
  for (const DraftedLoad& load : loads)
    if (load.moment_arm.empty())
      open.push_back(fmt::format("{} of {}", load_words(load.kind).arms, load.name));
  if (open.empty()) return "";
  return fmt::format("{}: found in no table, expected a list of {} numbers, one a joint, in its [[load]]",
                     fmt::join(open, ", "), joints);
}

}  // namespace plumbline::diagnose
