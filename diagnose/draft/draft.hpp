#pragma once
/// \file
/// Draft of an experiment from a model and tables of readings. Every guess is reported with its reason.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/draft/guess.hpp"
#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// The chain, known before the tables are read.
struct DraftModel {
  NominalChain chain;
  std::vector<std::string> joints;   ///< their names in the model, from the base on; or empty
  std::array<double, 2> base{0, 0};  ///< where joint 1 is in the model's plane, m
  bool weighs = false;               ///< whether the model has gravity at all
};

struct Draft {
  std::string settings;           ///< the text of experiment.toml
  std::vector<DraftFile> tables;  ///< to stand beside it; those of several runs are cut into one a run
  Guesses guesses;
  std::string question;  ///< the open question to the user, in one line; or empty
};

/// Called for each doubtful guess. Returns a replacement, or nothing to accept the guess.
using Ask = std::function<std::optional<std::string>(const Guess& guess)>;

/// \param name  of the experiment
/// \param ask   or nothing where nobody can be asked
/// \throws Error where a table cannot be read at all, two have one name, or no column of a table can be told
Draft draft_experiment(const std::string& name, const DraftModel& model, const std::vector<DraftFile>& files,
                       const Ask& ask = {});

}  // namespace plumbline::diagnose
