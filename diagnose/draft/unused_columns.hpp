#pragma once
/// \file
/// Columns that no channel has taken: each is named, with the reason.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::diagnose {

struct UsedColumns {
  RunSource source;
  std::function<bool(std::size_t column)> uses;
};

/// A column that says a force, a torque, a mass, an angle, a current or a temperature is doubtful: the
/// diagnosis may miss it.
void account_for_columns(const std::vector<UsedColumns>& runs, const std::vector<std::string>& joints,
                         const Ask& ask, Guesses& guesses);

}  // namespace plumbline::diagnose
