#pragma once
/// \file
/// Tables of chains as users write them. Every number is taken as the exact decimal that stands there.

#include <string>
#include <vector>

#include "statement/chain_file.hpp"

namespace plumbline::statement {

/// A table of chains; what is wrong with a row concerns that row alone.
struct ChainTable {
  std::vector<NamedChain> chains;
  std::vector<std::string> errors;  ///< one line for each wrong row
};

/// Whether the text begins with the header line of a table of chains.
bool is_chain_table(const std::string& text);

/// A table from CSV text with the columns `chain,lengths,stiffness`, the latter two decimals joined by `;`.
/// A row whose name has occurred before is wrong.
/// \throws Error when the header line is wrong or no row
/// follows
ChainTable parse_chain_table(const std::string& text, const std::string& source);

}  // namespace plumbline::statement
