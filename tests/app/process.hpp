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

struct Outcome {
  int status;
  std::string out, err;
};

/// Bad input: status 2, nothing on standard output, one line that says what is wrong.
inline void check_refused(const Outcome& outcome) {
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.starts_with("plumbline: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

class Workplace {
 public:
  Workplace() {
    std::string pattern = std::filesystem::temp_directory_path() / "plumbline-XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  /// How many files lie in the folder.
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// `plumbline` with these arguments, as a shell reads them.
  [[nodiscard]] Outcome plumbline(const std::string& arguments) const {
    const Workplace streams;
    const std::string out = streams.folder() / "out", err = streams.folder() / "err";
    const int status = std::system(("cd '" + folder_.string() + "' && '" PLUMBLINE_EXECUTABLE "' >'" + out +
                                    "' 2>'" + err + "' </dev/null " + arguments)
                                       .c_str());
    return {WEXITSTATUS(status), streams.read("out"), streams.read("err")};
  }

 private:
  std::filesystem::path folder_;
};
