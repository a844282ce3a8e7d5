#pragma once
/// \file
/// An erratum as errata.toml states it.
///
/// A correction has the id of a `claim`, the `print` that its check has to confirm, the paper's words `for`
/// which to `read` others. Where these are left out, the whole quote is meant, and what to read is made of
/// the paper's words: an entry of the print that becomes another is replaced by its `words`. In `read` {1}
/// stands for the first entry, set as a formula or in its words; every entry that becomes another has to
/// occur.
///
/// A sentence of the `reason` is a list: its text, and the ids of what holds it.

#include "support/files/toml_file.hpp"
#include "verify/paper/paper.hpp"

namespace plumbline::verify {

/// \throws Error that names the place
Erratum read_erratum(const toml::table& one, const Paper& paper, const std::string& source);

}  // namespace plumbline::verify
