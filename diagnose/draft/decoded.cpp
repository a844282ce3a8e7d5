#include "diagnose/draft/decoded.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

void append(std::string& text, std::uint32_t point) {
  const auto more = [&](int shift) { text += static_cast<char>(0x80U | ((point >> shift) & 0x3FU)); };
  if (point < 0x80) {
    text += static_cast<char>(point);
  } else if (point < 0x800) {
    text += static_cast<char>(0xC0U | (point >> 6U)), more(0);
  } else if (point < 0x10000) {
    text += static_cast<char>(0xE0U | (point >> 12U)), more(6), more(0);
  } else {
    text += static_cast<char>(0xF0U | (point >> 18U)), more(12), more(6), more(0);
  }
}

std::string from_utf16(const std::string& bytes, std::size_t first, bool big) {
  const auto unit = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
    };
    return big ? byte(at) << 8U | byte(at + 1) : byte(at + 1) << 8U | byte(at);
  };
  std::string text;
  for (std::size_t at = first; at + 1 < bytes.size(); at += 2) {
    std::uint32_t point = unit(at);
    const bool pair = point >= 0xD800 && point < 0xDC00 && at + 3 < bytes.size();
    if (pair) point = 0x10000 + ((point - 0xD800) << 10U) + (unit(at += 2) - 0xDC00);
    append(text, point >= 0xD800 && point < 0xE000 ? 0xFFFD : point);
  }
  return text;
}

/// What Windows-1252 has at 0x80 to 0x9F; elsewhere its bytes are the first letters of Unicode.
constexpr std::array<std::uint16_t, 32> windows{
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

std::string from_windows(const std::string& bytes) {
  std::string text;
  for (const char one : bytes) {
    const auto byte = static_cast<unsigned char>(one);
    append(text, byte >= 0x80 && byte < 0xA0 ? windows.at(byte - 0x80U) : byte);
  }
  return text;
}

/// Whether nearly every second byte, from the first or from the second, is zero.
bool has_zeros(const std::string& bytes, std::size_t from) {
  std::size_t zeros = 0, all = 0;
  constexpr std::size_t enough = 2000;
  for (std::size_t at = from; at < std::min(bytes.size(), enough); at += 2, ++all)
    zeros += bytes[at] == '\0' ? 1 : 0;
  return all > 2 && 10 * zeros > 9 * all;
}

}  // namespace

Decoded decoded(const std::string& bytes) {
  if (bytes.starts_with("\xFF\xFE")) return {from_utf16(bytes, 2, false), "UTF-16"};
  if (bytes.starts_with("\xFE\xFF")) return {from_utf16(bytes, 2, true), "UTF-16"};
  if (has_zeros(bytes, 1)) return {from_utf16(bytes, 0, false), "UTF-16"};
  if (has_zeros(bytes, 0)) return {from_utf16(bytes, 0, true), "UTF-16"};
  if (files::first_bad_byte(bytes) == std::string::npos) return {bytes, ""};
  return {from_windows(bytes), "Windows-1252"};
}

}  // namespace plumbline::diagnose
