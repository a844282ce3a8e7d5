#include "files/text_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <plumbline/base/error.hpp>
#include <sstream>

namespace plumbline::files {
namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw Error(path.string(), "a directory", "a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Error(path.string(), std::strerror(errno), "a file that can be read");
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw Error(path.string(), "a failure while reading", "a file that can be read");
  if (text.str().find_first_not_of(" \t\r\n") == std::string::npos)
    throw Error(path.string(), "an empty file", "some content");
  return text.str();
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!std::filesystem::is_directory(path))
    throw Error(path.string(), error ? error.message() : "no folder", "a folder, or a name to make one by");
}

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (path_ == "-") return;
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) fail("a directory");
  target_ = fs::weakly_canonical(path_, ignored);
  if (target_.empty()) target_ = path_;
  const bool device = fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored);
  const bool refused = fs::exists(target_, ignored) && access(target_.c_str(), W_OK) != 0;
  if (refused) fail(std::strerror(errno));
  written_ = device ? target_ : fs::path(target_.string() + ".part" + std::to_string(getpid()));
  stream_.open(written_, std::ios::binary);
  if (!stream_) fail(std::strerror(errno));
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (written_ != target_) fs::remove(written_, ignored);
}

void OutputFile::write(const std::string& text) {
  (path_ == "-" ? std::cout : stream_) << text;
}

void OutputFile::commit() {
  if (path_ == "-") {
    if (!std::cout.flush()) fail("a failure while writing");
    return;
  }
  stream_.close();
  if (!stream_) fail("a failure while writing");
  std::error_code error;
  if (written_ != target_) fs::rename(written_, target_, error);
  if (error) fail(error.message());
  written_ = target_;
}

void OutputFile::fail(const std::string& found) const {
  throw Error(path_ == "-" ? "standard output" : path_.string(), found, "a file that can be written");
}

void write_text(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace plumbline::files
