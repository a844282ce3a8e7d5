#pragma once
/// \file
/// The one exception of the library.
///
/// \code{.cpp}
/// try {
///   const Chain<double> wrong({0.3, -0.2}, {1, 1});
///   assert(false);
/// } catch (const Error& error) {
///   assert(std::string(error.what()) ==
///          "lengths, entry 2: found a value that is not positive, expected a positive length");
/// }
/// \endcode

#include <stdexcept>
#include <string>

namespace plumbline {

/// Input that cannot be computed with. `what()` is one line: the place, what was found, what was expected.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// In the form "place: found …, expected …".
  Error(const std::string& place, const std::string& found, const std::string& expected)
      : std::runtime_error(place + ": found " + found + ", expected " + expected) {}
};

}  // namespace plumbline
