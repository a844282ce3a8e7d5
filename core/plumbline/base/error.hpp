#pragma once
/// \file
/// The one exception of the library.

#include <stdexcept>
#include <string>

namespace plumbline {

/// Input that cannot be computed with. `what()` is one line: the place, what was found, what was expected.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Error(const std::string& place, const std::string& found, const std::string& expected)
      : std::runtime_error(place + ": found " + found + ", expected " + expected) {}
};

}  // namespace plumbline
