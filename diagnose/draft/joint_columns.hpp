#pragma once
/// \file
/// Columns that belong to the joints of a chain or an arm, one each.

#include <vector>

#include "diagnose/draft/column_words.hpp"

namespace plumbline::diagnose {

/// The columns of a kind for all joints: by number or name, or as many as there are joints, in their order.
/// Empty where some joint has none.
std::vector<std::size_t> joint_columns(const std::vector<ColumnWords>& words, Kind kind, bool commanded,
                                       std::size_t joints);

}  // namespace plumbline::diagnose
