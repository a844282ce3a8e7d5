#pragma once
/// \file
/// The scores of a trial.

#include <map>
#include <string>
#include <vector>

#include "trial/answer.hpp"
#include "trial/wilson.hpp"

namespace plumbline::trial {

/// One experiment, diagnosed and unsealed.
struct Case {
  Label label;
  Judgement judgement;
  double seconds = 0;      ///< duration of the diagnosis
  bool seal_holds = true;  ///< false where label and salt do not give the published seal
};

/// "none", "id", "id+id": the kind of truth without joints; "unknown" outside the catalogue.
std::string truth_kind(const Label& label);
/// The same with joints.
std::string truth_words(const Label& label);

/// Strength of a gap: [low, high) sigmas.
struct Band {
  double low, high;
};
/// Bands with the limits 2.5, 5, 10, 20.
const std::vector<Band>& bands();

/// A row of the tables: cases and their answers.
struct Row {
  std::string name;
  std::vector<std::size_t> answers;  ///< by Answer
  Proportion found;                  ///< right or in the class
  Proportion wrong_sure = {};        ///< identified, and wrong
};

/// Stated probabilities in [low, high) and their frequency of being right.
struct Reliability {
  double low, high;
  double stated = 0;  ///< their mean
  Proportion right{};
};

/// Confusion: the best explanation by the truth, both without joints.
using Confusion = std::map<std::string, std::map<std::string, std::size_t>>;

struct Spread {
  double median = 0, ninth_decile = 0, worst = 0;
};

struct Score {
  std::size_t cases = 0;
  Row all;
  std::vector<Row> by_strength;  ///< one effect of the catalogue
  std::vector<Row> by_truth;     ///< none, every effect, two effects, outside the catalogue
  std::vector<Row> by_noise;
  std::vector<Row> by_family;  ///< of labels that name one; the most often wrong and sure first
  Confusion confusion;
  Proportion strong;           ///< one effect, 5 sigma or more: found
  Proportion weak;             ///< one effect, 2.5 to 5 sigma: found
  Proportion wrong_sure;       ///< identified and wrong, of all that were identified
  Proportion false_alarm;      ///< of the experiments without an effect
  Proportion outside;          ///< effects outside the catalogue: called unknown
  Proportion place;            ///< of those: the joint, or else the channel, named first
  Proportion pairs;            ///< two effects: both found
  Proportion covered;          ///< true parameters inside their 95 % bounds
  Proportion oversized_class;  ///< found, but in a class larger than the experiment's own
  std::size_t no_report = 0, broken_seals = 0;
  std::vector<Reliability> reliability;
  double brier = 0;  ///< mean, 0 is best, 2 worst
  Spread shrunk;     ///< held-out residual over the noise floor, where the cause was found
  Spread seconds;
};

Score score(const std::vector<Case>& cases);

}  // namespace plumbline::trial
