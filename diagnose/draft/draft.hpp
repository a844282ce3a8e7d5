#pragma once
/// \file
/// Draft of an experiment from a model and tables of readings. Every guess is reported with its reason.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/draft/guess.hpp"
#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// From the angle of a model's joint to that of the chain's.
struct AngleMap {
  double sign = 1;      ///< -1 where it turns the other way
  double straight = 0;  ///< the chain's angle where the model's is 0, rad
};

/// The model, known before the tables are read: a chain in a plane, an arm in space, or one that is both.
struct DraftModel {
  NominalChain chain;                          ///< without a link where the model is none
  std::vector<std::string> joints;             ///< their names in the model, from the base on; or empty
  std::array<double, 2> base{0, 0};            ///< where joint 1 is in the model's plane, m
  bool weighs = false;                         ///< whether the model has gravity at all
  std::vector<AngleMap> angles = {};           ///< of the chain's joints; empty where all are the same
  std::shared_ptr<const NominalArm> arm = {};  ///< or null
  DraftFile file = {};                         ///< of the arm, to stand beside the experiment
  std::string tip = {}, base_body = {};        ///< of the arm, where a person names them

  /// Those of the joints by which tables may name them.
  [[nodiscard]] const std::vector<std::string>& names() const {
    return joints.empty() && arm ? arm->joint : joints;
  }
};

/// What the readings are of.
enum class BenchKind {
  plane,  ///< a chain whose end point is put or loaded, or whose joints are commanded
  joint,  ///< a joint alone
  arm     ///< poses of an arm in space
};

struct Draft {
  std::string settings;           ///< the text of experiment.toml
  std::vector<DraftFile> tables;  ///< to stand beside it; those of several runs are cut into one a run
  Guesses guesses;
  std::string question;  ///< the open question to the user, in one line; or empty
  BenchKind bench = BenchKind::plane;
};

/// Called for each doubtful guess. Returns a replacement, or nothing to accept the guess.
using Ask = std::function<std::optional<std::string>(const Guess& guess)>;

/// \param files  as they came: text in any encoding, or workbooks
/// \param name   of the experiment
/// \param ask    or nothing where nobody can be asked
/// \param told   what a person says of columns
/// \throws Error where a table cannot be read at all, two have one name, or no column of a table can be told
Draft draft_experiment(const std::string& name, const DraftModel& model, const std::vector<DraftFile>& files,
                       const Ask& ask = {}, const std::vector<ToldColumn>& told = {});

}  // namespace plumbline::diagnose
