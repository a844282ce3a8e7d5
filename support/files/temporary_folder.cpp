#include "support/files/temporary_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <plumbline/base/error.hpp>
#include <random>
#include <thread>

namespace plumbline::files {
namespace {

namespace fs = std::filesystem;

fs::path new_name() {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  const char* wanted = std::getenv("TMPDIR");
  if (error) throw Error("TMPDIR", wanted ? wanted : "/tmp", "a folder for temporary files");
  std::random_device random;
  return folder / fmt::format("plumbline-{:08x}{:08x}", random(), random());
}

/// In the process that waits: removes the folder when the other one is dead, which closes the pipe.
[[noreturn]] void guard(int pipe, const fs::path& folder) {
  setsid();  // what interrupts the other process does not reach this one
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, nullptr);
  dup2(pipe, STDIN_FILENO);
  close_range(STDOUT_FILENO, ~0U, 0);
  char word = 0;
  ssize_t size = -1;
  while (size < 0) size = read(STDIN_FILENO, &word, 1);
  std::error_code ignored;
  for (int tries = 0; size == 0 && tries < 50; ++tries) {  // children may still be dying
    fs::remove_all(folder, ignored);
    if (!fs::exists(folder, ignored)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  _exit(0);
}

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(new_name()) {
  watch();
  if (mkdir(path_.c_str(), 0700) == 0) return;
  const int failure = errno;
  dismiss();
  throw Error(path_.string(), std::strerror(failure), "a new folder");
}

/// Before there is anything to remove, so that no moment is without a guard.
void TemporaryFolder::watch() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  guard_ = fork();
  if (guard_ == 0) guard(ends[0], path_);
  close(ends[0]);
  alive_ = ends[1];
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  dismiss();
}

void TemporaryFolder::dismiss() const {
  if (alive_ < 0) return;
  static_cast<void>(!write(alive_, "x", 1));  // nothing left to remove
  close(alive_);
  if (guard_ > 0) waitpid(guard_, nullptr, 0);
}

}  // namespace plumbline::files
