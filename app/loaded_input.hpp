#pragma once
/// \file
/// The chain that a verb about loaded chains works on.

#include <CLI/CLI.hpp>
#include <optional>
#include <plumbline/chain/chain.hpp>
#include <string>

#include "app/structure_report.hpp"
#include "statement/chain_file.hpp"

namespace plumbline::app {

struct LoadedChain {
  std::string path;  ///< as the user wrote it; empty: the four-link Z-chain of the paper's Table 1
  std::string name = "Z-chain of Table 1";
  Chain<Rational> exact{{1}, {1}};
  bool plain = true;  ///< in the plane, and nothing is said of ends and loads: those of the paper
  std::optional<Structure<Rational>> structure;  ///< in the plane
  std::optional<NamedModel> model;

  void add_to(CLI::App& verb);
  /// \throws Error that names the file and the line or key
  void read();

 private:
  void take(const statement::StatedChain& read, const std::string& source);
};

}  // namespace plumbline::app
