#pragma once
/// \file
/// What the paper says, as far as it can be checked: the files section-*.toml, in the order of the paper.
///
/// A claim has an `id`; `where` it stands in its section; a `quote`, the paper's own words or symbols; the
/// `reading` that is judged, one line, and the same as `printed`, a list of texts that the check can read;
/// the only `words` that these may hold; `list` is true where their number is judged too. `charity` is
/// "charitable" where the words allow several readings and the most favourable one was taken; `subject` is
/// "number" or "name" where it is no statement; claims that are wrong for one reason name it as their
/// `cause`.

#include "verify/judging/claim.hpp"

namespace plumbline::verify {

struct PaperSection {
  std::string number, title;  ///< "4.1", "Critical force for three-link manipulator"
};

/// What several claims have wrong together, to be corrected once.
struct Cause {
  std::string id, title;
  std::string correction;              ///< what to print instead, in one sentence
  std::string effect;                  ///< on the paper's results, in one sentence
  std::vector<std::string> unchanged;  ///< ids of claims that do not depend on it; that they hold is computed
};

struct Paper {
  std::vector<PaperSection> sections;
  std::vector<Claim> claims;  ///< in the order of the paper, without their checks
  std::vector<Cause> causes;
};

/// Read once.
/// \throws Error that names the file and the line
const Paper& paper();

/// What a claim's passage prints.
/// \throws Error for an unknown id
const Printed& printed_in_paper(const std::string& id);

/// The title of a section of the paper; empty for what is none.
std::string section_title(const std::string& number);

}  // namespace plumbline::verify
