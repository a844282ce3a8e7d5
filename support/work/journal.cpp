#include "support/work/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <plumbline/base/error.hpp>
#include <sstream>
#include <utility>

#include "support/files/printable.hpp"
#include "support/files/sha256.hpp"

namespace plumbline::work {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "plumbline-unfinished/1";

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string header_of(const std::string& work) {
  return Json{{"format", format}, {"program", files::sha256(content("/proc/self/exe"))}, {"work", work}}
      .dump();
}

/// The text that a line of JSON holds under a key; nothing where it is no such line.
std::optional<std::string> text_in(const Json& line, const char* key) {
  if (!line.is_object() || !line.contains(key) || !line[key].is_string()) return std::nullopt;
  return line[key].get<std::string>();
}

}  // namespace

std::map<std::string, std::string> unfinished_results(const std::string& text, const std::string& header,
                                                      const std::string& source) {
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const Json begun = Json::parse(line, nullptr, false);
  if (text_in(begun, "format") != format) throw Error(source, "no unfinished work", "some, or no such file");
  if (line != header) {
    const auto work = text_in(begun, "work");
    const bool same = work == text_in(Json::parse(header), "work");
    const std::string whose =
        same ? "another build of this program" : '"' + files::shown(work.value_or("")) + '"';
    throw Error(source, "the unfinished work of " + whose,
                "the same work to go on with; remove the file to begin anew");
  }
  std::map<std::string, std::string> results;
  while (std::getline(lines, line)) {
    const Json one = Json::parse(line, nullptr, false);
    const auto item = text_in(one, "item"), result = text_in(one, "result");
    if (item && result) results[*item] = *result;
  }
  return results;
}

Journal::Journal(std::filesystem::path file, const std::string& work) : path_(std::move(file)) {
  const std::string header = header_of(work);
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) refuse(std::strerror(errno), "a file that can be written");
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      refuse("a file that another process works with", "one process at a time");
    read(header);
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() {
  close(file_);
}

void Journal::read(const std::string& header) {
  const std::string text = content(path_);
  const std::size_t whole = text.rfind('\n') + 1;  // npos + 1 is 0
  if (whole < text.size() && ftruncate(file_, static_cast<off_t>(whole)) != 0)
    refuse(std::strerror(errno), "a file that can be written");
  if (whole == 0) return write_line(header);
  results_ = unfinished_results(text.substr(0, whole), header, path_.string());
}

const std::string* Journal::find(const std::string& item) const {
  const auto found = results_.find(files::sha256(item));
  return found == results_.end() ? nullptr : &found->second;
}

void Journal::add(const std::string& item, const std::string& result) {
  write_line(Json{{"item", files::sha256(item)}, {"result", result}}.dump());
}

/// One call, so that no other line comes between.
void Journal::write_line(const std::string& line) {
  const std::string text = line + "\n";
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t more = write(file_, text.data() + done, text.size() - done);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) refuse(std::strerror(errno), "a file that can be written");
    done += static_cast<std::size_t>(more);
  }
}

void Journal::finish() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void Journal::refuse(const std::string& found, const std::string& expected) const {
  throw Error(path_.string(), found, expected);
}

}  // namespace plumbline::work
