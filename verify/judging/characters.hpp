#pragma once
/// \file
/// Characters of a sentence, looked at one by one.

#include <cctype>
#include <string>

namespace plumbline::verify {

inline bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
inline bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The character at a place; a space before the first and behind the last.
inline char at(const std::string& text, std::size_t place) {
  return place < text.size() ? text[place] : ' ';
}

/// The end of the run of letters, or of digits, that begins at a place.
inline std::size_t end_of_run(const std::string& text, std::size_t place, bool (*belongs)(char)) {
  while (place < text.size() && belongs(text[place])) ++place;
  return place;
}

}  // namespace plumbline::verify
