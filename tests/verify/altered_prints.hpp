#pragma once
/// \file
/// What a claim could have printed otherwise: every digit, sign, coefficient, symbol, function, word and
/// place of its print changed, one at a time.

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

#include "verify/judging/claim.hpp"

struct AlteredPrint {
  std::string what;  ///< "digit", "sign", "coefficient", "symbol", "function", "word", "order", "list"
  plumbline::verify::Printed printed;
};

/// The texts that differ from one in a single mark, and what mark.
inline std::vector<std::pair<std::string, std::string>> altered_text(const std::string& text,
                                                                     const std::vector<std::string>& words,
                                                                     const std::set<std::string>& symbols) {
  std::vector<std::pair<std::string, std::string>> found;
  const auto with = [&](std::size_t at, std::size_t length, const std::string& other) {
    return text.substr(0, at) + other + text.substr(at + length);
  };
  for (const std::string& word : words) {
    if (std::find(words.begin(), words.end(), text) != words.end() && word != text)
      found.emplace_back("word", word);
  }
  if (!found.empty()) return found;
  const bool decimal = std::regex_match(text, std::regex("-?\\d+(\\.\\d+)?"));
  const bool zero = text.find_first_not_of("0.") == std::string::npos;  // has no sign
  const bool row_of_signs = text.find_first_not_of("+-") == std::string::npos;
  if (!zero && !row_of_signs &&
      (decimal || std::isalnum(static_cast<unsigned char>(text[0])) != 0 || text[0] == '-' || text[0] == '('))
    found.emplace_back("sign", text[0] == '-' ? text.substr(1) : "-" + text);
  if (row_of_signs) found.emplace_back("sign", (text[0] == '-' ? "+" : "-") + text.substr(1));
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool in_name = i > 0 && std::isalpha(static_cast<unsigned char>(text[i - 1])) != 0;
    if (i > 0 && (c == '+' || c == '-')) found.emplace_back("sign", with(i, 1, c == '+' ? "-" : "+"));
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 && (decimal || !in_name)) {
      const int digit = c - '0';
      found.emplace_back(decimal ? "digit" : "coefficient", with(i, 1, std::to_string((digit + 1) % 10)));
      if (decimal) found.emplace_back("digit", with(i, 1, std::to_string((digit + 9) % 10)));
    }
  }
  static const std::regex names("[A-Za-z][A-Za-z0-9]*");
  for (std::sregex_iterator name(text.begin(), text.end(), names), end; name != end; ++name) {
    const std::string one = name->str();
    const auto at = static_cast<std::size_t>(name->position());
    if (one == "sin" || one == "cos" || one == "min" || one == "max") {
      found.emplace_back("function", with(at, 3,
                                          one == "sin"   ? "cos"
                                          : one == "cos" ? "sin"
                                          : one == "min" ? "max"
                                                         : "min"));
      continue;
    }
    const auto next = std::upper_bound(symbols.begin(), symbols.end(), one);
    const std::string other = next == symbols.end() ? *symbols.begin() : *next;
    if (other != one && symbols.contains(one)) found.emplace_back("symbol", with(at, one.size(), other));
  }
  return found;
}

/// All of a claim's, none twice and none the print itself.
inline std::vector<AlteredPrint> altered_prints(const plumbline::verify::Claim& claim) {
  const plumbline::verify::Printed& printed = claim.printed;
  static const std::set<std::string> functions{"sin", "cos", "min", "max", "atan2", "inv", "pinv"};
  static const std::regex names("[A-Za-z][A-Za-z0-9]*");
  std::set<std::string> symbols;
  for (const std::string& text : printed) {
    for (std::sregex_iterator name(text.begin(), text.end(), names), end; name != end; ++name)
      if (!functions.contains(name->str())) symbols.insert(name->str());
  }
  std::vector<AlteredPrint> all;
  std::set<plumbline::verify::Printed> seen{printed};
  const auto add = [&](const std::string& what, plumbline::verify::Printed other) {
    if (seen.insert(other).second) all.push_back({what, std::move(other)});
  };
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (const auto& [what, text] : altered_text(printed[i], claim.words, symbols)) {
      plumbline::verify::Printed other = printed;
      other[i] = text;
      add(what, std::move(other));
    }
    plumbline::verify::Printed fewer = printed;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    add("list", std::move(fewer));
    if (i == 0) continue;
    plumbline::verify::Printed swapped = printed;
    std::swap(swapped[i - 1], swapped[i]);
    add("order", std::move(swapped));
  }
  plumbline::verify::Printed more = printed;
  more.push_back(printed.back());
  add("list", std::move(more));
  return all;
}
