#pragma once
/// \file
/// Chains as users write them. Every number is taken as the exact decimal that stands there.

#include <filesystem>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::app {

/// A chain from TOML text: lists `lengths` (or `link_length`), `stiffness` (or `joint_stiffness`) and
/// (optional) `rest`, of numbers or of decimals in quotes.
/// \throws Error that names the source and the line
/// or key
Chain<Rational> parse_chain(const std::string& text, const std::string& source);

struct NamedChain {
  std::string name;
  std::string place;  ///< "file:line", for messages
  Chain<Rational> chain;
};

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

}  // namespace plumbline::app
