#pragma once
/// \file
/// An erratum as errata.toml states it: ids, prints, and words of the paper.
///
/// A correction has the id of a `claim`, the `print` that its check has to confirm, and `for`, the paper's
/// words of each entry that becomes another: a list, or one text. The entry, a formula set as one, takes
/// their place in `within`, a piece of the quote; without it in the words themselves. With `as`, "list",
/// "column" or "2 rows", the whole print takes the place of one text.
///
/// `reason`, `stands` and `changes` are lists of ids.

#include "support/files/toml_file.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

/// \throws Error that names the place
Erratum read_erratum(const toml::table& one, const Paper& paper, const std::string& source);

}  // namespace plumbline::verify
