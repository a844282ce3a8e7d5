#pragma once
/// \file
/// The text in the bytes of a file, whatever wrote it.

#include <string>

namespace plumbline::diagnose {

struct Decoded {
  std::string text;      ///< UTF-8
  std::string encoding;  ///< "UTF-16", "Windows-1252"; empty where it was UTF-8 already
};

/// UTF-8, UTF-16 by its byte order mark or its zeros, else Windows-1252, in which each byte is a letter.
Decoded decoded(const std::string& bytes);

}  // namespace plumbline::diagnose
