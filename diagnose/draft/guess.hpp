#pragma once
/// \file
/// A guess about a table of readings, with its reason.

#include <string>
#include <vector>

namespace plumbline::diagnose {

struct Guess {
  std::string what;       ///< "delimiter", "x", "rest of press"
  std::string value;      ///< as a person reads it: "; (semicolon)", "column Traverse, in mm"
  std::string reason;     ///< what in the files says so
  bool doubtful = false;  ///< whether a person should look at it
  std::string line = {};  ///< of a doubtful one: what a script writes to say it; or empty
};
using Guesses = std::vector<Guess>;

}  // namespace plumbline::diagnose
