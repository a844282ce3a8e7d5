#pragma once
/// \file
/// Tables of an experiment's TOML, read key by key with errors that name the place.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "files/toml_file.hpp"

namespace plumbline::diagnose {

/// A value as an error shows it.
std::string shown(const toml::node& node);

/// A table of the file, with the words that an error about it begins with. What a member throws is an Error
/// that names the place, what was found and what was expected.
class Section {
 public:
  Section(const toml::table& table, std::string place) : table_(table), place_(std::move(place)) {}

  [[nodiscard]] std::string place(const std::string& key) const { return place_ + key; }
  void allow_only(const std::set<std::string>& keys) const;
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] const toml::node& required(const std::string& key, const std::string& expected) const;
  [[nodiscard]] Section table(const std::string& key) const;
  /// The tables `[[key]]`, or none.
  [[nodiscard]] std::vector<Section> tables(const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& key, const std::string& expected) const;
  /// Zero where the key is absent.
  [[nodiscard]] double non_negative(const std::string& key) const;
  /// An integer from 1; zero where the key is absent.
  [[nodiscard]] std::size_t count(const std::string& key) const;
  /// \param length  of the list; 0 for any
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t length) const;
  /// The same, each of which must be accepted.
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t length,
                                            const std::string& expected, bool (*accept)(double)) const;
  [[nodiscard]] std::array<double, 2> pair(const std::string& key) const;
  /// Every key of the table `key`, with its number.
  [[nodiscard]] std::map<std::string, double> named_numbers(const std::string& key) const;

 private:
  const toml::table& table_;
  std::string place_;
};

}  // namespace plumbline::diagnose
