#pragma once
/// \file
/// TOML whose numbers are the exact decimals that stand there.

#include <optional>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <vector>

#include "support/files/toml_file.hpp"

namespace plumbline::statement {

/// Every bare decimal becomes a string that decimals_in() knows from one that stands in quotes; those that
/// follow each other in a list become one, joined by `;`.
/// \throws Error that names the source and the line
toml::table parse_decimal_toml(const std::string& text, const std::string& source);

/// A decimal as it is written, or several, joined by `;`; nothing where anything else stands there, such as a
/// number in quotes.
std::optional<std::string> decimals_in(const toml::node& node);
/// A value as it stands in a file, for an error: a number in quotes with them.
std::string as_written(const toml::node& node);

/// The numbers of a text that joins them by ';', behind those before. \param list  names them in errors; the
/// numbers of a list whose name ends in lengths or stiffness are positive, or not negative
void add_joined(std::vector<Rational>& values, const std::string& field, const std::string& list);

/// The numbers of a list. \param list  names it in errors, and decides what they may be: add_joined()
/// \throws Error that names the entry which is none
std::vector<Rational> numbers_of(const toml::array& list, const std::string& name);

/// A single number. \throws Error at the place where it is none
Rational number_of(const toml::node& node, const std::string& where);

}  // namespace plumbline::statement
