#pragma once
/// \file
/// Where a result comes from, as every file that is written says it.

#include <nlohmann/json.hpp>
#include <string>

namespace plumbline::page {

struct Provenance {
  std::string program;  ///< name, version and, where it is known, the commit
  std::string command;  ///< what was asked for, but for the files to write, on which no result depends
  std::string inputs;   ///< SHA-256 of the files that were read, one after the other; empty where none was
};

/// The text of a JSON file: the object, with the key `provenance` at its end.
std::string json_text(nlohmann::ordered_json object, const Provenance& provenance);

/// The page with a last line for people, which has a date as well: the day that SOURCE_DATE_EPOCH names,
/// where it is set, else today in UTC.
std::string on_page(std::string html, const Provenance& provenance);

/// The drawing with an element `metadata`.
std::string in_drawing(std::string svg, const Provenance& provenance);

/// The document with a last line.
std::string in_markdown(const std::string& markdown, const Provenance& provenance);

/// The document with comments before it.
std::string in_latex(const std::string& latex, const Provenance& provenance);

}  // namespace plumbline::page
