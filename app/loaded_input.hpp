#pragma once
/// \file
/// The chain that a verb about loaded chains works on.

#include <CLI/CLI.hpp>
#include <optional>
#include <plumbline/chain/chain.hpp>
#include <string>

#include "app/structure_report.hpp"

namespace plumbline::app {

struct LoadedChain {
  std::string path;  ///< as the user wrote it; empty: the four-link Z-chain of the paper's Table 1
  std::string name = "Z-chain of Table 1";
  Chain<Rational> exact{{1}, {1}};
  std::optional<Structure<Rational>> structure;  ///< of a planar chain of that kind
  std::optional<NamedModel> other;  ///< where the file says of other ends and loads, or of a chain in space

  void add_to(CLI::App& verb);
  /// \throws Error that names the file and the line or key
  void read();
};

}  // namespace plumbline::app
