#pragma once
/// \file
/// Runs the built executable as a user does, in an empty folder of its own.

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/folder.hpp"

inline const std::string sources = PLUMBLINE_SOURCE_DIR;

struct Outcome {
  int status;
  std::string out, err;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Bad input: status 2, nothing on standard output, one line that says what is wrong.
inline void check_refused(const Outcome& outcome) {
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.starts_with("plumbline: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

class Workplace : public Folder {
 public:
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(*this / name).rdbuf();
    return text.str();
  }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(*this / name); }
  /// How many files lie in the folder.
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(path());
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  /// `plumbline` with these arguments, as a shell reads them.
  [[nodiscard]] Outcome plumbline(const std::string& arguments) const {
    const Workplace streams;
    const std::string out = streams / "out", err = streams / "err";
    const int status = std::system(("cd '" + path().string() + "' && '" PLUMBLINE_EXECUTABLE "' >'" + out +
                                    "' 2>'" + err + "' </dev/null " + arguments)
                                       .c_str());
    return {WEXITSTATUS(status), streams.read("out"), streams.read("err")};
  }
};
