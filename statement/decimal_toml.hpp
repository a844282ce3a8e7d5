#pragma once
/// \file
/// TOML whose numbers are the exact decimals that stand there.

#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <vector>

#include "support/files/toml_file.hpp"

namespace plumbline::statement {

/// Every bare decimal becomes a string, those that follow each other in a list one string, joined by `;`.
/// \throws Error that names the source and the line
toml::table parse_decimal_toml(const std::string& text, const std::string& source);

/// The numbers of a text that joins them by ';', behind those before. \param list  names them in errors; the
/// numbers of a list whose name ends in lengths or stiffness are positive, or not negative
void add_joined(std::vector<Rational>& values, const std::string& field, const std::string& list);

/// The numbers of a list. \param list  names it in errors, and decides what they may be: add_joined()
/// \throws Error that names the entry which is none
std::vector<Rational> numbers_of(const toml::array& list, const std::string& name);

/// A single number. \throws Error at the place where it is none
Rational number_of(const toml::node& node, const std::string& where);

}  // namespace plumbline::statement
