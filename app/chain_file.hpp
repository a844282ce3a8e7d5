#pragma once
/// \file
/// Chains as users write them. Every number is taken as the exact decimal that stands there.

#include <filesystem>
#include <optional>
#include <plumbline/structure/structure.hpp>
#include <string>
#include <vector>

#include "app/structure_file.hpp"

namespace plumbline::app {

/// A chain with its ends and loads, as it stands in a file.
struct NamedStructure {
  std::string name;
  std::string place;  ///< "file:line", for messages
  Structure<Rational> structure;
  bool plain;                ///< whether nothing is said of ends and loads: those of the paper
  std::optional<Beam> beam;  ///< that the chain stands for
};

/// From TOML text: lists `lengths` (or `link_length`), `stiffness` (or `joint_stiffness`) and (optional)
/// `rest`, of numbers or of decimals in quotes, and what structure_file.hpp reads, in the file itself or in
/// its table [nominal], as `plumbline chain` writes it. Without loads it has a unit force against x at the
/// end point.
/// \throws Error that names the source and the line or key
NamedStructure parse_structure(const std::string& text, const std::string& source);

/// A table of chains; what is wrong with a row concerns that row alone.
struct ChainTable {
  std::vector<NamedStructure> chains;
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
