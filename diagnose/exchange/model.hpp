#pragma once
/// \file
/// A model to be written for a simulator: a chain with the effects that it is known to have.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/rig/rig.hpp"

namespace plumbline::exchange {

struct Model {
  std::string title;  ///< one line, for the head of the file
  /// The nominal chain with the effects and, where no cause is known, free laws; and the bench; the runs say
  /// what the effects act on.
  diagnose::Experiment experiment;
  std::vector<double> rest;           ///< the unloaded shape that the file shows
  std::filesystem::path source = {};  ///< the file that the nominal chain was read from, if any
};

/// What became of one effect in a file.
struct Carried {
  std::string effect;  ///< "backlash(2)", or "torque_law(2)"
  bool carried;
  std::string how;  ///< as what, or why not
};

/// The text of a model in some format.
struct Written {
  std::string text;
  std::vector<Carried> effects;
  std::string note = {};  ///< what the file is, where there is a choice
};

/// What stands at the head of a file: the title, remarks on the format, what became of each effect, laws.
std::vector<std::string> head_lines(const Model& model, const std::vector<Carried>& effects,
                                    const std::vector<std::string>& remarks = {});

}  // namespace plumbline::exchange
