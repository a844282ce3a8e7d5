#include "diagnose/bench/covariates.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <plumbline/base/error.hpp>
#include <utility>

namespace plumbline::diagnose {
namespace {

/// The covariates stand behind all other columns.
std::vector<std::string> names_of(const Run& run) {
  const std::size_t count = run.readings.front().covariates.size();
  std::vector<std::string> names;
  for (std::size_t c = run.origins.size() - count; c < run.origins.size(); ++c)
    names.push_back(run.origins[c].what);
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "no covariate" : fmt::format("the covariates {}", fmt::join(names, ", "));
}

/// \returns the number of missing values
std::size_t complete(Run& run, std::size_t covariate) {
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < run.readings.size(); ++i)
    if (!std::isnan(run.readings[i].covariates[covariate])) given.push_back(i);
  if (given.empty()) return run.readings.size();
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const auto next = std::lower_bound(given.begin(), given.end(), i);
    const Reading& after = run.readings[next == given.end() ? given.back() : *next];
    const Reading& before = run.readings[next == given.begin() ? given.front() : *std::prev(next)];
    Reading& here = run.readings[i];
    const double wait = after.t - before.t, from = before.covariates[covariate],
                 to = after.covariates[covariate];
    if (std::isnan(here.covariates[covariate]))
      here.covariates[covariate] = wait > 0 ? from + (to - from) * (here.t - before.t) / wait : from;
  }
  return run.readings.size() - given.size();
}

}  // namespace

std::vector<std::string> complete_covariates(std::vector<Run>& runs, const std::string& place,
                                             std::vector<std::string> named) {
  std::optional<std::vector<std::string>> common;
  for (Run& run : runs) {
    if (run.readings.empty()) continue;
    const std::vector<std::string> names = names_of(run);
    if (!common) common = names;
    if (names != *common)
      throw Error(place, fmt::format("run \"{}\" with {}", run.id, listed(names)),
                  fmt::format("{}, as in the first run", listed(*common)));
    for (std::size_t c = 0; c < names.size(); ++c) {
      run.interpolated.push_back(complete(run, c));
      if (run.interpolated.back() == run.readings.size())
        throw Error(place, fmt::format("no value of {} in run \"{}\"", names[c], run.id),
                    "one or more; those between are interpolated in time");
    }
  }
  return common.value_or(std::move(named));
}

}  // namespace plumbline::diagnose
