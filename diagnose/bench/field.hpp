#pragma once
/// \file
/// A field of a table as a number.

#include <optional>
#include <string>

#include "diagnose/bench/sample_format.hpp"

namespace plumbline::diagnose {

/// Whether the field stands for a missing value: it is empty, or a word that the format has for it.
bool is_missing(const std::string& field, const SampleFormat& format);

/// The number with a decimal point: empty for a missing value, nothing where it is no finite number as the
/// format writes them.
std::optional<std::string> decimal_in(const std::string& field, const SampleFormat& format);

/// The double nearest to a decimal; NaN for an empty one.
/// \param decimal  of decimal_in()
double nearest_double(const std::string& decimal);

/// \throws Error at the place, always: the field is no number
[[noreturn]] void refuse_field(const std::string& field, const SampleFormat& format,
                               const std::string& place);

}  // namespace plumbline::diagnose
