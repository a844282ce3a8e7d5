#pragma once
/// \file
/// Tables of an experiment's TOML, read key by key; errors name the place.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "support/files/toml_file.hpp"

namespace plumbline::diagnose {

/// A value as it appears in errors.
std::string shown(const toml::node& node);

/// A table of the file. Members throw an Error "file:line: path.key: found …, expected …".
class Section {
 public:
  /// The whole file.
  /// \param table  outlives the section
  Section(const toml::table& table, std::string source) : Section(table, std::move(source), "") {}

  /// "file:line: path.key", with the line of the table where the key is missing.
  [[nodiscard]] std::string place(const std::string& key) const;
  /// "file:line", of the table.
  [[nodiscard]] std::string where() const;
  [[nodiscard]] std::vector<std::string> keys() const;
  /// \param synonyms  accepted keys that errors do not mention
  void allow_only(const std::set<std::string>& keys, const std::set<std::string>& synonyms = {}) const;
  [[nodiscard]] bool has(const std::string& key) const { return table_->contains(key); }
  /// \pre has(key)
  [[nodiscard]] const toml::node& node(const std::string& key) const { return *table_->get(key); }
  [[nodiscard]] const toml::node& required(const std::string& key, const std::string& expected) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;

  [[nodiscard]] Section table(const std::string& key) const;
  /// The same; an empty table where there is none.
  [[nodiscard]] Section table_or_empty(const std::string& key) const;
  /// The tables `[[key]]`, or none.
  [[nodiscard]] std::vector<Section> tables(const std::string& key) const;
  /// A table in a list of this section.
  /// \param path  from here: "samples[2]"
  [[nodiscard]] Section entry(const toml::table& table, const std::string& path) const {
    return {table, source_, path_ + path + "."};
  }
  /// A non-empty text.
  [[nodiscard]] std::string text(const std::string& key, const std::string& expected) const;
  /// One of these words.
  [[nodiscard]] std::string one_of(const std::string& key, const std::vector<std::string>& words) const;
  /// A text short enough for a line of a report.
  [[nodiscard]] std::string name(const std::string& key, const std::string& expected) const;
  /// A list of texts, or one alone.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key, const std::string& expected) const;
  [[nodiscard]] bool flag_or(const std::string& key, bool otherwise) const;
  [[nodiscard]] double number(const std::string& key, const std::string& expected) const;
  /// A non-negative number; zero where the key is absent.
  [[nodiscard]] double non_negative(const std::string& key) const;
  /// A non-negative integer.
  [[nodiscard]] std::size_t whole_or(const std::string& key, std::size_t otherwise) const;
  /// An integer from 1; zero where the key is absent.
  [[nodiscard]] std::size_t count(const std::string& key) const;
  /// \param length  of the list; 0 for any
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t length) const;
  /// The same, each value accepted by `accept`.
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t length,
                                            const std::string& expected, bool (*accept)(double)) const;
  [[nodiscard]] std::array<double, 2> pair(const std::string& key) const;
  /// Every key of the table `key`, with its number.
  [[nodiscard]] std::map<std::string, double> named_numbers(const std::string& key) const;

 private:
  Section(const toml::table& table, std::string source, std::string path)
      : table_(&table), source_(std::move(source)), path_(std::move(path)) {}

  const toml::table* table_;
  std::string source_, path_;
};

}  // namespace plumbline::diagnose
