#include "statement/decimal_toml.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <sstream>

#include "proofs/exact/decimal.hpp"
#include "support/files/printable.hpp"

namespace plumbline::statement {
namespace {

/// Begins the string that a bare decimal becomes. A file has it in no word.
constexpr char bare = '\x01';

/// Whether text is written as a decimal, whatever its exponent.
bool is_decimal(const std::string& text) {
  const std::size_t e = text.find_first_of("eE");
  return proofs::parse_decimal(text.substr(0, e)) &&
         (e == std::string::npos || proofs::parse_decimal(text.substr(e + 1)));
}

/// One number of a list. What the chain would refuse is refused here, where the text is still known.
Rational parse_number(const std::string& text, const std::string& list, std::size_t i) {
  const auto refuse = [&](const std::string& why, const std::string& expected) {
    throw Error(list + ", entry " + std::to_string(i + 1),
                text.empty() ? "nothing" : files::shown(text) + why, expected);
  };
  auto value = proofs::parse_decimal(text);
  if (!value) refuse("", is_decimal(text) ? "an exponent from -100000 to 100000" : "a decimal number");
  if ((list.ends_with("lengths") || list.ends_with("link_length")) && *value <= 0)
    refuse(", which is not positive", "a positive length");
  if (list.ends_with("stiffness") && *value < 0) refuse(", which is negative", "zero (passive) or positive");
  return *std::move(value);
}

/// Collects text in which decimals that follow each other in a list become one string, joined by ';': a
/// parser takes its time, and a hundred bytes, for every entry.
class JoinedDecimals {
 public:
  void decimal(const std::string& digits) {
    if (open_ && std::count(gap_.begin(), gap_.end(), ',') == 1) {
      lines_.append(static_cast<std::size_t>(std::count(gap_.begin(), gap_.end(), '\n')), '\n');
      gap_.clear();
      text_ += ';';
    } else {
      close();
      text_ += "\"\\u0001";
      open_ = true;
    }
    text_ += digits;
  }
  void other(const std::string& token) {
    if (open_ && token.find_first_not_of(", \t\r\n") == std::string::npos) {
      gap_ += token;
    } else {
      close();
      text_ += token;
    }
  }
  std::string text() {
    close();
    return std::move(text_);
  }

 private:
  /// Everything keeps its line.
  void close() {
    if (open_) text_ += '"' + lines_ + gap_;
    open_ = false;
    lines_.clear();
    gap_.clear();
  }
  std::string text_, lines_, gap_;
  bool open_ = false;  ///< the last string, behind which the gap stands
};

/// The text with every bare decimal quoted: a TOML parser rounds numbers to double and refuses those that
/// overflow, but keeps strings as they are. What is in quotes or a comment already stays.
std::string quote_decimals(const std::string& text) {
  JoinedDecimals result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    if (text[at] == '#') {
      end = std::min(text.find('\n', at), text.size());
    } else if (text[at] == '"' || text[at] == '\'') {
      end = std::min(text.find_first_of({text[at], '\n'}, end), text.size() - 1) + 1;
    } else if (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '+' ||
               text[at] == '-') {
      const auto is_bare = [](unsigned char c) {
        return std::isalnum(c) != 0 || (c != 0 && std::strchr("+-._:", c));
      };
      while (end < text.size() && is_bare(static_cast<unsigned char>(text[end]))) ++end;
    }
    const std::string token = text.substr(at, end - at);
    std::string digits = token;
    std::erase(digits, '_');  // TOML groups digits with it
    is_decimal(digits) ? result.decimal(digits) : result.other(token);
    at = end;
  }
  return result.text();
}

}  // namespace

std::optional<std::string> decimals_in(const toml::node& node) {
  const auto text = node.value_exact<std::string>();
  return text && text->starts_with(bare) ? std::optional(text->substr(1)) : std::nullopt;
}

std::string as_written(const toml::node& node) {
  if (const auto decimals = decimals_in(node)) return files::shown(*decimals);
  std::ostringstream text;
  if (const auto word = node.value_exact<std::string>())
    text << (is_decimal(*word) ? '"' + *word + '"' : *word);
  else
    text << toml::node_view(node);
  return text.str().empty() ? "nothing" : files::shown(text.str());
}

/// The numbers of a text that joins them by ';', behind those before.
void add_joined(std::vector<Rational>& values, const std::string& field, const std::string& list) {
  for (std::size_t at = 0; at <= field.size();) {
    const std::size_t end = std::min(field.find(';', at), field.size());
    const std::size_t first = std::min(field.find_first_not_of(' ', at), end);
    const std::size_t last = field.find_last_not_of(' ', end - 1);
    values.push_back(parse_number(field.substr(first, last + 1 - first), list, values.size()));
    at = end + 1;
  }
}

std::vector<Rational> numbers_of(const toml::array& list, const std::string& name) {
  std::vector<Rational> values;
  for (const toml::node& item : list) {
    const auto decimals = decimals_in(item);
    if (!decimals)
      throw Error(name + ", entry " + std::to_string(values.size() + 1), as_written(item),
                  "a decimal number");
    add_joined(values, *decimals, name);
  }
  return values;
}

toml::table parse_decimal_toml(const std::string& text, const std::string& source) {
  return files::parse_toml(quote_decimals(text), source);
}

Rational number_of(const toml::node& node, const std::string& where) {
  const auto text = decimals_in(node);
  const auto value = text ? proofs::parse_decimal(*text) : std::nullopt;
  if (!value) throw Error(where, as_written(node), "a decimal number");
  return *value;
}

}  // namespace plumbline::statement
