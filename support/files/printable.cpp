#include "support/files/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>
#include <plumbline/base/error.hpp>

namespace plumbline::files {
namespace {

namespace utf = boost::locale::utf;

/// The character at `at`, which moves behind it; by one byte where there is none.
utf::code_point next(std::string_view text, std::size_t& at) {
  const char* here = text.data() + at;
  const utf::code_point c = utf::utf_traits<char>::decode(here, text.data() + text.size());
  const bool bad = c == utf::illegal || c == utf::incomplete;
  at = bad ? at + 1 : static_cast<std::size_t>(here - text.data());
  return bad ? utf::illegal : c;
}

bool in(utf::code_point c, utf::code_point first, utf::code_point last) {
  return first <= c && c <= last;
}

/// Controls, line and paragraph separators, and what turns the direction of writing.
bool unseen(utf::code_point c) {
  return c < 0x20 || in(c, 0x7f, 0x9f) || in(c, 0x2028, 0x202e) || in(c, 0x2066, 0x2069) ||
         in(c, 0x200e, 0x200f) || c == 0x61c || c == 0xfeff;
}

}  // namespace

std::size_t first_bad_byte(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    const utf::code_point c = next(text, at);
    if (c == utf::illegal || c == 0) return start;
  }
  return std::string_view::npos;
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    const utf::code_point c = next(text, at);
    if (c == utf::illegal)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[start]));
    else if (unseen(c))
      result += c < 0x80 ? fmt::format("\\x{:02x}", c) : fmt::format("\\u{:04x}", c);
    else
      result += text.substr(start, at - start);
  }
  return result;
}

std::string shown(std::string_view text) {
  constexpr std::size_t most = 80;
  std::string result = printable(text.substr(0, std::min(text.size(), 4 * most)));
  if (result.size() <= most && text.size() <= 4 * most) return result;
  std::size_t end = std::min(result.size(), most - 3);
  while (end > 0 && (static_cast<unsigned char>(result[end]) & 0xc0) == 0x80) --end;  // no half character
  return result.substr(0, end) + "...";
}

void require_printable(const std::string& text, const std::string& place) {
  if (printable(text) != text) throw Error(place, shown(text), "text in UTF-8 without control characters");
}

void require_name(const std::string& name, const std::string& place) {
  constexpr std::size_t most = 200;
  require_printable(name, place);
  if (name.size() > most)
    throw Error(place, fmt::format("a name of {} bytes, {}", name.size(), shown(name)),
                fmt::format("at most {}", most));
}

std::string text_of(const std::filesystem::path& path) {
  if (first_bad_byte(path.string()) != std::string::npos)
    throw Error(path.string(), "a name that is no text", "UTF-8");
  return path.string();
}

}  // namespace plumbline::files
