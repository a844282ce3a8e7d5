#include "support/files/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <plumbline/base/error.hpp>
#include <utility>
#include <vector>

#include "support/files/printable.hpp"
#include "support/files/read_bytes.hpp"

namespace plumbline::files {
namespace {

/// A descriptor, closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

std::string all_of(int file, const std::string& name) {
  std::string text;
  std::vector<char> block(std::size_t{1} << 16);
  while (true) {
    const ssize_t size = read(file, block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw Error(name, std::strerror(errno), "a file that can be read");
    if (size == 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
    if (text.size() > largest_file)
      throw Error(name, "more than " + std::to_string(largest_file >> 20) + " MB", "a smaller file");
  }
}

/// What can be read but once, kept for whoever reads it again.
const std::string& kept(int file, const std::string& name) {
  static std::mutex one_at_a_time;
  static std::map<std::pair<dev_t, ino_t>, std::string> texts;
  const std::lock_guard lock(one_at_a_time);
  struct stat found = {};
  fstat(file, &found);
  const std::pair which{found.st_dev, found.st_ino};
  const auto known = texts.find(which);
  return known != texts.end() ? known->second : texts.emplace(which, all_of(file, name)).first->second;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) {
  const std::string name = source_name(path);
  if (is_standard_input(path)) return kept(STDIN_FILENO, name);
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));  // no waiting for a writer
  struct stat found = {};
  if (file.number() < 0 || fstat(file.number(), &found) != 0)
    throw Error(name, std::strerror(errno), "a file that can be read");
  if (S_ISDIR(found.st_mode)) throw Error(name, "a directory", "a file");
  if (!S_ISREG(found.st_mode) && !S_ISFIFO(found.st_mode)) throw Error(name, "a device", "a file");
  fcntl(file.number(), F_SETFL, 0);
  return S_ISFIFO(found.st_mode) ? kept(file.number(), name) : all_of(file.number(), name);
}

std::string read_text(const std::filesystem::path& path) {
  std::string text = read_bytes(path);
  require_text(text, source_name(path));
  return text;
}

bool is_standard_input(const std::filesystem::path& path) {
  return path == "-";
}

std::string source_name(const std::filesystem::path& path) {
  return is_standard_input(path) ? "standard input" : path.string();
}

void require_text(const std::string& text, const std::string& source) {
  const std::size_t content =
      text.starts_with("\xEF\xBB\xBF") ? 3 : 0;  // the byte order mark of spreadsheets
  if (text.find_first_not_of(" \t\r\n", content) == std::string::npos)
    throw Error(source, "an empty file", "some content");
  const std::size_t bad = first_bad_byte(text);
  if (bad == std::string::npos) return;
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n');
  throw Error(source + ":" + std::to_string(line), "the byte " + printable(text.substr(bad, 1)),
              "text in UTF-8");
}

}  // namespace plumbline::files
