#pragma once
/// \file
/// A paper as data: a folder of TOML files.
///
/// paper.toml has the reference, what was read, and the sections in their order, a file section-NAME.toml
/// each. premises.toml has what is given where claims are made, errata.toml what is to be corrected.
///
/// A claim has an `id`; `where` it stands in its section; a `quote`, the paper's own words or symbols; the
/// `reading` that is judged, one line, and the same as `printed`, a list of texts that the check can read;
/// the only `words` that these may hold; `list` is true where their number is judged too; `given`, the ids of
/// its premises; its `check`, one of verify/generic by name, or nothing where the program has a function of
/// its own. `charity` is "charitable" where the words allow several readings and the most favourable one was
/// taken; `subject` is "formula", "number" or "name" where it is no statement; claims that are wrong for one
/// reason name the erratum as their `cause`. verify/papers/README.md describes all of it.

#include <string>
#include <utility>
#include <vector>

#include "verify/judging/claim.hpp"

namespace plumbline::verify {

struct PaperSection {
  std::string number, title;  ///< "4.1", "Critical force for three-link manipulator"
};

/// What to print instead of a piece of a claim's quote.
struct Correction {
  std::string claim;          ///< its id
  Printed print;              ///< what the claim would print then: its own check has to confirm it
  std::string printed, read;  ///< the paper's words, and the same with the entries of `print` in their place
};

/// What several claims have wrong together, to be corrected once: made of ids, without a word of its own.
struct Erratum {
  std::string id;
  std::vector<Correction> corrections;
  std::vector<std::string> reason;   ///< claims that are wrong, for what is true instead, and facts
  std::vector<std::string> stands;   ///< claims that hold all the same
  std::vector<std::string> changes;  ///< printed results that do not
  bool remark = false;               ///< worth no correction of its own
};

struct Paper {
  std::string title, authors, journal, doi, preprint;
  std::string read;  ///< what was read of it
  std::vector<PaperSection> sections;
  std::vector<Premise> premises;
  std::vector<Claim> claims;  ///< in the order of the paper, without the checks that are functions of ours
  std::vector<Claim> facts;   ///< not the paper's: what the reasons of the errata rest on
  std::vector<Erratum> errata;

  /// The premises of these ids. \throws Error at one that there is not
  [[nodiscard]] Premises given(const std::vector<std::string>& ids) const;
  /// The claim or fact of that id. \throws Error where there is none
  [[nodiscard]] const Claim& claim(const std::string& id) const;
  /// The title of a section; empty for what is none.
  [[nodiscard]] std::string section_title(const std::string& number) const;
  /// "A. Author, B. Author, Title, Journal 1 (2000) 1."
  [[nodiscard]] std::string reference() const;
};

/// The text of a file of the folder by its name; nothing where there is none.
using PaperFiles = std::function<std::optional<std::string>(const std::string& name)>;

/// \throws Error that names the file and the line
Paper read_paper(const PaperFiles& files);

/// A folder of the user's.
/// \throws Error that names the file and the line
Paper read_paper_folder(const std::string& folder);

/// The paper that the program was made for. Read once.
const Paper& paper();

/// What a claim's passage of it prints.
/// \throws Error for an unknown id
const Printed& printed_in_paper(const std::string& id);

}  // namespace plumbline::verify
