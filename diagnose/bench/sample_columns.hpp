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

/// By column of the format, the column of the table, from 0; nullopt where the file has none.
using ColumnPlaces = std::vector<std::optional<std::size_t>>;

/// \throws Error that names the source and the line: a header other than the one expected, a column that
///         experiment.toml names and the file has not, or twice; no column of an imposed channel; commanded
///         angles in a run that does not impose them; some joint angles but not all
ColumnPlaces column_places(const SampleTable& table, const SampleFormat& format, const std::string& source,
                           Control control);

/// The name of a column in messages: its header, or "column 3".
std::string column_title(const SampleTable& table, std::size_t column);

}  // namespace plumbline::diagnose
