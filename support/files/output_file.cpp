#include "support/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <plumbline/base/error.hpp>
#include <utility>

#include "support/files/file_identity.hpp"

namespace plumbline::files {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// False, with errno, when not all could be written.
bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t more = ::write(file, text.data() + done, text.size() - done);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return false;
    done += static_cast<std::size_t>(more);
  }
  return true;
}

/// Whether anything can be written at all: /dev/full and a closed descriptor refuse even nothing.
bool accepts(int file) {
  return ::write(file, "", 0) == 0;
}

/// Room for so many bytes. A file system that cannot say lets the writing find out.
bool reserve(int file, std::size_t size) {
  const int failure = posix_fallocate(file, 0, static_cast<off_t>(size));
  errno = failure;
  return failure == 0 || failure == EOPNOTSUPP || failure == EINVAL;
}

/// While a file gets its name, the process is not interrupted: that takes no time worth mentioning.
class Uninterrupted {
 public:
  Uninterrupted() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
  ~Uninterrupted() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(std::move(path)) {
  if (is_standard_output(path_)) {
    in_place_ = true;
    file_ = dup(STDOUT_FILENO);
    if (file_ < 0 || !accepts(file_)) fail(std::strerror(errno));
    return;
  }
  target_ = behind_links(path_);
  struct stat found = {};
  const bool exists = stat(target_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) fail("a directory");
  if (!exists && errno != ENOENT) fail(std::strerror(errno));
  if (exists && access(target_.c_str(), W_OK) != 0) fail(std::strerror(errno));
  in_place_ = exists && (!S_ISREG(found.st_mode) || found.st_nlink > 1 || found.st_uid != geteuid());
  if (in_place_) {
    open_in_place();
    return;
  }
  open_draft();
  constexpr std::size_t little = 4096;
  if (!reserve(file_, little) || ftruncate(file_, 0) != 0) fail(std::strerror(errno));
  if (exists) {
    static_cast<void>(fchown(file_, static_cast<uid_t>(-1), found.st_gid));  // not everyone may
    if (fchmod(file_, found.st_mode & 07777) != 0) fail(std::strerror(errno));
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) close(file_);
  if (!draft_.empty()) unlink(draft_.c_str());
}

void OutputFile::open_in_place() {
  file_ = open(target_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);  // a pipe without a reader does not hang
  if (file_ < 0) fail(errno == ENXIO ? "a pipe that nobody reads" : std::strerror(errno));
  fcntl(file_, F_SETFL, 0);
  if (!accepts(file_)) fail(std::strerror(errno));
}

void OutputFile::open_draft() {
  const fs::path folder = folder_of(target_);
  file_ = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ >= 0) return;
  if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) fail(std::strerror(errno));
  std::string name = (folder / ".plumbline-XXXXXX").string();
  file_ = mkostemp(name.data(), O_CLOEXEC);
  if (file_ < 0) fail(std::strerror(errno));
  draft_ = name;
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(file_, 0666 & ~mask);
}

void OutputFile::complete() {
  if (in_place_ || completed_) return;
  if (!write_all(file_, text_)) fail(std::strerror(errno));
  completed_ = true;
}

void OutputFile::commit() {
  complete();
  if (is_standard_output(path_)) std::fflush(stdout);  // what was printed before
  const Uninterrupted now;
  if (in_place_)
    write_in_place();
  else
    give_name();
  const int file = std::exchange(file_, -1);
  if (close(file) != 0) fail(std::strerror(errno));
}

/// Room is found before the first byte is lost.
void OutputFile::write_in_place() {
  struct stat found = {};
  const bool whole = fstat(file_, &found) == 0 && S_ISREG(found.st_mode) && !target_.empty();
  if (whole && !reserve(file_, text_.size())) {
    const int failure = errno;
    static_cast<void>(ftruncate(file_, found.st_size));
    fail(std::strerror(failure));
  }
  if (!write_all(file_, text_)) fail(std::strerror(errno));
  if (whole && ftruncate(file_, static_cast<off_t>(text_.size())) != 0) fail(std::strerror(errno));
}

void OutputFile::give_name() {
  if (draft_.empty()) {
    const std::string unnamed = fmt::format("/proc/self/fd/{}", file_);
    const auto link_as = [&](const fs::path& name) {
      return linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (link_as(target_)) return;
    if (errno != EEXIST) fail(std::strerror(errno));
    const fs::path name = folder_of(target_) / fmt::format(".plumbline-{}-{}", getpid(), file_);
    if (!link_as(name)) fail(std::strerror(errno));
    draft_ = name;
  }
  if (rename(draft_.c_str(), target_.c_str()) != 0) fail(std::strerror(errno));
  draft_.clear();
}

void OutputFile::fail(const std::string& found) const {
  throw Error(path_ == "-" ? "standard output" : path_.string(), found, "a file that can be written");
}

void write_text(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

void make_folder(const fs::path& path) {
  std::error_code error, ignored;
  fs::create_directories(path, error);
  if (!fs::is_directory(path, ignored))
    throw Error(path.string(), error ? error.message() : "no folder", "a folder, or a name to make one by");
}

void require_folder(const fs::path& path) {
  std::error_code error;
  fs::path nearest = path.empty() ? fs::path(".") : path;
  const auto missing = [&] { return fs::symlink_status(nearest, error).type() == fs::file_type::not_found; };
  while (missing() && nearest.has_relative_path()) nearest = folder_of(nearest);
  const bool folder = fs::is_directory(nearest, error);
  if (!folder || access(nearest.c_str(), W_OK | X_OK) != 0)
    throw Error(path.string(), folder ? std::strerror(errno) : "no folder",
                "a folder, or a name to make one by");
}

}  // namespace plumbline::files
