#include "verify/paper/paper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <plumbline/base/error.hpp>
#include <set>

#include "support/files/text_file.hpp"
#include "verify/judging/notation.hpp"
#include "verify/paper/errata_file.hpp"
#include "verify/paper/texts.hpp"
#include "verify/paper/toml_texts.hpp"

namespace plumbline::verify {
namespace {

Premise premise(const toml::table& one, const std::string& source) {
  Premise read{text(one, "id", source), text(one, "where", source, ""), text(one, "quote", source), {}};
  for (const char* const part : {"length", "stiffness", "rest", "end", "chain", "value"})
    if (one.contains(part)) read.parts[part] = texts(one, part, source);
  files::refuse_unknown_keys(
      one, {"id", "where", "quote", "length", "stiffness", "rest", "end", "chain", "value"}, source);
  return read;
}

/// The check that a claim's own words state.
StatedCheck stated_check(const toml::table& claim, const std::string& source) {
  const toml::table* const table = claim["check"].as_table();
  if (table == nullptr) return {};
  StatedCheck check{text(*table, "is", source), {}, files::place(claim, source)};
  for (const auto& [key, node] : *table) {
    const std::string name(key.str());
    if (name != "is") check.with[name] = texts(*table, name, source);
  }
  return check;
}

Claim read_claim(const toml::table& one, const std::string& where, const std::string& source) {
  const std::string id = text(one, "id", source);
  Claim claim;
  claim.id = id;
  claim.where = where;
  claim.also = texts(one, "also", source);
  claim.quote = text(one, "quote", source, "");
  claim.reading = in_notation(
      text(one, "reading", source, claim.quote.empty() ? std::optional<std::string>("") : std::nullopt));
  claim.charitable = choice(one, "charity", {"literal", "charitable"}, source) == 1;
  claim.printed = texts(one, "printed", source);
  claim.words = texts(one, "words", source);
  claim.list = one["list"].value_or(false);
  claim.subject =
      static_cast<Subject>(choice(one, "subject", {"statement", "formula", "number", "name"}, source));
  claim.cause = text(one, "cause", source, id);
  claim.stated = stated_check(one, source);
  return claim;
}

/// Reads the files of a folder one after the other.
class FolderReader {
 public:
  explicit FolderReader(const PaperFiles& files) : files_(files) {}

  Paper whole() {
    const std::string source = "paper.toml";
    const toml::table file = parse(source);
    files::refuse_unknown_keys(file, {"title", "authors", "journal", "doi", "preprint", "read", "sections"},
                               source);
    paper_.title = text(file, "title", source);
    paper_.authors = text(file, "authors", source);
    paper_.journal = text(file, "journal", source);
    paper_.doi = text(file, "doi", source, "");
    paper_.preprint = text(file, "preprint", source, "");
    paper_.read = text(file, "read", source);
    read_premises();
    for (const std::string& name : texts(file, "sections", source)) read_section("section-" + name + ".toml");
    read_errata();
    give_premises();
    return std::move(paper_);
  }

 private:
  [[nodiscard]] toml::table parse(const std::string& source) const {
    const auto content = files_(source);
    if (!content) throw Error(source, "no such file", "one in the folder of the paper");
    return files::parse_toml(*content, source);
  }
  /// An empty table where there is no such file.
  [[nodiscard]] toml::table parse_if_there(const std::string& source) const {
    return files_(source) ? parse(source) : toml::table{};
  }

  void read_premises() {
    const std::string source = "premises.toml";
    each(parse_if_there(source), "premise", source,
         [&](const toml::table& one) { paper_.premises.push_back(premise(one, source)); });
  }

  void read_section(const std::string& source) {
    const toml::table file = parse(source);
    files::refuse_unknown_keys(file, {"section", "title", "claim"}, source);
    const std::string section = text(file, "section", source);
    if (paper_.sections.empty() || paper_.sections.back().number != section)
      paper_.sections.push_back({section, text(file, "title", source)});
    each(file, "claim", source, [&](const toml::table& one) {
      files::refuse_unknown_keys(one,
                                 {"id", "where", "also", "quote", "reading", "printed", "given", "words",
                                  "list", "charity", "subject", "cause", "check"},
                                 source);
      add(paper_.claims, read_claim(one, section + ", " + text(one, "where", source), source), one, source);
    });
  }

