#pragma once
/// \file
/// A table of TOML of which every key is known and every value has the type that its key asks for: what is
/// there and is not what was expected is an error, never a default.

#include <optional>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "statement/decimal_toml.hpp"

namespace plumbline::statement {

/// A table whose numbers are exact decimals (decimal_toml.hpp). Its errors name the source and the line.
class TypedTable {
 public:
  /// \param known     the keys that may be there
  /// \param synonyms  that may be there too, though no error names them
  /// \throws Error for any other key
  TypedTable(const toml::table& table, std::string source, const std::vector<std::string_view>& known,
             const std::vector<std::string_view>& synonyms = {});

  /// Whether the key is there.
  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
  /// "source:line: key" of a key that is there, "source: key" of one that is not.
  [[nodiscard]] std::string place(std::string_view key) const;
  /// The source, as errors name it.
  [[nodiscard]] const std::string& source() const { return source_; }

  // Each throws an Error at the place of the key where its value is no such thing, and where it is not there.
  [[nodiscard]] const toml::node& node(std::string_view key) const;         ///< whatever stands there
  [[nodiscard]] Rational number(std::string_view key) const;                ///< a decimal
  [[nodiscard]] Rational positive(std::string_view key) const;              ///< above zero
  [[nodiscard]] Rational not_negative(std::string_view key) const;          ///< zero or above
  [[nodiscard]] std::vector<Rational> numbers(std::string_view key) const;  ///< a list of decimals
  /// A list of so many decimals.
  [[nodiscard]] std::vector<Rational> numbers(std::string_view key, std::size_t count) const;
  /// One of these words.
  [[nodiscard]] std::string word(std::string_view key, const std::vector<std::string_view>& words) const;
  /// `true` or `false`; `otherwise` where the key is not there.
  [[nodiscard]] bool flag(std::string_view key, bool otherwise) const;
  /// A table of these keys.
  [[nodiscard]] TypedTable table(std::string_view key, const std::vector<std::string_view>& known) const;
  /// A list of tables of these keys, such as the example; empty where the key is not there.
  [[nodiscard]] std::vector<TypedTable> tables(std::string_view key,
                                               const std::vector<std::string_view>& known,
                                               const std::string& example) const;

 private:
  const toml::table* table_;
  std::string source_;
};

/// The word that stands there; empty where it is none.
std::string word_of(const toml::node& node);

}  // namespace plumbline::statement
