#pragma once
/// \file
/// TOML, with errors in our form.

#include <toml++/toml.h>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::files {

/// \throws Error that names the source and the line
toml::table parse_toml(const std::string& text, const std::string& source);

/// "source:line" of a node.
std::string place(const toml::node& node, const std::string& source);

/// \param synonyms  that are read too, though nothing names them
/// \throws Error that names the first key that is not among the known ones
void refuse_unknown_keys(const toml::table& table, const std::vector<std::string_view>& known,
                         const std::string& source, const std::vector<std::string_view>& synonyms = {});

}  // namespace plumbline::files
