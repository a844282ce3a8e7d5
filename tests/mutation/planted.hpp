#pragma once
/// \file
/// Which planted fault a process runs with, and which ones it came by. The tool puts this in front of every
/// file.

#include <array>
#include <cstdlib>
#include <string>

namespace mutation {

inline const int chosen = [] {
  const char* number = std::getenv("PLUMBLINE_PLANTED");
  return number != nullptr ? std::atoi(number) : -1;
}();
inline const bool recording = std::getenv("PLUMBLINE_REACHED") != nullptr;

inline std::array<bool, 1 << 16> reached{};

/// Whether fault number `fault` is to happen here.
inline bool planted(int fault) {
  if (recording) reached[static_cast<std::size_t>(fault)] = true;
  return fault == chosen;
}

}  // namespace mutation
