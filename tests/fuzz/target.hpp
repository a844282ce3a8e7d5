#pragma once
/// \file
/// What every reader promises of any bytes: it reads them, or throws an Error that is one line and names what
/// was found and what was expected. Anything else ends the program, and the fuzzer keeps the bytes.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <plumbline/base/error.hpp>
#include <string>

#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

/// \param read  of the text of a file "f", as read_text gives it
template <class Read>
int offer(const std::uint8_t* bytes, std::size_t size, const Read& read) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  try {
    plumbline::files::require_text(text, "f");
    read(text);
  } catch (const plumbline::Error& error) {
    const std::string line = error.what();
    const bool whole =
        line.find(": found ") != std::string::npos && line.find(", expected ") != std::string::npos;
    if (whole && plumbline::files::printable(line) == line && line.size() < 1000) return 0;
    std::fprintf(stderr, "an error that is not one short line with found and expected: %s\n", line.c_str());
    std::abort();
  }
  return 0;
}
