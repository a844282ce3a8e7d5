#pragma once
/// \file
/// The assignment of channels to the columns of a sample file.

#include <cstddef>
#include <optional>
#include <plumbline/loaded/control.hpp>
#include <string>
#include <vector>

#include "diagnose/bench/sample_table.hpp"

namespace plumbline::diagnose {

/// The samples of a run, or a part of them: a file.
struct SamplePart {
  std::string source;  ///< as errors name it
  SampleTable table;
  SampleFormat format;
};

/// By column of the format, the column of the table, from 0; nullopt where the file has none.
using ColumnPlaces = std::vector<std::optional<std::size_t>>;

/// Of the parts of a run, each.
/// \param parts  a channel may be in one of them alone
/// \throws Error that names the source and the line: a header other than the one expected, a column that
///         experiment.toml names and no part has, or one has twice; no column of an imposed channel or of a
///         covariate; commanded angles in a run that does not impose them; some joint angles but not all
std::vector<ColumnPlaces> column_places(const std::vector<SamplePart>& parts, Control control);

/// The name of a column in messages: its header, or "column 3".
std::string column_title(const SampleTable& table, std::size_t column);

}  // namespace plumbline::diagnose