  void read_errata() {
    const std::string source = "errata.toml";
    const toml::table file = parse_if_there(source);
    files::refuse_unknown_keys(file, {"fact", "erratum"}, source);
    each(file, "fact", source, [&](const toml::table& one) {
      files::refuse_unknown_keys(one, {"id", "printed", "given", "words", "check"}, source);
      add(paper_.facts, read_claim(one, "behind the errata", source), one, source);
    });
    each(file, "erratum", source,
         [&](const toml::table& one) { paper_.errata.push_back(read_erratum(one, paper_, source)); });
  }

  void add(std::vector<Claim>& list, Claim claim, const toml::table& one, const std::string& source) {
    if (!ids_.insert(claim.id).second)
      throw Error(files::place(one, source), "the id " + claim.id + " again", "another for each claim");
    given_.push_back({texts(one, "given", source), files::place(one, source)});
    list.push_back(std::move(claim));
  }

  /// Puts the print of a claim, as far as the chain has links, where a premise names it; then each claim's
  /// premises beside it.
  void give_premises() {
    for (Premise& premise : paper_.premises) {
      for (auto& [name, part] : premise.parts) {
        if (part.size() != 1 || !ids_.contains(part.front())) continue;
        const Printed& printed = paper_.claim(part.front()).printed;
        const std::size_t links = premise.parts.at("length").size();
        part.assign(printed.begin(), printed.begin() + static_cast<std::ptrdiff_t>(links));
      }
    }
    std::size_t number = 0;
    for (std::vector<Claim>* const list : {&paper_.claims, &paper_.facts}) {
      for (Claim& claim : *list) {
        const auto& [ids, place] = given_[number++];
        try {
          claim.given = paper_.given(ids);
        } catch (const Error& error) {
          throw Error(place, error.what(), "ids of premises.toml");
        }
      }
    }
  }

  const PaperFiles& files_;
  Paper paper_;
  std::set<std::string> ids_;
  std::vector<std::pair<std::vector<std::string>, std::string>> given_;  ///< by claim, with its place
};

}  // namespace

Premises Paper::given(const std::vector<std::string>& ids) const {
  std::vector<Premise> list;
  for (const std::string& id : ids) {
    const auto found =
        std::find_if(premises.begin(), premises.end(), [&](const Premise& one) { return one.id == id; });
    if (found == premises.end()) throw Error("premises", id, "one of premises.toml");
    list.push_back(*found);
  }
  return Premises(std::move(list));
}

const Claim& Paper::claim(const std::string& id) const {
  for (const auto* const list : {&claims, &facts}) {
    for (const Claim& one : *list)
      if (one.id == id) return one;
  }
  throw Error("claim " + id, "no passage", "one in the paper");
}

std::string Paper::section_title(const std::string& number) const {
  for (const PaperSection& section : sections) {
    if (section.number == number) return section.title;
  }
  return "";
}

std::string Paper::reference() const {
  return fmt::format("{}, {}, {}", authors, title, journal);
}

Paper read_paper(const PaperFiles& files) {
  return FolderReader(files).whole();
}

Paper read_paper_folder(const std::string& folder) {
  const std::filesystem::path path(folder);
  if (!std::filesystem::exists(path / "paper.toml"))
    throw Error(folder, "no paper.toml", "the folder of a paper");
  return read_paper([&](const std::string& name) -> std::optional<std::string> {
    if (!std::filesystem::exists(path / name)) return std::nullopt;
    return files::read_text(path / name);
  });
}

const Paper& paper() {
  static const Paper instance = read_paper([](const std::string& name) -> std::optional<std::string> {
    for (const auto& [file, content] : paper_texts) {
      if (file == name) return content;
    }
    return std::nullopt;
  });
  return instance;
}

const Printed& printed_in_paper(const std::string& id) {
  return paper().claim(id).printed;
}

}  // namespace plumbline::verify
